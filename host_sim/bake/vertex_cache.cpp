#include "host_sim/bake/vertex_cache.hpp"

#include <algorithm>
#include <tuple>

namespace spangle::bake {

std::size_t cache_misses(const IndexList& indices, unsigned entries) {
    std::vector<std::uint32_t> entry(entries, unused);
    std::size_t misses = 0;
    for (const std::uint32_t index : indices)
        if (std::uint32_t& kept = entry[index % entries]; kept != index) {
            kept = index;
            ++misses;
        }
    return misses;
}

namespace {

/// Lists the triangles at each vertex.
struct AdjacentTriangles {
    std::vector<std::size_t> first;
    std::vector<std::size_t> triangle;

    AdjacentTriangles(const IndexList& triangles, std::size_t vertices)
        : first(vertices + 1, 0), triangle(triangles.size()) {
        for (const std::uint32_t v : triangles)
            ++first[v + 1];
        for (std::size_t v = 0; v < vertices; ++v)
            first[v + 1] += first[v];
        std::vector<std::size_t> next(first.begin(), first.end() - 1);
        for (std::size_t i = 0; i < triangles.size(); ++i)
            triangle[next[triangles[i]]++] = i / 3;
    }
};

class TriangleOrder {
  public:
    TriangleOrder(const IndexList& triangles, std::size_t vertices, unsigned entries)
        : triangles_(triangles), adjacent_triangles_(triangles, vertices), cache_size_(entries),
          triangles_left_(vertices, 0), cache_time_(vertices, 0), is_emitted_(triangles.size() / 3, false),
          clock_(entries + 1u) {
        for (const std::uint32_t v : triangles)
            ++triangles_left_[v];
    }

    IndexList run() {
        ordered_.reserve(triangles_.size());
        for (std::uint32_t at = triangles_.empty() ? unused : triangles_[0]; at != unused;) {
            candidates_.clear();
            for (std::size_t i = adjacent_triangles_.first[at]; i < adjacent_triangles_.first[at + 1]; ++i)
                emit_triangle(adjacent_triangles_.triangle[i]);
            at = next_vertex();
        }
        return std::move(ordered_);
    }

  private:
    void emit_triangle(std::size_t triangle) {
        if (is_emitted_[triangle])
            return;
        is_emitted_[triangle] = true;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t v = triangles_[3 * triangle + c];
            ordered_.push_back(v);
            candidates_.push_back(v);
            dead_end_stack_.push_back(v);
            --triangles_left_[v];
            if (clock_ - cache_time_[v] > cache_size_)
                cache_time_[v] = clock_++;
        }
    }

    /// The next vertex around which triangles are drawn: of the last fan, the one that came first into the
    /// cache and will still be there when its triangles are done. Otherwise it is a vertex seen lately.
    std::uint32_t next_vertex() {
        std::uint32_t best = unused;
        std::size_t best_age = 0;
        for (const std::uint32_t v : candidates_)
            if (triangles_left_[v] > 0) {
                const std::size_t age = clock_ - cache_time_[v], needed = 2 * std::size_t{triangles_left_[v]};
                const std::size_t score = age + needed <= cache_size_ ? age + 1 : 1;
                if (score > best_age) {
                    best_age = score;
                    best = v;
                }
            }
        return best != unused ? best : after_dead_end();
    }

    std::uint32_t after_dead_end() {
        for (; !dead_end_stack_.empty(); dead_end_stack_.pop_back())
            if (triangles_left_[dead_end_stack_.back()] > 0)
                return dead_end_stack_.back();
        for (; cursor_ < triangles_left_.size(); ++cursor_)
            if (triangles_left_[cursor_] > 0)
                return static_cast<std::uint32_t>(cursor_);
        return unused;
    }

    const IndexList& triangles_;
    AdjacentTriangles adjacent_triangles_;
    unsigned cache_size_;
    std::vector<std::uint32_t>
        triangles_left_;                  ///< for each vertex, the number of its triangles not drawn yet
    std::vector<std::size_t> cache_time_; ///< for each vertex, the moment at which it came into the cache
    std::vector<bool> is_emitted_;
    std::size_t clock_, cursor_ = 0;
    std::vector<std::uint32_t> candidates_, dead_end_stack_;
    IndexList ordered_;
};

/// Builds strips that continue from triangle to triangle across the edge through which the strip leaves.
class StripBuilder {
    static constexpr std::size_t most_asked = 32;

  public:
    StripBuilder(const IndexList& triangles, std::size_t reach)
        : triangles_(triangles), search_range_(reach), is_used_(triangles.size() / 3, false) {
        for (std::size_t t = 0; t < is_used_.size(); ++t)
            for (std::size_t c = 0; c < 3; ++c)
                edges_.push_back({corner(t, c), corner(t, c + 1), t});
        std::sort(edges_.begin(), edges_.end());
    }

    IndexList run() {
        for (std::size_t t = 0; t < is_used_.size(); ++t)
            if (!is_used_[t])
                append(longest_from(t));
        return std::move(ordered_);
    }

  private:
    struct Edge {
        std::uint32_t from, to;
        std::size_t triangle;
        bool operator<(const Edge& other) const {
            return std::tie(from, to, triangle) < std::tie(other.from, other.to, other.triangle);
        }
    };

    std::uint32_t corner(std::size_t t, std::size_t c) const { return triangles_[3 * t + c % 3]; }

    /// The unused triangle up to `last` whose edge runs from `from` to `to`, and its third vertex `apex`.
    std::size_t across(std::uint32_t from, std::uint32_t to, std::size_t last, std::uint32_t& apex) const {
        // A surface has one triangle at an edge and direction. Where thousands share one, only the first few
        // are looked at, or time would grow with the square of their number.
        std::size_t asked = 0;
        for (auto e = std::lower_bound(edges_.begin(), edges_.end(), Edge{from, to, 0});
             e != edges_.end() && e->from == from && e->to == to && e->triangle <= last && asked < most_asked;
             ++e, ++asked)
            if (!is_used_[e->triangle])
                for (std::size_t c = 0; c < 3; ++c)
                    if (corner(e->triangle, c) == from && corner(e->triangle, c + 1) == to) {
                        apex = corner(e->triangle, c + 2);
                        return e->triangle;
                    }
        return is_used_.size();
    }

    /// Builds a strip from this corner on, as long as there is an unused neighbour, and marks its triangles
    /// as used.
    IndexList follow_strip(std::size_t t, std::size_t c, std::vector<std::size_t>& taken) {
        IndexList strip{corner(t, c), corner(t, c + 1), corner(t, c + 2)};
        taken.assign(1, t);
        is_used_[t] = true;
        for (;;) {
            const std::uint32_t a = strip[strip.size() - 2], b = strip.back();
            const bool odd = (strip.size() & 1) != 0; // the next triangle's number in the strip is odd
            std::uint32_t apex = 0;
            const std::size_t next =
                odd ? across(b, a, t + search_range_, apex) : across(a, b, t + search_range_, apex);
            if (next == is_used_.size())
                return strip;
            is_used_[next] = true;
            taken.push_back(next);
            strip.push_back(apex);
        }
    }

    IndexList longest_from(std::size_t t) {
        IndexList best;
        std::vector<std::size_t> taken, best_taken;
        for (std::size_t c = 0; c < 3; ++c) {
            IndexList strip = follow_strip(t, c, taken);
            for (const std::size_t undone : taken)
                is_used_[undone] = false;
            if (strip.size() > best.size()) {
                best.swap(strip);
                best_taken.swap(taken);
            }
        }
        for (const std::size_t done : best_taken)
            is_used_[done] = true;
        return best;
    }

    /// Appends a strip. An even number of indices stands before it, so that its first triangle keeps its
    /// winding.
    void append(const IndexList& strip) {
        if (!ordered_.empty()) {
            ordered_.push_back(ordered_.back());
            ordered_.push_back(strip.front());
            if ((ordered_.size() & 1) != 0)
                ordered_.push_back(strip.front());
        }
        ordered_.insert(ordered_.end(), strip.begin(), strip.end());
    }

    const IndexList& triangles_;
    std::size_t search_range_;
    std::vector<bool> is_used_;
    std::vector<Edge> edges_;
    IndexList ordered_;
};

} // namespace

IndexList order_triangles(const IndexList& triangles, std::size_t vertices, unsigned entries) {
    return TriangleOrder(triangles, vertices, entries).run();
}

std::vector<std::uint32_t> first_use_order(const IndexList& indices, std::size_t vertices) {
    std::vector<std::uint32_t> place(vertices, unused);
    std::uint32_t next = 0;
    for (const std::uint32_t index : indices)
        if (place[index] == unused)
            place[index] = next++;
    return place;
}

IndexList make_strip(const IndexList& triangles, std::size_t reach) {
    return StripBuilder(triangles, reach).run();
}

} // namespace spangle::bake

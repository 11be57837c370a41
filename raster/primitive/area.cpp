#include "raster/primitive/area.hpp"

#include "raster/numeric/reciprocal.hpp"

namespace spangle::raster {

bool RowEdge::enter(const OutlinePoint& from, const OutlinePoint& to, std::int32_t row) {
    goes_down_ = from.y > to.y;
    const OutlinePoint &a = goes_down_ ? to : from, &b = goes_down_ ? from : to;
    const std::int32_t bottom = row * outline_one, top = bottom + outline_one;
    const std::int32_t y0 = a.y > bottom ? a.y : bottom, y1 = b.y < top ? b.y : top;
    if (y0 >= y1)
        return false;
    // The rows above and below a boundary round x there to the same number. |y - a.y| and |dx| are below
    // 2^27.
    const auto at = [&](std::int32_t y) {
        constexpr int up = 16 - outline_bits;
        if (y == a.y || y == b.y)
            return (y == a.y ? a.x : b.x) * (1 << up);
        const std::int64_t along = std::int64_t{y - a.y} * (b.x - a.x) * (1 << up);
        return a.x * (1 << up) +
               static_cast<std::int32_t>(numeric::quotient(along, static_cast<std::uint32_t>(b.y - a.y)));
    };
    lower_x_ = at(y0);
    upper_x_ = at(y1);
    height_ = y1 - y0;
    return true;
}

inline std::int64_t RowEdge::beyond(std::int32_t column) const {
    const std::int64_t u = lower_x_ - std::int64_t{column} * (1 << 16),
                       v = upper_x_ - std::int64_t{column} * (1 << 16);
    if (u <= 0 && v <= 0)
        return 0;
    if (u >= 0 && v >= 0)
        return (u + v) * height_;
    const std::int64_t positive = u > 0 ? u : v;
    // The difference fits a word, because both ends are words.
    const auto width = static_cast<std::uint32_t>(u > 0 ? u - v : v - u);
    return numeric::quotient(positive * positive, width) * height_; // the area of a triangle
}

void RowEdge::add(std::int32_t begin, std::int32_t end, std::int64_t* change) const {
    std::int32_t x = first() < begin ? begin : first();
    if (x >= end)
        return;
    const std::int32_t reached = last() < end ? last() + 1 : end;
    const std::int64_t whole = height_ * std::int64_t{2 << 16};
    std::int64_t before = 0;
    const auto put = [&](std::int64_t area) {
        change[x - begin] += goes_down_ ? before - area : area - before;
        before = area;
    };
    if (x == first() && x == last()) // most edges lie in one column
        put(whole - std::int64_t{(lower_x_ & 0xFFFF) + (upper_x_ & 0xFFFF)} * height_), ++x;
    else if (x < reached)
        for (std::int64_t here = beyond(x); x < reached; ++x) {
            const std::int64_t next = beyond(x + 1);
            put(next - here + whole);
            here = next;
        }
    if (x < end)
        put(whole);
}

AreaRow::AreaRow(const Outline& outline, std::int32_t row)
    : outline_(outline), first_unstored_edge_(outline.count), row_(row) {
    struct {
        std::int32_t first = INT32_MAX, last = INT32_MIN;
    } side[2];
    if (outline.count == 0)
        return;
    OutlinePoint from = outline[0];
    for (int i = 0; i < outline.count; ++i) {
        const OutlinePoint to = outline[i + 1];
        RowEdge edge;
        if (edge.enter(from, to, row)) {
            auto& own = side[edge.down() ? 1 : 0];
            own.first = edge.first() < own.first ? edge.first() : own.first;
            own.last = edge.last() > own.last ? edge.last() : own.last;
            if (edge_count_ < stored_edges)
                edge_[edge_count_++] = edge;
            else if (i < first_unstored_edge_)
                first_unstored_edge_ = i;
        }
        from = to;
    }
    if (edge_count_ == 0)
        return;
    const auto& left = side[side[1].first < side[0].first ? 1 : 0];
    const auto& right = side[side[1].first < side[0].first ? 0 : 1];
    first_column_ = left.first;
    last_column_ = left.last > right.last ? left.last : right.last;
    if (left.last + 1 < right.first) {
        core_begin_ = left.last + 1;
        core_end_ = right.first;
    }
}

void AreaRow::fill(std::int32_t begin, std::int32_t end, std::uint32_t* coverage) const {
    std::int64_t change[window] = {};
    const std::int32_t n = end - begin;
    for (int i = 0; i < edge_count_; ++i)
        edge_[i].add(begin, end, change);
    for (int i = first_unstored_edge_; i < outline_.count; ++i)
        if (RowEdge edge; edge.enter(outline_[i], outline_[i + 1], row_))
            edge.add(begin, end, change);
    std::int64_t sum = 0;
    for (std::int32_t i = 0; i < n; ++i) {
        sum += change[i];
        const std::uint64_t size = numeric::abs_u64(sum);
        coverage[i] = size < full_coverage ? static_cast<std::uint32_t>(size) : full_coverage;
    }
}

} // namespace spangle::raster

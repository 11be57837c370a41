#include "host_sim/trade/coverage.hpp"

#include <algorithm>
#include <cmath>

namespace spangle::trade {

namespace {

constexpr std::int64_t one = raster::subpixel_one;

/// Whether an edge owns the centres on it: left and bottom edges do (raster/primitive/edge.hpp). Vertices are
/// counter-clockwise, y points up.
bool owns_center(std::int64_t dx, std::int64_t dy) {
    return dy < 0 || (dy == 0 && dx > 0);
}

} // namespace

std::uint64_t count_differences(const std::vector<bool>& a, const std::vector<bool>& b) {
    std::uint64_t n = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        n += a[i] != b[i] ? 1 : 0;
    return n;
}

Coverage::Coverage(int width, int height)
    : width_(width), height_(height),
      hit_count_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      covered_mask_(hit_count_.size()), frame_{covered_mask_, covered_mask_} {
    triangle = [](Observer& self, const std::int32_t x[3], const std::int32_t y[3], const double* ex,
                  const double* ey,
                  Rect scissor) { static_cast<Coverage&>(self).begin(x, y, ex, ey, scissor); };
    other = [](Observer& self) { static_cast<Coverage&>(self).close_triangle(); };
    span = [](Observer& self, std::int32_t y, std::int32_t from, std::int32_t to) {
        static_cast<Coverage&>(self).add(y, from, to);
    };
}

void Coverage::begin(const std::int32_t x[3], const std::int32_t y[3], const double* exact_x,
                     const double* exact_y, Rect scissor) {
    close_triangle();
    triangle_.open = true;
    triangle_.scissor = scissor;
    triangle_.has_exact = exact_x != nullptr;
    const std::int64_t area = (std::int64_t{x[1]} - x[0]) * (std::int64_t{y[2]} - y[0]) -
                              (std::int64_t{x[2]} - x[0]) * (std::int64_t{y[1]} - y[0]);
    for (int i = 0; i < 3; ++i) { // makes the vertices counter-clockwise
        const int from = area < 0 ? 2 - i : i;
        triangle_.x[i] = x[from];
        triangle_.y[i] = y[from];
        if (triangle_.has_exact) {
            triangle_.exact_x[i] = exact_x[from];
            triangle_.exact_y[i] = exact_y[from];
        }
    }
}

void Coverage::add(std::int32_t y, std::int32_t from, std::int32_t to) {
    for (std::int32_t x = from; x < to; ++x) {
        covered_mask_[static_cast<std::size_t>((height_ - 1 - y) * width_ + x)] = true;
        if (triangle_.open)
            ++hit_count_[static_cast<std::size_t>(y * width_ + x)];
    }
}

bool Coverage::is_inside(std::int64_t px, std::int64_t py) const {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const std::int64_t dx = triangle_.x[j] - triangle_.x[i], dy = triangle_.y[j] - triangle_.y[i];
        const std::int64_t e = dx * (py - triangle_.y[i]) - dy * (px - triangle_.x[i]);
        if (e < 0 || (e == 0 && !owns_center(dx, dy)))
            return false;
    }
    return true;
}

bool Coverage::inside_exact(double px, double py) const {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const double dx = triangle_.exact_x[j] - triangle_.exact_x[i],
                     dy = triangle_.exact_y[j] - triangle_.exact_y[i];
        const double e = dx * (py - triangle_.exact_y[i]) - dy * (px - triangle_.exact_x[i]);
        // A centre so close to an edge counts as on the edge.
        const double on_edge = 1e-9 * (std::fabs(dx) + std::fabs(dy));
        if (e < -on_edge || (e <= on_edge && !(dy < 0.0 || (dy == 0.0 && dx > 0.0))))
            return false;
    }
    return true;
}

void Coverage::close_triangle() {
    if (!triangle_.open)
        return;
    triangle_.open = false;
    const auto [left, right] = std::minmax({triangle_.x[0], triangle_.x[1], triangle_.x[2]});
    const auto [low, high] = std::minmax({triangle_.y[0], triangle_.y[1], triangle_.y[2]});
    const Rect& s = triangle_.scissor;
    const auto cut = [](std::int64_t v, std::int64_t least, std::int64_t most) {
        return static_cast<int>(std::clamp(v, least, most));
    };
    const int x0 = cut(left / one - 1, s.x, s.x + s.w), x1 = cut(right / one + 2, s.x, s.x + s.w);
    const int y0 = cut(low / one - 1, s.y, s.y + s.h), y1 = cut(high / one + 2, s.y, s.y + s.h);
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            std::uint8_t& hits = hit_count_[static_cast<std::size_t>(y * width_ + x)];
            const bool wanted = is_inside(x * one + one / 2, y * one + one / 2);
            mismatches_ += hits != (wanted ? 1 : 0) ? 1 : 0;
            if (wanted)
                frame_.snapped[static_cast<std::size_t>(y * width_ + x)] = true;
            if (triangle_.has_exact ? inside_exact(x + 0.5, y + 0.5) : wanted)
                frame_.exact[static_cast<std::size_t>(y * width_ + x)] = true;
            hits = 0;
        }
}

FrameCoverage Coverage::end_frame() {
    close_triangle();
    const std::vector<bool> empty(covered_mask_.size());
    FrameCoverage out{empty, empty};
    std::swap(out, frame_);
    return out;
}

std::vector<bool> Coverage::take_mask() {
    std::vector<bool> out(covered_mask_.size());
    out.swap(covered_mask_);
    return out;
}

} // namespace spangle::trade

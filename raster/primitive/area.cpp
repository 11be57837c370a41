#include "raster/primitive/area.hpp"

#include "raster/numeric/reciprocal.hpp"

namespace spangle::raster {

bool RowEdge::enter(const OutlinePoint& from, const OutlinePoint& to, std::int32_t row) {
    down_ = from.y > to.y;
    const OutlinePoint &a = down_ ? to : from, &b = down_ ? from : to;
    const std::int32_t bottom = row * outline_one, top = bottom + outline_one;
    const std::int32_t y0 = a.y > bottom ? a.y : bottom, y1 = b.y < top ? b.y : top;
    if (y0 >= y1)
        return false;
    // Both rows beside a boundary round alike there. |y - a.y| and |dx| < 2^27.
    const auto at = [&](std::int32_t y) {
        constexpr int up = 16 - outline_bits;
        const std::int64_t along = std::int64_t{y - a.y} * (b.x - a.x) * (1 << up);
        return a.x * (1 << up) +
               static_cast<std::int32_t>(numeric::quotient(along, static_cast<std::uint32_t>(b.y - a.y)));
    };
    low_ = at(y0);
    high_ = at(y1);
    height_ = y1 - y0;
    return true;
}

std::int64_t RowEdge::beyond(std::int32_t column) const {
    const std::int64_t u = low_ - std::int64_t{column} * (1 << 16),
                       v = high_ - std::int64_t{column} * (1 << 16);
    if (u <= 0 && v <= 0)
        return 0;
    if (u >= 0 && v >= 0)
        return (u + v) * height_;
    const std::int64_t positive = u > 0 ? u : v;
    const auto width = static_cast<std::uint32_t>(u > 0 ? u - v : v - u); // low_ and high_ are words
    return numeric::quotient(positive * positive, width) * height_;       // a triangle
}

AreaRow::AreaRow(const Outline& outline, std::int32_t row)
    : outline_(outline), unkept_(outline.count), row_(row) {
    for (int i = 0; i < outline.count; ++i) {
        RowEdge edge;
        if (!edge.enter(outline[i], outline[i + 1], row))
            continue;
        first_ = edge.first() < first_ ? edge.first() : first_;
        last_ = edge.last() > last_ ? edge.last() : last_;
        if (edges_ < kept_edges)
            edge_[edges_++] = edge;
        else if (i < unkept_)
            unkept_ = i;
    }
}

template <class Found> void AreaRow::each(Found found) const {
    for (int i = 0; i < edges_; ++i)
        if (!found(edge_[i]))
            return;
    for (int i = unkept_; i < outline_.count; ++i)
        if (RowEdge edge; edge.enter(outline_[i], outline_[i + 1], row_) && !found(edge))
            return;
}

std::uint32_t AreaRow::coverage(std::int32_t column) const {
    std::int64_t sum = 0;
    each([&](const RowEdge& edge) {
        sum += edge.covers(column);
        return true;
    });
    const std::uint64_t size = numeric::abs_u64(sum);
    return size < full_coverage ? static_cast<std::uint32_t>(size) : full_coverage;
}

std::int32_t AreaRow::plain_end(std::int32_t column) const {
    std::int32_t end = last_ + 1;
    each([&](const RowEdge& edge) {
        const bool here = column >= edge.first() && column <= edge.last();
        if (here)
            end = column;
        else if (edge.first() > column && edge.first() < end)
            end = edge.first();
        return !here;
    });
    return end;
}

} // namespace spangle::raster

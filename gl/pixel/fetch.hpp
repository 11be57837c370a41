// Pixels of the framebuffer as groups, before pixel transfer (GL 1.3, 4.3.2).
#pragma once

#include <bit>

#include "gl/pixel/group.hpp"
#include "gl/pixel/targets.hpp"
#include "raster/surface/pixel.hpp"

namespace spangle::gl {

/// k / max, max = 2^bits - 1.
constexpr Component fraction(std::uint32_t k, std::uint32_t max) {
    return {k, static_cast<std::uint8_t>(std::bit_width(max))};
}

/// The surface that is read, to be asked for its rows one after the other.
class ReadRows {
  public:
    explicit ReadRows(const Context& context)
        : recording_(context.drawable.recording), rows_(read_surface(context)) {
        all_ = rows_.area();
        if (recording_ != nullptr)
            rows_.first_row = rows_.end_row = 0; // none is there yet
    }

    /// All pixels, whether or not they are there now.
    const Rect& area() const { return all_; }

    /// With row y, which is one of them; null where it cannot be had. Until the next call.
    const raster::Surface* with_row(std::int32_t y) {
        if (recording_ == nullptr)
            return &rows_;
        if (y < rows_.first_row || y >= rows_.end_row)
            rows_ = recording_->rows(y);
        return y < rows_.first_row || y >= rows_.end_row ? nullptr : &rows_;
    }

  private:
    const Recording* recording_;
    raster::Surface rows_;
    Rect all_;
};

inline Pixel fetch_color(const raster::Surface& surface, std::int32_t x, std::int32_t y) {
    const raster::StoredColor stored = raster::read_color(surface, x, y);
    Pixel pixel;
    for (int i = 0; i < 4; ++i)
        pixel.value[i] = fraction(stored.c[i].k, stored.c[i].max);
    return pixel;
}

/// Behind pixel transfer; an index becomes a colour by the maps (GL 1.3, 4.3.2).
inline Pixel transferred_color(const raster::Surface& surface, const Transfer& transfer, std::int32_t x,
                               std::int32_t y) {
    if (raster::drawn_indexed(surface.format))
        return transfer.color_of(whole_index(raster::read_index(surface, x, y)));
    Pixel pixel = fetch_color(surface, x, y);
    transfer.apply(pixel);
    return pixel;
}

inline Component fetch_depth(const raster::Surface& surface, std::int32_t x, std::int32_t y) {
    const raster::StoredDepth stored = raster::read_depth(surface, x, y);
    return fraction(stored.k, stored.max);
}

} // namespace spangle::gl

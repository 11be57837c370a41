// Pixels of the framebuffer as groups (GL 1.3, 4.3.2).
#pragma once

#include "gl/pixel/group.hpp"
#include "gl/pixel/targets.hpp"

namespace spangle::gl {

/// The surface that is read, to be asked for its rows one after the other.
class ReadRows {
  public:
#if SPANGLE_HAS_RECORDS
    explicit ReadRows(const Context& context)
        : recording_(context.drawable.recording), rows_(read_surface(context)), all_(rows_.area()) {
        if (recording_ != nullptr)
            rows_.first_row = rows_.end_row = 0; // none is there yet
    }

    /// All pixels, whether or not they are there now.
    const Rect& area() const {
        return all_;
    }

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
#else // all are there
    explicit ReadRows(const Context& context) : rows_(read_surface(context)) {}

    Rect area() const {
        return rows_.area();
    }
    const raster::Surface* with_row(std::int32_t) const {
        return &rows_;
    }

  private:
    const raster::Surface& rows_;
#endif
};

/// The groups are the colours that the surface holds.
inline bool keeps_colors(const raster::Surface& surface, const Transfer& transfer, Content content) {
    return content == Content::color && !raster::drawn_indexed(surface.format) && !transfer.changes_colors();
}

/// The group of a pixel behind pixel transfer. On a surface of indices a colour is what the maps make of one
/// (GL 1.3, 4.3.2).
Group fetch(const raster::Surface& surface, const Transfer& transfer, Content content, std::int32_t x,
            std::int32_t y);

} // namespace spangle::gl

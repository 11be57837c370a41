// Pixels of the framebuffer as groups (GL 1.3, 4.3.2).
#pragma once

#include "gl/pixel/group.hpp"
#include "gl/pixel/targets.hpp"

namespace spangle::gl {

/// Gives the read surface row by row; a recorded frame has only one band in memory at a time.
class ReadRows {
  public:
#if SPANGLE_HAS_RECORDS
    explicit ReadRows(const Context& context)
        : recording_(context.drawable.recording), row_surface_(read_surface(context)),
          bounds_(row_surface_.area()) {
        if (recording_ != nullptr)
            row_surface_.first_row = row_surface_.end_row = 0; // no row is in memory yet
    }

    /// All pixels of the surface, in memory or not.
    const Rect& area() const {
        return bounds_;
    }

    /// Returns the surface with row y of area() in memory, or null if the recorded frame cannot give that
    /// row. The result is valid until the next call.
    const raster::Surface* with_row(std::int32_t y) {
        if (recording_ == nullptr)
            return &row_surface_;
        if (y < row_surface_.first_row || y >= row_surface_.end_row)
            row_surface_ = recording_->rows(y);
        return y < row_surface_.first_row || y >= row_surface_.end_row ? nullptr : &row_surface_;
    }

  private:
    const Recording* recording_;
    raster::Surface row_surface_;
    Rect bounds_;
#else // all rows are in memory
    explicit ReadRows(const Context& context) : row_surface_(read_surface(context)) {}

    Rect area() const {
        return row_surface_.area();
    }
    const raster::Surface* with_row(std::int32_t) const {
        return &row_surface_;
    }

  private:
    const raster::Surface& row_surface_;
#endif
};

/// Whether groups are read as the surface stores them, because they are colours that pixel transfer does not
/// change.
inline bool keeps_colors(const raster::Surface& surface, const Transfer& transfer, Content content) {
    return content == Content::color && !raster::drawn_indexed(surface.format) && !transfer.changes_colors();
}

/// The group of a pixel after pixel transfer. On a surface of colour indices, the maps from indices to
/// colours give the colour (GL 1.3, 4.3.2).
PixelGroup fetch(const raster::Surface& surface, const Transfer& transfer, Content content, std::int32_t x,
                 std::int32_t y);

} // namespace spangle::gl

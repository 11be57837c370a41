// Pixel rectangles: groups of a client image or of the framebuffer, zoomed, become fragments (GL 1.3, 3.6.4).
// Stencil values go straight into the buffer (4.3.1).
#pragma once

#include "gl/pixel/group.hpp"
#include "gl/pixel/row_converter.hpp"
#include "gl/pixel/zoom.hpp"
#include "raster/primitive/draw.hpp"

namespace spangle::gl {

struct Context;

/// The number of fragments that are converted at a time, and the form that these fragments are converted to.
inline constexpr std::int32_t rectangle_chunk = 64;
union RectangleRow {
    std::uint32_t color[4 * rectangle_chunk]; ///< colour units, or an index in the place of red
    std::uint16_t words[rectangle_chunk + raster::pixel_room]; ///< R5 G6 B5, with padding at the end
    std::uint32_t depth[rectangle_chunk];                      ///< depths in Q0.30
    std::uint8_t stencil[rectangle_chunk];
};

/// Which member of RectangleRow is used.
enum class RowForm : std::uint8_t { color, words, index, depth, stencil };

/// The source of groups. The members say what the groups hold, and which columns `n` and rows `m` of groups
/// exist.
struct GroupSource {
    using GroupOf = PixelGroup (*)(const GroupSource& source, std::int32_t n, std::int32_t m);
    GroupSource(GroupOf of, Content content_of, const Interval& columns, const Interval& rows)
        : group(of), content(content_of), n(columns), m(rows) {}

    GroupOf group;
    Content content;
    Interval n, m;
#if SPANGLE_ROW_CODES
    /// A function that returns the bytes of `count` groups from (n, m) on, with at most row_chunk groups. The
    /// pointer is null if transfer may change colours.
    using Groups = const std::uint8_t* (*)(const GroupSource& source, std::int32_t n, std::int32_t m,
                                           std::int32_t count);
    Groups groups = nullptr;
    GroupForm form; ///< layout of the bytes that `groups` returns
#endif
};

struct RectangleOrder {
    bool from_right = false, from_top = false; ///< directions in which an overlapping copy is safe
};

/// Draws a rectangle at the raster position with PixelZoom. `colors` says what the source's colours are.
void draw_rectangle(Context& context, const GroupSource& source, raster::Colors colors, RectangleOrder order);

/// Whether DrawPixels, CopyPixels or Bitmap has anything to draw. In feedback mode, feeds back `token` and
/// the raster position (GL 1.3, 5.3).
bool raster_position_draws(Context& context, GLenum token);

} // namespace spangle::gl

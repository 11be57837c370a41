// Pixel rectangles: groups of a client image or of the framebuffer, zoomed, as fragments (GL 1.3, 3.6.4) or,
// those of stencil, straight into the buffer (4.3.1).
#pragma once

#include "gl/pixel/group.hpp"
#include "gl/pixel/row_converter.hpp"
#include "gl/pixel/zoom.hpp"
#include "raster/primitive/draw.hpp"

namespace spangle::gl {

struct Context;

/// What the groups of a row become, some fragments at a time.
inline constexpr std::int32_t rectangle_chunk = 64;
union RectangleRow {
    std::uint32_t color[4 * rectangle_chunk]; ///< colour units, or an index in the place of red
    std::uint16_t words[rectangle_chunk + raster::pixel_room]; ///< R5 G6 B5, with room behind the last one
    std::uint32_t depth[rectangle_chunk];                      ///< Q0.30
    std::uint8_t stencil[rectangle_chunk];
};

/// Which of them.
enum class RowForm : std::uint8_t { color, words, index, depth, stencil };

/// Where the groups come from, what they are, and which there are.
struct GroupSource {
    using GroupOf = Group (*)(const GroupSource& source, std::int32_t n, std::int32_t m);
    GroupSource(GroupOf of, Content content_of, const Interval& columns, const Interval& rows)
        : group(of), content(content_of), n(columns), m(rows) {}

    GroupOf group;
    Content content;
    Interval n, m;
#if SPANGLE_ROW_CODES
    /// The bytes of `count` groups from (n, m) on, at most row_chunk, where no group changes its colour; or
    /// null.
    using Groups = const std::uint8_t* (*)(const GroupSource& source, std::int32_t n, std::int32_t m,
                                           std::int32_t count);
    Groups groups = nullptr;
    GroupForm form; ///< of these
#endif
};

struct RectangleOrder {
    bool from_right = false, from_top = false; ///< so that what is copied is read before it is written
};

/// At the raster position, with PixelZoom. `colors` is what the colours of the source are.
void draw_rectangle(Context& context, const GroupSource& source, raster::Colors colors, RectangleOrder order);

/// DrawPixels, CopyPixels and Bitmap: whether there is something to draw. Feedback gets `token` and the
/// raster position (GL 1.3, 5.3).
bool raster_position_draws(Context& context, GLenum token);

} // namespace spangle::gl

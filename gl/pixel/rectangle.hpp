// Pixel rectangles: groups of a client image or of the framebuffer, zoomed, as fragments (GL 1.3, 3.6.4) or,
// those of stencil, straight into the buffer (4.3.1).
#pragma once

#include "gl/pixel/group.hpp"
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

/// Behind pixel transfer, as the form says: a colour, a depth in the place of red, or an index.
struct Group {
    Pixel color;
    Index index;
};

/// Where the groups come from, and which there are.
struct GroupSource {
    Group (*group)(const GroupSource& source, RowForm form, std::int32_t n, std::int32_t m);
    struct Interval {
        std::int32_t begin, end;
    } n, m;
};

struct RectangleOrder {
    bool from_right = false, from_top = false; ///< so that what is copied is read before it is written
};

/// At the raster position, with PixelZoom. `colors` is what the colours of the source are.
void draw_rectangle(Context& context, const GroupSource& source, Content content, raster::Colors colors,
                    RectangleOrder order);

/// DrawPixels, CopyPixels and Bitmap: whether there is something to draw. Feedback gets `token` and the
/// raster position (GL 1.3, 5.3).
bool raster_position_draws(Context& context, GLenum token);

/// `group` of a source with color(n, m), index(n, m), depth(n, m) and stencil(n, m).
template <class Source>
Group group_of(const GroupSource& base, RowForm form, std::int32_t n, std::int32_t m) {
    const auto& source = static_cast<const Source&>(base);
    Group group;
    if (form == RowForm::depth)
        group.color.value[0] = source.depth(n, m);
    else if (form == RowForm::stencil)
        group.index = source.stencil(n, m);
    else if (raster::has_indices && form == RowForm::index)
        group.index = source.index(n, m);
    else
        group.color = source.color(n, m);
    return group;
}

} // namespace spangle::gl

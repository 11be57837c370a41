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

/// Where the groups come from, and which there are.
struct GroupSource {
    /// Row m, `count` fragments along `n`.
    void (*fill)(const GroupSource& source, RowForm form, std::int32_t m, ZoomAxis::Walk n,
                 std::int32_t count, RectangleRow& out);
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

/// `fill` of a source with color(n, m), index(n, m), depth(n, m) and stencil(n, m), behind pixel transfer. A
/// group that covers several fragments is looked at once.
template <class Source>
void fill_groups(const GroupSource& base, RowForm form, std::int32_t m, ZoomAxis::Walk n, std::int32_t count,
                 RectangleRow& out) {
    const auto& source = static_cast<const Source&>(base);
    const auto each = [&](auto put) {
        std::int32_t last = -1;
        for (std::int32_t i = 0; i < count; ++i, n.step()) {
            put(i, n.group(), n.group() == last);
            last = n.group();
        }
    };
    switch (form) {
    case RowForm::color:
        return each([&](std::int32_t i, std::int32_t group, bool again) {
            std::uint32_t* const to = out.color + 4 * i;
            if (!again) {
                const Pixel pixel = source.color(group, m);
                for (int c = 0; c < 4; ++c)
                    to[c] = color_units_of(pixel.value[c]);
            } else {
                for (int c = 0; c < 4; ++c)
                    to[c] = to[c - 4];
            }
        });
    case RowForm::words:
        return each([&](std::int32_t i, std::int32_t group, bool again) {
            if (again) {
                out.words[i] = out.words[i - 1];
                return;
            }
            const Pixel pixel = source.color(group, m);
            out.words[i] = static_cast<std::uint16_t>(code_of(pixel.value[0], 8) >> 3 << 11 |
                                                      code_of(pixel.value[1], 8) >> 2 << 5 |
                                                      code_of(pixel.value[2], 8) >> 3);
        });
    case RowForm::index:
        if constexpr (SPANGLE_FEATURE_COLOR_INDEX)
            each([&](std::int32_t i, std::int32_t group, bool again) {
                std::uint32_t* const to = out.color + 4 * i;
                to[0] =
                    again ? to[-4]
                          : index_units(source.index(group, m), format_info(PixelFormat::index8).index_bits);
                to[1] = to[2] = to[3] = 0;
            });
        return;
    case RowForm::depth:
        return each([&](std::int32_t i, std::int32_t group, bool again) {
            out.depth[i] = again ? out.depth[i - 1] : steps_of(source.depth(group, m), raster::depth_one);
        });
    case RowForm::stencil:
        return each([&](std::int32_t i, std::int32_t group, bool again) {
            out.stencil[i] =
                again ? out.stencil[i - 1] : static_cast<std::uint8_t>(rounded(source.stencil(group, m)));
        });
    }
}

} // namespace spangle::gl

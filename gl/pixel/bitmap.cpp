// Bitmap (GL 1.3, 3.7).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_BITMAPS

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "gl/pixel/group.hpp"
#include "gl/pixel/rectangle.hpp"
#include "gl/pixel/targets.hpp"
#include "gl/vertex/engine.hpp"

namespace spangle::gl {

namespace {

/// Yields the 1 bits of a bitmap as fragments, in horizontal runs.
struct BitRuns : raster::PixelSource {
    const unsigned char* first; ///< first byte of the lowest row
    ImageRows rows;
    bool lsb_first;
    std::int32_t left, low;  ///< window position of bit (0, 0)
    Interval columns, lines; ///< window columns and rows where fragments may be drawn
};

void emit(raster::PixelSource& source, raster::PixelSink& sink) {
    const auto& bits = static_cast<const BitRuns&>(source);
    for (std::int32_t y = bits.lines.begin; y < bits.lines.end; ++y) {
        const unsigned char* const row =
            bits.first + static_cast<std::size_t>(y - bits.low) * bits.rows.stride;
        const auto is_set = [&](std::int32_t x) {
            return bit_of(row, bits.rows.skip_bits + static_cast<std::size_t>(x - bits.left), bits.lsb_first);
        };
        for (std::int32_t x = bits.columns.begin; x < bits.columns.end; ++x) {
            const std::int32_t begin = x;
            while (x < bits.columns.end && is_set(x))
                ++x;
            if (begin < x)
                sink.run(sink, y, begin, x, nullptr);
        }
    }
}

void draw(Context& context, GLsizei width, GLsizei height, Real xorig, Real yorig, const GLubyte* bitmap) {
    PixelLayout layout;
    static_cast<void>(pixel_layout(GL_COLOR_INDEX, GL_BITMAP, layout));
    const PixelStore& unpack = context.pixel_store.unpack;
    const Real* const at = context.current.raster.position;
    const Rect clip = drawing_rect(context);
    const ImageRows rows = image_rows(unpack, layout, width);
    const raster::DrawState& state = draw_state(context);
    // Each bit covers a square of the size of a pixel, which the raster position places. With multisampling,
    // a bit's fragment gets the samples that lie in the square. Without multisampling, the fragment is the
    // pixel that contains the square's lower left corner.
    const bool samples = multisampling(context);
    const auto ahead = [samples](std::int32_t shift) { return samples ? shift * 16 + ((1 << 11) - 1) : 0; };
    each_target(context, [&](const raster::Surface& target, raster::Position shift) {
        const std::int32_t left = whole_pixels(at[0], xorig, ahead(shift.x)),
                           low = whole_pixels(at[1], yorig, ahead(shift.y));
        BitRuns bits{{emit},
                     bitmap + rows.skip,
                     rows,
                     unpack.lsb_first,
                     left,
                     low,
                     clip_interval(left, width, clip.x, clip.x + clip.w),
                     clip_interval(low, height, clip.y, clip.y + clip.h)};
        context.engine->pixels(context, state, target, bits);
    });
}

} // namespace

/// Moves the raster position if it is valid, even when no bits are drawn.
void cmd::Bitmap(Context& context, GLsizei width, GLsizei height, Real xorig, Real yorig, Real xmove,
                 Real ymove, const GLubyte* bitmap) {
    if (width < 0 || height < 0)
        return error(context, GL_INVALID_VALUE);
    if (!context.current.raster.valid)
        return;
    if (raster_position_draws(context, GL_BITMAP_TOKEN) && bitmap != nullptr)
        draw(context, width, height, xorig, yorig, bitmap);
    Real* const at = context.current.raster.position;
    at[0] = numeric::add(at[0], xmove);
    at[1] = numeric::add(at[1], ymove);
}

} // namespace spangle::gl

#endif

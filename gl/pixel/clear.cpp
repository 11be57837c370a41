// Clear (GL 1.3, 4.2.3).
#include <spangle/raster/clear.hpp>

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "gl/pixel/index.hpp"
#include "raster/band/record.hpp"
#include "raster/surface/accum.hpp"
#include "raster/surface/samples.hpp"

namespace spangle::gl::cmd {

namespace {

/// Clears the accumulation buffer. Of the fragment operations only the scissor test applies.
void clear_accum([[maybe_unused]] const Context& context, [[maybe_unused]] const spangle::Rect& area) {
#if SPANGLE_FEATURE_ACCUM
    if (context.drawable.surface.accum == nullptr)
        return;
    raster::AccumRequest request;
    request.area = area;
    // A component of the accumulation buffer is k / 32767. Clear values halfway between two such numbers are
    // rounded away from zero.
    for (int c = 0; c < 4; ++c)
        request.clear[c] = static_cast<std::int16_t>(numeric::to_i32_round(
            numeric::mul(context.fragment_ops.accum_clear[c], numeric::from_i32(raster::accum_one))));
#if SPANGLE_HAS_RECORDS
    if (context.drawable.recording != nullptr)
        return context.drawable.recording->record->accum(request);
#endif
    raster::clear_accum(context.drawable.surface, area, request.clear);
#endif
}

} // namespace

void Clear(Context& context, GLbitfield mask) {
    constexpr GLbitfield known =
        GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT;
    if ((mask & ~known) != 0)
        return error(context, GL_INVALID_VALUE, SPANGLE_TEXT("mask has a bit that is no buffer"));
    if (!context.render.draws())
        return; // selection and feedback do not change the framebuffer (GL 1.3, 5.2)
    const FragmentOpsState& ops = context.fragment_ops;
    raster::ClearRequest request;
    request.area = drawing_rect(context);
    request.channels = (mask & GL_COLOR_BUFFER_BIT) != 0 ? written_channels(context) : std::uint8_t{0};
    request.dither = ops.dither;
    request.depth = (mask & GL_DEPTH_BUFFER_BIT) != 0 && ops.depth_mask;
    request.stencil_mask = (mask & GL_STENCIL_BUFFER_BIT) != 0
                               ? static_cast<std::uint8_t>(ops.stencil[0].write_mask)
                               : std::uint8_t{0};
    if (is_indexed(context.drawable))
        request.color[0] = index_units(ops.index_clear, context.drawable.index_bits);
    else
        for (int c = 0; c < 4; ++c)
            request.color[c] = color_units(ops.color_clear[c]);
    request.z = static_cast<std::uint32_t>(numeric::to_fixed(ops.depth_clear, 30));
    request.stencil = static_cast<std::uint8_t>(ops.stencil_clear);
#if SPANGLE_HAS_RECORDS
    if (context.drawable.recording != nullptr)
        context.drawable.recording->record->clear(request);
    else
#endif
        raster::clear_samples(context.drawable.surface, request);
    if ((mask & GL_ACCUM_BUFFER_BIT) != 0)
        clear_accum(context, request.area);
}

} // namespace spangle::gl::cmd

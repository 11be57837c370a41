// The accumulation buffer (GL 1.3, 4.2.4).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "gl/pixel/targets.hpp"
#include "raster/band/record.hpp"

namespace spangle::gl::cmd {

namespace {

#if SPANGLE_HAS_RECORDS

raster::AccumRequest::Op op_of(GLenum op) {
    using Op = raster::AccumRequest::Op;
    switch (op) {
    case GL_ACCUM:
        return Op::accumulate;
    case GL_LOAD:
        return Op::load;
    case GL_MULT:
        return Op::multiply;
    case GL_ADD:
        return Op::add;
    default:
        return Op::give_back; // RETURN
    }
}

/// For bands that come later. What is read is what is drawn to.
raster::AccumRequest request_of(const Context& context, GLenum op, Real value) {
    raster::AccumRequest request;
    request.op = op_of(op);
    request.area = drawing_rect(context);
    request.value =
        numeric::to_fixed(value, op == GL_RETURN ? raster::accum_return_bits : raster::accum_value_bits);
    request.channels = written_channels(context);
    request.dither = context.fragment_ops.dither;
    return request;
}

#endif

/// What two areas have in common; empty where it is nothing.
spangle::Rect common(const spangle::Rect& a, const spangle::Rect& b) {
    const auto later = [](std::int32_t v, std::int32_t w) { return v > w ? v : w; };
    const auto sooner = [](std::int32_t v, std::int32_t w) { return v < w ? v : w; };
    const std::int32_t x = later(a.x, b.x), y = later(a.y, b.y);
    return {x, y, sooner(a.x + a.w, b.x + b.w) - x, sooner(a.y + a.h, b.y + b.h) - y};
}

} // namespace

void Accum(Context& context, GLenum op, Real value) {
    if (op < GL_ACCUM || op > GL_ADD)
        return error(context, GL_INVALID_ENUM);
    const raster::Surface& surface = context.drawable.surface;
    if (surface.accum == nullptr || context.drawable.index_bits != 0)
        return error(
            context, GL_INVALID_OPERATION,
            SPANGLE_TEXT("glAccum: this surface has no accumulation buffer; see EGL_ACCUM_SIZE_SPANGLE"));
    if (!context.render.draws())
        return; // the framebuffer does not change (GL 1.3, 5.2)
#if SPANGLE_HAS_RECORDS
    if (context.drawable.recording != nullptr)
        return context.drawable.recording->record->accum(request_of(context, op, value));
#endif
    const spangle::Rect area = drawing_rect(context);
    const std::int32_t v = numeric::to_fixed(value, raster::accum_value_bits);
    switch (op) {
    case GL_ACCUM:
    case GL_LOAD: {
        const raster::Surface& read = read_surface(context);
        return raster::accumulate(surface, common(area, read.area()), read, v, op == GL_LOAD);
    }
    case GL_MULT:
        return raster::multiply_accum(surface, area, v);
    case GL_ADD:
        return raster::add_accum(surface, area, v);
    default: // RETURN
        return raster::each_sample(surface, [&](const raster::Surface& sample, unsigned) {
            raster::return_accum(sample, area, numeric::to_fixed(value, raster::accum_return_bits),
                                 written_channels(context), context.fragment_ops.dither);
        });
    }
}

void ClearAccum(Context& context, Real red, Real green, Real blue, Real alpha) {
    const Real given[4] = {red, green, blue, alpha};
    for (int c = 0; c < 4; ++c)
        context.fragment_ops.accum_clear[c] = given[c] < -numeric::one  ? -numeric::one
                                              : numeric::one < given[c] ? numeric::one
                                                                        : given[c];
}

} // namespace spangle::gl::cmd

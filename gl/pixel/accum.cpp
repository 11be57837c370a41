// The accumulation buffer (GL 1.3, 4.2.4).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "gl/pixel/targets.hpp"
#include "raster/band/record.hpp"

namespace spangle::gl::cmd {

namespace {

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

} // namespace

void Accum(Context& context, GLenum op, Real value) {
    if (op < GL_ACCUM || op > GL_ADD)
        return error(context, GL_INVALID_ENUM);
    const raster::Surface& surface = context.drawable.surface;
    if (surface.accum == nullptr || is_indexed(context.drawable))
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("this surface has no accumulation buffer; see EGL_ACCUM_SIZE_SPANGLE"));
    if (!context.render.draws())
        return; // the framebuffer does not change (GL 1.3, 5.2)
    const raster::AccumRequest request = request_of(context, op, value);
#if SPANGLE_HAS_RECORDS
    if (context.drawable.recording != nullptr)
        return context.drawable.recording->record->accum(request);
#endif
    raster::accum(surface, request, context.drawable.read);
}

void ClearAccum(Context& context, Real red, Real green, Real blue, Real alpha) {
    const Real given[4] = {red, green, blue, alpha};
    for (int c = 0; c < 4; ++c)
        context.fragment_ops.accum_clear[c] = given[c] < -numeric::one  ? -numeric::one
                                              : numeric::one < given[c] ? numeric::one
                                                                        : given[c];
}

} // namespace spangle::gl::cmd

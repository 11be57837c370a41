// The accumulation buffer (GL 1.3, 4.2.4).
#include <iterator>

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "gl/pixel/targets.hpp"
#include "raster/band/record.hpp"

namespace spangle::gl::cmd {

namespace {

using AccumOp = raster::AccumRequest::Op;

/// The accumulation operations, in the order of their tokens. ACCUM comes first.
constexpr AccumOp accum_ops[] = {AccumOp::accumulate, AccumOp::load, AccumOp::give_back, AccumOp::multiply,
                                 AccumOp::add};

constexpr bool is_accum_op(GLenum op) {
    return op - GL_ACCUM < std::size(accum_ops);
}
constexpr AccumOp accum_op_of(GLenum op) {
    return accum_ops[op - GL_ACCUM];
}
static_assert(accum_op_of(GL_ACCUM) == AccumOp::accumulate && accum_op_of(GL_LOAD) == AccumOp::load &&
              accum_op_of(GL_RETURN) == AccumOp::give_back && accum_op_of(GL_MULT) == AccumOp::multiply &&
              accum_op_of(GL_ADD) == AccumOp::add && !is_accum_op(GL_ADD + 1));

raster::AccumRequest request_of(const Context& context, GLenum op, Real value) {
    raster::AccumRequest request;
    request.op = accum_op_of(op);
    request.area = drawing_rect(context);
    request.value =
        numeric::to_fixed(value, op == GL_RETURN ? raster::accum_return_bits : raster::accum_value_bits);
    request.channels = written_channels(context);
    request.dither = context.fragment_ops.dither;
    return request;
}

} // namespace

void Accum(Context& context, GLenum op, Real value) {
    if (!is_accum_op(op))
        return error(context, GL_INVALID_ENUM);
    const raster::Surface& surface = context.drawable.surface;
    if (surface.accum == nullptr || is_indexed(context.drawable))
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("this surface has no accumulation buffer; see EGL_ACCUM_SIZE_SPANGLE"));
    if (!context.render.draws())
        return; // selection and feedback do not change the framebuffer (GL 1.3, 5.2)
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

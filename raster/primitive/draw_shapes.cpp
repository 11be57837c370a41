#include <spangle/raster/features.hpp>

#if SPANGLE_FEATURE_MULTISAMPLE

#include "raster/primitive/shapes.hpp"

namespace spangle::raster {

template <>
void draw_disc<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex& v,
                            std::int32_t eighths) {
    draw_disc_of<Fixed>(state, target, v, eighths);
}

template <>
void draw_line_rectangle<FixedVertex>(const DrawState& state, const Surface& target, const FixedVertex& a,
                                      const FixedVertex& b, const FixedVertex& provoking,
                                      std::int32_t eighths, LineStipple* stipple) {
    draw_line_rectangle_of<Fixed>(state, target, a, b, provoking, eighths, stipple);
}

} // namespace spangle::raster

#endif

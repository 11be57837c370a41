#include "raster/ops/stage_guess.hpp"

#include "raster/ops/stage_store.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

std::uint32_t divided_word(Span<Fixed>& span, std::int32_t x, std::int32_t y) {
    if (span.guess.project != nullptr)
        span.guess.project(span);
    span.guess.project = nullptr;
    const auto at = [&](const Span<Fixed>::Projective& plane) {
        return plane.at(x - span.anchor_x, y - span.anchor_y);
    };
    const Inverse inverse(unguarded(at(span.q)));
    const auto component = [&](int i) {
        return inner::projective_color(unguarded(at(span.color_q[has_full ? i : 0])), inverse);
    };
    const Exact::Color c = {component(0), component(1), component(2), color_one};
    return span.state->fragment.dither ? dithered565<Exact>(c, dither_threshold(dither_row(y), x))
                                       : truncated565<Exact>(c);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster

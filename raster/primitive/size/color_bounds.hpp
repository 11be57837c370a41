// Loops over the colours of three vertices, and bounds of their differences. One loop serves all states.
#pragma once

#include "raster/primitive/setup.hpp"
#include "raster/primitive/setup_math.hpp"

namespace spangle::raster {

/// Calls add(source, component, plane, projective plane) for all colour components that the state needs. A
/// build without Kind::full has few calls, so they are inline.
template <bool Rgb, class F> SPANGLE_INLINE void Setup<Fixed>::each_color(F add) const {
    if constexpr (!has_full)
        every_color<Rgb>(add);
    else
        any_color(
            {&add, [](void* f, const ColorSource& from, int i, Interpolant<std::uint32_t>& at,
                      Interpolant<std::uint64_t>& over_w) { (*static_cast<F*>(f))(from, i, at, over_w); }});
}

/// A bound of the differences of colours: 0 where the three vertices have one colour. It is the range of
/// colours.
template <bool Rgb> SPANGLE_INLINE std::uint32_t Setup<Fixed>::color_bits() {
    return color_range<Rgb>();
}

/// Whether the range of colours, which color_bits() has returned, is within a tolerance.
SPANGLE_INLINE bool Setup<Fixed>::colors_within_tolerance(std::uint32_t bits, std::uint32_t four) const {
    return is_within_tolerance(bits, four);
}

/// A condition that implies colors_affine() and does not need weights(). Small builds compute the weights of
/// every triangle.
SPANGLE_INLINE bool Setup<Fixed>::nearly_affine(std::uint32_t) const {
    return false;
}

/// Loads 1/w of the reference vertices, scaled to the highest exponent.
SPANGLE_INLINE void Setup<Fixed>::load_weights() {
    weights_of_several_exponents();
}

/// Sets up the attributes of a triangle.
SPANGLE_INLINE void Setup<Fixed>::triangle_attributes(const Vertex& provoking) {
    attributes(provoking);
}

} // namespace spangle::raster

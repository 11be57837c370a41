// The shadow policy. The product draws, every stage is also computed in double, and both results are compared
// (docs/architecture/fragments.md, "Policies"). It is compiled on hosts only.
#pragma once

#include <cstdint>

#include "raster/reference/policy_double.hpp"

namespace spangle::raster {

struct Shadow {
    using Vertex = ShadowVertex;
};

/// The product's span, which draws, and the span of the double policy beside it.
template <> struct Span<Shadow> : Span<Fixed> { Span<Double> twin; };

/// The values that are compared, in the order of the pipeline. The vertex pipeline reports the vertex stages.
enum class ShadowStage : std::uint8_t {
    vertex_color, ///< largest difference of a component, 0 .. 1
    vertex_coord, ///< s / q and t / q of a unit, in repeats of the texture
    vertex_fog,   ///< relative difference of the eye distance
    window_x,     ///< difference from the position before snapping, in pixels: half a step of n.8 is 0.00195
    window_y,
    snapping,  ///< difference from the double position snapped to the nearest, in steps of n.8, x and y
    window_z,  ///< difference, 0 .. 1
    inverse_w, ///< relative difference of 1/w
    depth,     ///< difference, 0 .. 1
    primary,   ///< largest difference of a component, 0 .. 1, as in all stages of colours below
    coord0,    ///< difference in texels of the base level; whole repeats do not count
    lod0,      ///< difference in levels of detail
    texture0,  ///< difference of the colour after the unit
    coord1,
    lod1,
    texture1,
    color_sum,
    fog_factor, ///< difference, 0 .. 1
    fog,        ///< difference of the colour after fog
    blend,      ///< difference of the blended colour
};
inline constexpr int shadow_stages = 20;
const char* name_of(ShadowStage stage);
const char* unit_of(ShadowStage stage);

struct ShadowRecord {
    std::uint64_t count = 0;
    std::uint64_t saturated = 0;    ///< number of fixed values at a limit of their range, of which 0 is none
    double worst = 0;               ///< largest |fixed - double|
    double squares = 0;             ///< sum of (fixed - double)^2
    double least = 0, greatest = 0; ///< range of the double values
    std::uint64_t flips = 0;        ///< for coordinates: number of fragments whose NEAREST texel differs

    void add(double fixed, double exact) { add_difference(fixed - exact, exact); }
    /// Adds a comparison in which the fixed value lies in [-limit, limit].
    void add(double fixed, double exact, double limit);
    void add_difference(double difference, double exact);
    double rms() const;
};

struct ShadowReport {
    ShadowRecord stage[shadow_stages];
    ShadowRecord& operator[](ShadowStage s) { return stage[static_cast<unsigned>(s)]; }
};

/// Sets where shadow draws of this thread report to. With null, which is the initial value, they only draw.
/// Returns the former value.
ShadowReport* report_shadow(ShadowReport* report);

/// The report that report_shadow() has set, or null. Code before the fragment stages reads it.
ShadowReport* shadow_report();

} // namespace spangle::raster

// The shadow policy: the product draws, and beside it every stage is computed again in double and the two are
// compared (docs/architecture/fragments.md, "Policies"). Hosts only.
#pragma once

#include <cstdint>

#include "raster/reference/policy_double.hpp"

namespace spangle::raster {

struct Shadow {
    using Vertex = ShadowVertex;
};

/// The product's span, which draws, and its twin.
template <> struct Span<Shadow> : Span<Fixed> { Span<Double> twin; };

/// What is compared, in the order of the pipeline. The vertex stages are reported by the vertex pipeline.
enum class ShadowStage : std::uint8_t {
    vertex_color, ///< largest difference of a component, 0 .. 1
    vertex_coord, ///< s / q, t / q of a unit, repeats of the texture
    vertex_fog,   ///< eye distance, relative
    window_x,     ///< pixels, against the unsnapped position: half a step of n.8 is 0.00195
    window_y,
    snapping,  ///< difference to the double position snapped to nearest, in steps of n.8, x and y
    window_z,  ///< 0 .. 1
    inverse_w, ///< relative
    depth,     ///< 0 .. 1
    primary,   ///< difference of a component, 0 .. 1; so are all colours
    coord0,    ///< texels of the base level; repeats are equal
    lod0,      ///< levels
    texture0,  ///< colour after the unit
    coord1,
    lod1,
    texture1,
    color_sum,
    fog_factor, ///< 0 .. 1
    fog,        ///< colour
    blend,      ///< colour
};
inline constexpr int shadow_stages = 20;
const char* name_of(ShadowStage stage);
const char* unit_of(ShadowStage stage);

struct ShadowRecord {
    std::uint64_t count = 0;
    std::uint64_t saturated = 0;    ///< fixed values among these at a limit of their range (0 does not count)
    double worst = 0;               ///< largest |fixed - double|
    double squares = 0;             ///< sum of (fixed - double)^2
    double least = 0, greatest = 0; ///< range of the double values
    std::uint64_t flips = 0;        ///< for coordinates: fragments whose NEAREST texel is another one

    void add(double fixed, double exact) { add_difference(fixed - exact, exact); }
    /// Adds a comparison in which the fixed value cannot lie beyond +-limit.
    void add(double fixed, double exact, double limit);
    void add_difference(double difference, double exact);
    double rms() const;
};

struct ShadowReport {
    ShadowRecord stage[shadow_stages];
    ShadowRecord& operator[](ShadowStage s) { return stage[static_cast<unsigned>(s)]; }
};

/// Where shadow draws of this thread report to; null (the initial state) draws only. Returns the old one.
ShadowReport* report_shadow(ShadowReport* report);

/// The report that report_shadow() has set, or null, for the stages before the fragments.
ShadowReport* shadow_report();

} // namespace spangle::raster

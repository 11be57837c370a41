// The shadow policy: the product draws, and beside it every stage is recomputed in double and the two are
// compared (design 2: diagnosis and profiling). Hosts only.
#pragma once

#include <cstdint>

#include "raster/span/policy_double.hpp"

namespace spangle::raster {

struct Shadow {
    using Vertex = ShadowVertex;
};

/// The product's span, which draws, and its twin.
template <> struct Span<Shadow> : Span<Fixed> { Span<Double> twin; };

/// What is compared, in the order of the pipeline.
enum class ShadowStage : std::uint8_t {
    depth,    ///< 0 .. 1
    primary,  ///< largest difference of a component, 0 .. 1; so are all colours
    coord0,   ///< texels of the base level; repeats are equal
    lod0,     ///< levels
    texture0, ///< colour after the unit
    coord1,
    lod1,
    texture1,
    color_sum,
    fog_factor, ///< 0 .. 1
    fog,        ///< colour
    blend,      ///< colour
};
inline constexpr int shadow_stages = 12;
const char* name_of(ShadowStage stage);

struct ShadowRecord {
    std::uint64_t count = 0;
    double worst = 0;               ///< largest |fixed - double|
    double least = 0, greatest = 0; ///< range of the double values

    void add(double fixed, double exact) { add_difference(fixed - exact, exact); }
    void add_difference(double difference, double exact);
};

struct ShadowReport {
    ShadowRecord stage[shadow_stages];
    ShadowRecord& operator[](ShadowStage s) { return stage[static_cast<unsigned>(s)]; }
};

/// Where shadow draws of this thread report to; null (the initial state) draws only. Returns the old one.
ShadowReport* report_shadow(ShadowReport* report);

} // namespace spangle::raster

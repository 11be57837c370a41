// Index stages of the reference policy whose formula differs from the product's. Hosts only.
#pragma once

#include <cmath>

#include "raster/ops/stage_index.hpp"
#include "raster/reference/stage_reference.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

template <> struct FogIndex<Reference> : ReferenceStage {
    static constexpr unsigned in = field_color | field_fog, out = field_color;
    using ReferenceStage::ReferenceStage;
    bool operator()(Px<Reference>& p) const {
        const FragmentState& state = span.state->fragment;
        const double part = (1 - reference_fog(state, p.fog)) * Reference::from_units(state.fog_color[0]);
        p.color.r = std::fmod(p.color.r + part, 256 / 255.0);
        return true;
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster

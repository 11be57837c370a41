// The depth offset of a polygon (GL 1.3, 3.5.5): factor m + units r, m = max(|dz/dx|, |dz/dy|). The minimum
// resolvable difference r is one code of a depth buffer of 16 bits, and two codes of one of 24 bits: the
// depth of a vertex comes from floats, whose neighbours between 1 and 2 are 2^-23 apart, so that a polygon
// one code in front of another cannot be asked for everywhere.
#pragma once

#include <cstdint>

#include "raster/numeric/real.hpp"
#include "raster/span/primitive_state.hpp"
#include "raster/span/vertex.hpp"
#include <spangle/format.hpp>

namespace spangle::raster {

struct PolygonOffset {
    numeric::Real factor = numeric::zero, units = numeric::zero;
};

/// Writes the depth offset of the plane through three vertices. area2 is twice their signed area; 0: the
/// plane counts as level.
template <class V>
void set_depth_offset(PrimitiveState& out, const PolygonOffset& offset, DepthFormat format, const V& a,
                      const V& b, const V& c, std::int64_t area2);

} // namespace spangle::raster

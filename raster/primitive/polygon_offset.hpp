// The depth offset of a polygon (GL 1.3, 3.5.5): factor m + units r, where m = max(|dz/dx|, |dz/dy|). The
// minimum resolvable difference r is one code of a depth buffer of 16 bits, and two codes of one of 24 bits.
// Depths of vertices come from floats, which are 2^-23 apart between 1 and 2. So a polygon one code of 24
// bits in front of another cannot be asked for everywhere.
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

/// Writes the depth offset of the plane through three vertices. area2 is twice their signed area. Where it is
/// 0, the plane counts as level.
template <class V>
void set_depth_offset(PrimitiveState& out, const PolygonOffset& offset, DepthFormat format, const V& a,
                      const V& b, const V& c, std::int64_t area2);

} // namespace spangle::raster

// Which cases draw their rows one after the other: all that draw one fragment at a time.
#pragma once

#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// True where the rows of a case are drawn one after the other, by the function that draws one row.
template <class Case, int Wide> inline constexpr bool draws_rows_apart = Case::apart || Wide == 1;

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster

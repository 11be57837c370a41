// The instruction sets for which the chain of this build is compiled, besides the set of the compiler's
// options. Only 64-bit x86 hosts have a second set. CMake defines SPANGLE_AVX2 for it.
#pragma once

#include "raster/span/draw_state.hpp"

#if SPANGLE_AVX2

namespace spangle::raster {

/// True where the processor has AVX2 and the environment variable SPANGLE_INSTRUCTIONS is not "base". The
/// first answer is kept, because compiled draws hold functions of one set.
bool uses_avx2();

namespace avx2 { // defined in chain_avx2.cpp

/// assemble_chain() does what assemble_any() does, and chain_runner() what runner_of() does
/// (raster/chain/assemble_chain.hpp).
void assemble_chain(Variant& variant, const Key& key, const FragmentState& state);
AnyFunction chain_runner(Number number, bool narrow);

} // namespace avx2

} // namespace spangle::raster

#endif

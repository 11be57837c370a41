// The chain for processors with AVX2: the same stages and bytes as the base chain. CMake gives this file
// alone the compiler's option for AVX2, so its functions lie in a namespace of their own (instructions.hpp).
#if SPANGLE_AVX2 && SPANGLE_CHAIN

#define SPANGLE_INSTRUCTIONS avx2

#include "raster/chain/assemble_chain.hpp"

namespace spangle::raster {
inline namespace avx2 {

void assemble_chain(Variant& variant, const Key& key, const FragmentState& state) {
    assemble_any(variant, key, state);
}
AnyFunction chain_runner(Number number, bool narrow) {
    return runner_of(number, narrow);
}

} // namespace avx2
} // namespace spangle::raster

#endif

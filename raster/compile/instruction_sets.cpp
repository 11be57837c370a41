#include "raster/compile/instruction_sets.hpp"

#if SPANGLE_AVX2

#include <atomic>
#include <cstdlib>
#include <cstring>

namespace spangle::raster {

bool uses_avx2() {
    static constinit std::atomic<signed char> known{-1}; // threads that ask at once find the same answer
    signed char found = known.load(std::memory_order_relaxed);
    if (found < 0) {
        const char* const wanted = std::getenv("SPANGLE_INSTRUCTIONS");
        const bool base = wanted != nullptr && std::strcmp(wanted, "base") == 0;
        found = !base && __builtin_cpu_supports("avx2") ? 1 : 0;
        known.store(found, std::memory_order_relaxed);
    }
    return found != 0;
}

} // namespace spangle::raster

#endif

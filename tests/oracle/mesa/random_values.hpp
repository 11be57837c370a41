// Random choices of the families of states.
#pragma once

#include <cstddef>

#include "tests/support/random.hpp"

namespace spangle::oracle {

template <class T, std::size_t N> T one_of(test::Random& random, const T (&values)[N]) {
    return values[random.below(static_cast<std::uint32_t>(N))];
}
inline bool maybe(test::Random& random) {
    return random.below(2) != 0;
}
/// Returns false once in `of` times.
inline bool often(test::Random& random, std::uint32_t of) {
    return random.below(of) != 0;
}
inline int whole(test::Random& random, int low, int high) {
    return low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low + 1)));
}
/// Returns a component of 8 bits.
inline float unit(test::Random& random) {
    return static_cast<float>(random.below(256)) / 255;
}

} // namespace spangle::oracle

// Adds what Spangle uses of C++20 and the library of Debian's emscripten (3.1.6) lacks. The build includes it
// before every source of the page.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <type_traits>

namespace std {

#ifndef __cpp_lib_bit_cast
template <class To, class From> constexpr To bit_cast(const From& from) noexcept {
    static_assert(sizeof(To) == sizeof(From));
    return __builtin_bit_cast(To, from);
}
#endif

#ifndef __cpp_lib_assume_aligned
template <size_t Alignment, class T> constexpr T* assume_aligned(T* p) {
    return static_cast<T*>(__builtin_assume_aligned(p, Alignment));
}
#endif

#ifndef __cpp_lib_ranges
namespace ranges {
struct smaller {
    template <class A, class B> constexpr bool operator()(const A& a, const B& b) const { return a < b; }
};
template <class Range, class Less = smaller, class Projection = identity>
constexpr void sort(Range&& range, Less less = {}, Projection projection = {}) {
    std::sort(std::begin(range), std::end(range), [&](const auto& a, const auto& b) {
        return std::invoke(less, std::invoke(projection, a), std::invoke(projection, b));
    });
}
} // namespace ranges
#endif

} // namespace std

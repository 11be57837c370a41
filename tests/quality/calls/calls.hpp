// Calls that GCC 12 dropped, and stores that it dropped before a call (cmake/SpangleTargets.cmake). The same
// cases run on this machine under GoogleTest and on emulated boards, each of which includes this file once.
#pragma once

#include "raster/numeric/matrix_build.hpp"

namespace spangle::calls {

using namespace numeric;

/// A second caller, which is not inlined, of a function that stores through its argument.
[[gnu::noinline]] bool wrapped(const Matrix& a, Matrix& out) {
    return inverse(a, out);
}
/// at() reads the element from the matrix directly.
[[gnu::noinline]] Element of_inverse(const Matrix& a, int row, int column) {
    Matrix out = identity();
    wrapped(a, out);
    return out.at(row, column);
}
inline Element inverse_of_scaling(std::int32_t factor, int row, int column) {
    const Real by = from_i32(factor);
    const Matrix a = scaling(by, by, by);
    return of_inverse(a, row, column);
}

/// These structures are passed by value from memory that only this function writes.
[[gnu::noinline]] inline Element product_of_scalings(std::int32_t a, std::int32_t b, int row, int column) {
    const Real x = from_i32(a), y = from_i32(b);
    return multiply(scaling(x, x, x), scaling(y, y, y)).at(row, column);
}

/// Returns the vector 3 : 4 : 0 under one exponent.
[[gnu::noinline]] inline Block3 vector_of(std::int32_t x, std::int32_t y) {
    const Real v[3] = {from_i32(x), from_i32(y), from_i32(0)};
    return to_block(v);
}

/// Returns whether an Element equals the number that these bits of a float give.
inline bool is(Element v, std::uint32_t float_bits) {
    return to_real(v).bits == float_bits;
}

/// Returns 0 if all results are right, or the number of the first wrong case. The arguments are 2 and 4, and
/// compilers must not know them.
inline int first_wrong(std::int32_t two, std::int32_t four) {
    constexpr std::uint32_t half = 0x3F000000, one = 0x3F800000, eight = 0x41000000;
    if (!is(inverse_of_scaling(two, 0, 0), half) || !is(inverse_of_scaling(two, 2, 2), half))
        return 1;
    if (!is(inverse_of_scaling(two, 3, 3), one) || !is(inverse_of_scaling(two, 1, 0), 0))
        return 2;
    if (!is(product_of_scalings(two, four, 1, 1), eight) || !is(product_of_scalings(two, four, 3, 3), one))
        return 3;
    const Block3 v = vector_of(two, four);
    if (v.m[1] != 2 * v.m[0] || v.m[0] <= 0 || v.m[2] != 0)
        return 4;
    return 0;
}

} // namespace spangle::calls

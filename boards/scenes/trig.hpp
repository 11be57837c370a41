// Sine, cosine and square root for constants that the compiler computes. So scenes need no maths library on a
// board, and every target holds the same bits.
#pragma once

#include <array>

namespace spangle::scenes {

inline constexpr double turn = 6.283185307179586476925286766559;

/// The sine of `x`, in radians, to double precision. The function folds `x` into the first quarter of a turn,
/// and sums a Taylor series.
constexpr double sine(double x) {
    double sign = 1.0;
    if (x < 0.0) {
        x = -x;
        sign = -1.0;
    }
    while (x >= turn)
        x -= turn;
    if (x > turn / 2) {
        x -= turn / 2;
        sign = -sign;
    }
    if (x > turn / 4)
        x = turn / 2 - x;
    double term = x, sum = x;
    for (int n = 1; n < 14; ++n) {
        term *= -x * x / ((2 * n) * (2 * n + 1));
        sum += term;
    }
    return sign * sum;
}

constexpr double cosine(double x) {
    return sine(x + turn / 4);
}

/// The square root of x > 0, by Newton's steps.
constexpr double root(double x) {
    double r = x > 1.0 ? x : 1.0;
    for (int i = 0; i < 60; ++i)
        r = 0.5 * (r + x / r);
    return r;
}

} // namespace spangle::scenes

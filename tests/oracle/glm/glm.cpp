// Compares GLM over spangle::fixed with GLM over double, for the functions that graphics programs use. Each
// function's error is printed and bounded. Arguments are made in fixed and converted, so both sides compute
// from the same numbers.
#include <spangle/glm.hpp>

#include <cmath>
#include <cstdio>
#include <functional>
#include <gtest/gtest.h>
#include <string>

#include "tests/unit/numeric/random.hpp"

namespace {

using spangle::fixed;
using spangle::fmat3;
using spangle::fmat4;
using spangle::fquat;
using spangle::fvec2;
using spangle::fvec3;
using spangle::fvec4;

double real(fixed v) {
    return static_cast<double>(v);
}
glm::dvec2 real(const fvec2& v) {
    return {real(v.x), real(v.y)};
}
glm::dvec3 real(const fvec3& v) {
    return {real(v.x), real(v.y), real(v.z)};
}
glm::dvec4 real(const fvec4& v) {
    return {real(v.x), real(v.y), real(v.z), real(v.w)};
}
glm::dquat real(const fquat& v) {
    return {real(v.w), real(v.x), real(v.y), real(v.z)};
}
glm::dmat4 real(const fmat4& m) {
    return {real(m[0]), real(m[1]), real(m[2]), real(m[3])};
}
glm::dmat3 real(const fmat3& m) {
    return {real(m[0]), real(m[1]), real(m[2])};
}

double difference(double a, double b) {
    return std::fabs(a - b);
}
template <glm::length_t L> double difference(const glm::vec<L, double>& a, const glm::vec<L, double>& b) {
    double most = 0;
    for (glm::length_t i = 0; i < L; ++i)
        most = std::max(most, std::fabs(a[i] - b[i]));
    return most;
}
double difference(const glm::dquat& a, const glm::dquat& b) {
    return difference(glm::dvec4(a.w, a.x, a.y, a.z), glm::dvec4(b.w, b.x, b.y, b.z));
}
template <glm::length_t C, glm::length_t R>
double difference(const glm::mat<C, R, double>& a, const glm::mat<C, R, double>& b) {
    double most = 0;
    for (glm::length_t i = 0; i < C; ++i)
        most = std::max(most, difference(a[i], b[i]));
    return most;
}

class Source {
  public:
    fixed number(double size) { return fixed((random_.unit() * 2 - 1) * size); }
    fvec2 two(double size) { return {number(size), number(size)}; }
    fvec3 three(double size) { return {number(size), number(size), number(size)}; }
    fvec4 four(double size) { return {number(size), number(size), number(size), number(size)}; }
    /// Returns a vector whose length is not near 0.
    fvec3 axis(double size) {
        for (;;) {
            const fvec3 v = three(size);
            if (glm::length(real(v)) > size / 8)
                return v;
        }
    }
    /// Returns a matrix that is nearly a rotation.
    fmat4 turn() { return glm::rotate(fmat4(fixed(1)), number(3), axis(1)); }
    fquat quaternion() { return glm::angleAxis(number(3), glm::normalize(axis(1))); }

  private:
    Random random_{77};
};

constexpr double ulp = 1.0 / 65536;

/// Compares the largest of `count` errors with `bound`, in units of 2^-16; `error` returns the error of one
/// try.
void check(const char* name, double bound, const std::function<double(Source&)>& error, int count = 5000) {
    Source source;
    double most = 0;
    for (int i = 0; i < count; ++i)
        most = std::max(most, error(source));
    std::printf("%-28s %9.2f / 65536 (bound %g)\n", name, most / ulp, bound);
    EXPECT_LE(most, bound * ulp) << name;
}

TEST(Glm, ScalarFunctions) {
    using std::fabs;
    check("sqrt", 0.51, [](Source& s) {
        const fixed v = glm::abs(s.number(32767));
        return difference(real(glm::sqrt(v)), std::sqrt(real(v)));
    });
    check("inversesqrt, v >= 1/4", 0.51, [](Source& s) {
        const fixed v = glm::abs(s.number(100)) + fixed(0.25);
        return difference(real(glm::inversesqrt(v)), 1 / std::sqrt(real(v)));
    });
    check("sin", 0.6, [](Source& s) {
        const fixed v = s.number(30000);
        return difference(real(glm::sin(v)), std::sin(real(v)));
    });
    check("cos", 0.6, [](Source& s) {
        const fixed v = s.number(30000);
        return difference(real(glm::cos(v)), std::cos(real(v)));
    });
    check("tan, |x| < 1.3", 0.6, [](Source& s) {
        const fixed v = s.number(1.3);
        return difference(real(glm::tan(v)), std::tan(real(v)));
    });
    check("asin", 0.6, [](Source& s) {
        const fixed v = s.number(1);
        return difference(real(glm::asin(v)), std::asin(real(v)));
    });
    check("acos", 0.6, [](Source& s) {
        const fixed v = s.number(1);
        return difference(real(glm::acos(v)), std::acos(real(v)));
    });
    check("atan(y, x)", 0.6, [](Source& s) {
        const fixed y = s.number(1000), x = s.number(1000);
        return difference(real(glm::atan(y, x)), std::atan2(real(y), real(x)));
    });
    check("floor, ceil, round, fract", 0, [](Source& s) {
        const fixed v = s.number(1000);
        const double x = real(v);
        return fabs(real(glm::floor(v)) - std::floor(x)) + fabs(real(glm::ceil(v)) - std::ceil(x)) +
               fabs(real(glm::round(v)) - std::round(x)) + fabs(real(glm::fract(v)) - (x - std::floor(x))) +
               fabs(real(glm::trunc(v)) - std::trunc(x));
    });
    check("min, max, clamp, mix", 1, [](Source& s) {
        const fixed a = s.number(10), b = s.number(10), t = glm::abs(s.number(1));
        return fabs(real(glm::min(a, b)) - std::min(real(a), real(b))) +
               fabs(real(glm::max(a, b)) - std::max(real(a), real(b))) +
               fabs(real(glm::clamp(a, fixed(-1), fixed(1))) - std::min(std::max(real(a), -1.0), 1.0)) +
               fabs(real(glm::mix(a, b, t)) - (real(a) * (1 - real(t)) + real(b) * real(t)));
    });
}

TEST(Glm, Vectors) {
    check("vec + - * /", 1, [](Source& s) {
        const fvec3 a = s.three(100), b = s.three(100);
        const fixed k = glm::abs(s.number(4)) + fixed(1);
        return std::max(difference(real(a + b - a * k), real(a) + real(b) - real(a) * real(k)),
                        difference(real(a / k), real(a) / real(k)));
    });
    check("dot", 1, [](Source& s) {
        const fvec4 a = s.four(80), b = s.four(80);
        return difference(real(glm::dot(a, b)), glm::dot(real(a), real(b)));
    });
    check("cross", 1, [](Source& s) {
        const fvec3 a = s.three(100), b = s.three(100);
        return difference(real(glm::cross(a, b)), glm::cross(real(a), real(b)));
    });
    check("length up to 30000", 1, [](Source& s) {
        const fvec3 a = s.three(17000);
        return difference(real(glm::length(a)), glm::length(real(a)));
    });
    check("distance", 1, [](Source& s) {
        const fvec2 a = s.two(100), b = s.two(100);
        return difference(real(glm::distance(a, b)), glm::distance(real(a), real(b)));
    });
    for (double size : {0.01, 1.0, 15000.0})
        check("normalize", 0.6, [size](Source& s) {
            const fvec3 a = s.axis(size);
            return difference(real(glm::normalize(a)), glm::normalize(real(a)));
        });
    check("reflect", 4, [](Source& s) {
        const fvec3 a = s.three(1), n = glm::normalize(s.axis(1));
        return difference(real(glm::reflect(a, n)), glm::reflect(real(a), real(n)));
    });
    const fvec3 none = glm::normalize(fvec3(fixed(0)));
    EXPECT_EQ(none, fvec3(fixed(0))) << "no division by 0";
}

TEST(Glm, Matrices) {
    check("mat4 * vec4", 1, [](Source& s) {
        const fmat4 m = s.turn();
        const fvec4 v = s.four(1000);
        return difference(real(m * v), real(m) * real(v));
    });
    check("mat4 * mat4", 1, [](Source& s) {
        const fmat4 a = s.turn(), b = s.turn();
        return difference(real(a * b), real(a) * real(b));
    });
    check("mat3 * vec3, mat3 * mat3", 1, [](Source& s) {
        const fmat3 a(s.turn()), b(s.turn());
        const fvec3 v = s.three(1000);
        return std::max(difference(real(a * b), real(a) * real(b)),
                        difference(real(a * v), real(a) * real(v)));
    });
    check("transpose, determinant", 6, [](Source& s) {
        const fmat4 a = s.turn();
        return difference(real(glm::transpose(a)), glm::transpose(real(a))) +
               difference(real(glm::determinant(a)), glm::determinant(real(a)));
    });
    check("inverse of a rigid matrix", 1, [](Source& s) {
        const fmat4 m = glm::translate(fmat4(fixed(1)), s.three(10)) * s.turn();
        return difference(real(glm::inverse(m)), glm::inverse(real(m)));
    });
    check("inverse of a mat3", 1, [](Source& s) {
        const fmat3 m = fmat3(s.turn()) * fmat3(fixed(2));
        return difference(real(glm::inverse(m)), glm::inverse(real(m)));
    });
    EXPECT_EQ(glm::inverse(fmat4(fixed(0))), fmat4(fixed(0))) << "singular does no harm";
}

TEST(Glm, Transforms) {
    check("translate, scale", 2, [](Source& s) {
        const fvec3 t = s.three(100), k = s.three(3);
        return difference(real(glm::scale(glm::translate(fmat4(fixed(1)), t), k)),
                          glm::scale(glm::translate(glm::dmat4(1), real(t)), real(k)));
    });
    check("rotate", 3, [](Source& s) {
        const fixed a = s.number(6);
        const fvec3 v = s.axis(1);
        return difference(real(glm::rotate(fmat4(fixed(1)), a, v)),
                          glm::rotate(glm::dmat4(1), real(a), real(v)));
    });
    check("lookAt", 24, [](Source& s) {
        const fvec3 eye = s.axis(10), at = s.three(1), up(fixed(0), fixed(1), fixed(0));
        if (std::fabs(glm::normalize(real(at) - real(eye)).y) > 0.9)
            return 0.0;
        return difference(real(glm::lookAt(eye, at, up)), glm::lookAt(real(eye), real(at), real(up)));
    });
    check("perspective", 40, [](Source& s) {
        const fixed fov = glm::abs(s.number(1)) + fixed(0.5), aspect = glm::abs(s.number(1)) + fixed(0.75);
        const fixed n = glm::abs(s.number(1)) + fixed(0.5), f = n + fixed(20) + glm::abs(s.number(100));
        return difference(real(glm::perspective(fov, aspect, n, f)),
                          glm::perspective(real(fov), real(aspect), real(n), real(f)));
    });
    check("frustum", 4, [](Source& s) {
        const fixed l = s.number(1) - fixed(1.5), r = s.number(1) + fixed(1.5), b = s.number(1) - fixed(1.5),
                    t = s.number(1) + fixed(1.5);
        const fixed n = glm::abs(s.number(1)) + fixed(0.5), f = n + fixed(20) + glm::abs(s.number(100));
        return difference(real(glm::frustum(l, r, b, t, n, f)),
                          glm::frustum(real(l), real(r), real(b), real(t), real(n), real(f)));
    });
    check("ortho", 2, [](Source& s) {
        const fixed l = s.number(1) - fixed(1.5), r = s.number(100) + fixed(200),
                    b = s.number(1) - fixed(1.5), t = s.number(100) + fixed(200);
        return difference(real(glm::ortho(l, r, b, t, fixed(-1), fixed(1))),
                          glm::ortho(real(l), real(r), real(b), real(t), -1.0, 1.0));
    });
}

TEST(Glm, Quaternions) {
    check("angleAxis", 2, [](Source& s) {
        const fixed a = s.number(3);
        const fvec3 v = glm::normalize(s.axis(1));
        return difference(real(glm::angleAxis(a, v)), glm::angleAxis(real(a), real(v)));
    });
    check("quat * quat", 3, [](Source& s) {
        const fquat a = s.quaternion(), b = s.quaternion();
        return difference(real(a * b), real(a) * real(b));
    });
    check("quat * vec3", 16, [](Source& s) {
        const fquat a = s.quaternion();
        const fvec3 v = s.three(4);
        return difference(real(a * v), real(a) * real(v));
    });
    check("normalize", 3, [](Source& s) {
        const fquat a = s.quaternion() * fixed(3);
        return difference(real(glm::normalize(a)), glm::normalize(real(a)));
    });
    check("mat4_cast", 6, [](Source& s) {
        const fquat a = s.quaternion();
        return difference(real(glm::mat4_cast(a)), glm::mat4_cast(real(a)));
    });
    check("slerp", 32, [](Source& s) {
        const fquat a = s.quaternion(), b = s.quaternion();
        const double cosine = glm::dot(real(a), real(b));
        if (std::fabs(cosine) > 0.95 || std::fabs(cosine) < 0.01)
            return 0.0; // the result is divided by the sine of the angle
        const fixed t = glm::abs(s.number(1));
        return difference(real(glm::slerp(a, b, t)), glm::slerp(real(a), real(b), real(t)));
    });
}

TEST(Fixed, ArithmeticRoundsAndSaturates) {
    Random random(5);
    const auto nearest = [](long double v) {
        return v >= 32768    ? INT32_MAX
               : v <= -32768 ? INT32_MIN
                             : static_cast<long double>(std::floor(v * 65536 + 0.5L));
    };
    for (int i = 0; i < 300'000; ++i) {
        const auto a = static_cast<std::int32_t>(random.word()) >> (random.next() & 31);
        const auto b = static_cast<std::int32_t>(random.word()) >> (random.next() & 31);
        const fixed x = fixed::from_bits(a), y = fixed::from_bits(b);
        const long double p = static_cast<long double>(a) / 65536, q = static_cast<long double>(b) / 65536;
        ASSERT_EQ((x + y).bits, nearest(p + q));
        ASSERT_EQ((x - y).bits, nearest(p - q));
        ASSERT_EQ((x * y).bits, std::min(nearest(p * q), static_cast<long double>(INT32_MAX)));
        if (b != 0) {
            ASSERT_LE(
                std::fabs((x / y).bits - std::min(std::max(p / q * 65536, -2147483648.0L), 2147483647.0L)),
                0.5L);
        }
    }
    EXPECT_EQ((fixed(1) / fixed(0)).bits, INT32_MAX);
    EXPECT_EQ((fixed(-1) / fixed(0)).bits, INT32_MIN);
    EXPECT_EQ((-fixed::from_bits(INT32_MIN)).bits, INT32_MAX);
    EXPECT_EQ(fixed(40000).bits, INT32_MAX);
    EXPECT_EQ(fixed(-40000).bits, INT32_MIN);
    EXPECT_EQ(fixed(1e30f).bits, INT32_MAX);
    EXPECT_EQ(fixed(std::nan("")).bits, 0);
    EXPECT_EQ(static_cast<int>(fixed(-1.75)), -1);
    for (std::int32_t v : {INT32_MIN, INT32_MIN + 1, -1, 0, 1, INT32_MAX}) { // every argument must be safe
        const fixed f = fixed::from_bits(v);
        sqrt(f), inversesqrt(f), sin(f), cos(f), tan(f), acos(f), asin(f), atan(f), floor(f), ceil(f),
            round(f), abs(f);
        fmod(f, fixed(0)), fmod(f, fixed::from_bits(-1));
        glm::normalize(fvec3(f)), glm::length(fvec4(f)), glm::inverse(fmat4(f));
    }
}

TEST(Fixed, MatricesAreWhatGlfixedCommandsTake) {
    const fmat4 m = glm::translate(fmat4(fixed(1)), fvec3(fixed(1.5), fixed(-2), fixed(0.25)));
    const auto* bits = reinterpret_cast<const std::int32_t*>(glm::value_ptr(m)); // glLoadMatrixx(bits)
    EXPECT_EQ(bits[0], 0x10000);
    EXPECT_EQ(bits[12], 0x18000);
    EXPECT_EQ(bits[13], -0x20000);
    EXPECT_EQ(bits[14], 0x4000);
}

} // namespace

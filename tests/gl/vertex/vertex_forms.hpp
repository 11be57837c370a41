// Lists every glVertex command, and which values it can hold exactly.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include <spangle/GL/gl.h>

namespace spangle::test {

using Position = std::array<double, 4>;

enum class Scalar { s16, i32, f32, f64, fixed };

inline double least_step(Scalar type) {
    return type == Scalar::fixed ? 1.0 / 65536 : 1.0;
}

/// Whether a parameter of this type can hold a number exactly. Positions in these tests are floats.
inline bool holds(Scalar type, double v) {
    if (type == Scalar::f32 || type == Scalar::f64)
        return true;
    const double most = type == Scalar::s16 ? 32767.0 : type == Scalar::i32 ? 2147483647.0 : 32767.0;
    return std::fabs(v) <= most && std::floor(v / least_step(type)) * least_step(type) == v;
}

/// Whether `size` components of this type hold the whole position: the others must be 0, 0, 1.
inline bool holds(Scalar type, int size, const Position& p) {
    for (int c = 0; c < 4; ++c)
        if (c < size ? !holds(type, p[static_cast<std::size_t>(c)])
                     : p[static_cast<std::size_t>(c)] != (c == 3 ? 1.0 : 0.0))
            return false;
    return true;
}

template <class T> T typed(Scalar type, double v) {
    return static_cast<T>(type == Scalar::fixed ? v * 65536 : v);
}

struct VertexForm {
    const char* name;
    Scalar type;
    int size;
    void (*give)(const Position&);
};

#define SPANGLE_ARGUMENTS_2 a[0], a[1]
#define SPANGLE_ARGUMENTS_3 a[0], a[1], a[2]
#define SPANGLE_ARGUMENTS_4 a[0], a[1], a[2], a[3]
#define SPANGLE_FORM(n, name, type, T, arguments)                                                            \
    {                                                                                                        \
#name, type, n, [](const Position& p) {                                                                 \
         T a[n];                                                                                             \
         for (std::size_t c = 0; c < n; ++c)                                                                 \
             a[c] = typed<T>(type, p[c]);                                                                    \
         name(arguments);                                                                                    \
     }    \
    }
#define SPANGLE_FORMS(n)                                                                                     \
    SPANGLE_FORM(n, glVertex##n##s, Scalar::s16, GLshort, SPANGLE_ARGUMENTS_##n),                            \
        SPANGLE_FORM(n, glVertex##n##sv, Scalar::s16, GLshort, a),                                           \
        SPANGLE_FORM(n, glVertex##n##i, Scalar::i32, GLint, SPANGLE_ARGUMENTS_##n),                          \
        SPANGLE_FORM(n, glVertex##n##iv, Scalar::i32, GLint, a),                                             \
        SPANGLE_FORM(n, glVertex##n##f, Scalar::f32, GLfloat, SPANGLE_ARGUMENTS_##n),                        \
        SPANGLE_FORM(n, glVertex##n##fv, Scalar::f32, GLfloat, a),                                           \
        SPANGLE_FORM(n, glVertex##n##d, Scalar::f64, GLdouble, SPANGLE_ARGUMENTS_##n),                       \
        SPANGLE_FORM(n, glVertex##n##dv, Scalar::f64, GLdouble, a),                                          \
        SPANGLE_FORM(n, glVertex##n##xOES, Scalar::fixed, GLfixed, SPANGLE_ARGUMENTS_##n),                   \
        SPANGLE_FORM(n, glVertex##n##xvOES, Scalar::fixed, GLfixed, a)

inline const VertexForm vertex_forms[] = {SPANGLE_FORMS(2), SPANGLE_FORMS(3), SPANGLE_FORMS(4)};

#undef SPANGLE_FORMS
#undef SPANGLE_FORM
#undef SPANGLE_ARGUMENTS_2
#undef SPANGLE_ARGUMENTS_3
#undef SPANGLE_ARGUMENTS_4

} // namespace spangle::test

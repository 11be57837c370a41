// Converts the scalars of the API. Every scalar becomes a Real or an integer here, and is not converted again
// (docs/architecture/numbers.md, "Values from the API").
#pragma once

#include <bit>

#include "gl/api/family.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl::convert {

// These conversions keep the value of a number. The conversion of floats is inline. The others are not, so
// that entry points stay small.
[[gnu::cold]] Real cast_special(std::uint32_t bits); ///< NaN and infinities
inline Real cast_f(GLfloat v) {
    const auto bits = std::bit_cast<std::uint32_t>(v);
    if ((bits & 0x7F800000) == 0x7F800000) [[unlikely]]
        return cast_special(bits);
    return {bits};
}
Real cast_d(GLdouble v);
Real cast_x(GLfixed v);
Real cast_i(GLint v);
inline Real cast_s(GLshort v) {
    return cast_i(v);
}
inline Real cast_ub(GLubyte v) {
    return cast_i(v);
}

// These conversions are those of components of colours and normals, which map integers to [0, 1] or [-1, 1]
// (GL 1.3, table 2.6).
Real unit_b(GLbyte v);
Real unit_s(GLshort v);
Real unit_i(GLint v);
Real unit_ub(GLubyte v);
Real unit_us(GLushort v);
Real unit_ui(GLuint v);

/// Converts an integer of 1 << size_log bytes in memory, keeping its value or as a component of a colour.
/// Where code must be small, this one function serves all integer types.
Real integer_at(const unsigned char* at, unsigned size_log, bool is_signed, bool fraction);

/// Names the conversion of one component: each enumerator stands for the function of its name, cast_f() to
/// unit_ui().
enum class Element : std::uint8_t {
    cast_f,
    cast_s,
    cast_i,
    cast_d,
    cast_x,
    unit_b,
    unit_ub,
    unit_s,
    unit_us,
    unit_i,
    unit_ui
};

template <Element kind, class T> inline Real one(T v) {
    if constexpr (kind == Element::cast_f)
        return cast_f(v);
    else if constexpr (kind == Element::cast_d)
        return cast_d(v);
    else if constexpr (kind == Element::cast_x)
        return cast_x(v);
    else if constexpr (kind == Element::unit_i)
        return unit_i(v);
    else
        return cast_i(v);
}

/// An Element and a count of components in one byte. The count is in the low 3 bits.
using Components = std::uint8_t;
inline constexpr unsigned most_components = 6; ///< the largest count, that of Frustum and Ortho
constexpr Components components(Element element, unsigned count) {
    return static_cast<Components>(static_cast<unsigned>(element) << 3 | count);
}
/// A flag for types of one or two bytes. If it is set, each component begins a word of its own, as arguments
/// of functions do.
inline constexpr Components of_words = 0x80;

/// Loaded components. Those that the client does not give are from (0, 0, 0, 1). If the client's pointer is
/// null, INVALID_VALUE is raised and `null` is set.
struct Loaded {
    Real at[most_components];
    bool null = false;
};
Loaded load(const void* v, Components kind, const char* null_text);

template <Element kind, class T> [[gnu::noinline]] Matrix16 matrix(const T* m) {
    Matrix16 out;
    for (int i = 0; i < 16; ++i)
        out.m[i] = one<kind>(m[i]);
    return out;
}
Matrix16 matrix(const void* m, Element kind);

// In commands with a pname, such as Light and Fog, the shape of the pname says how many values there are and
// what kind they have.

/// Types of values in client memory. Only queries store GLboolean, which is `b`.
enum class Number : std::uint8_t { f, i, d, x, b };
/// Returns a single value of any type as a word. A double becomes a float.
inline std::uint32_t word(GLfloat v) {
    return std::bit_cast<std::uint32_t>(v);
}
inline std::uint32_t word(GLdouble v) {
    return cast_d(v).bits;
}
inline std::uint32_t word(GLint v) {
    return static_cast<std::uint32_t>(v);
}
Params vector(Shape shape, const void* values, Number type);
/// Stores a value of a query in client memory (GL 1.3, 6.1.2).
void store_value(void* array, std::size_t index, Number type, Kind kind, Param value);
/// Stores the values of a query. If `found.count` is 0, nothing is written.
void store(Shape shape, const Params& found, void* out, Number type);

// These functions convert a value of a given kind to the type that a query returns (GL 1.3, 6.1.2).
GLfloat to_float(Kind kind, Param value);
GLdouble to_double(Kind kind, Param value);
GLint to_int(Kind kind, Param value);
GLfixed to_fixed(Kind kind, Param value);
GLboolean to_boolean(Kind kind, Param value);

// These functions read and write an element of a client array, whose type is that of the entry point. The
// array need not be aligned.
Real array_value(const Values& array, std::size_t index);
void store_array_value(const Values& array, std::size_t index, Kind kind, Param value);

} // namespace spangle::gl::convert

// The border of the API: every scalar becomes a Real or an integer here, once (design 1).
#pragma once

#include <bit>

#include "gl/api/family.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl::convert {

// At face value. Floats are moves and inline; the others are functions, so that wrappers stay thin.
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

// As components of colours and normals (GL 1.3, table 2.6).
Real unit_b(GLbyte v);
Real unit_s(GLshort v);
Real unit_i(GLint v);
Real unit_ub(GLubyte v);
Real unit_us(GLushort v);
Real unit_ui(GLuint v);

/// An integer of 1 << size_log bytes as it lies in memory, at face value or as a component: the short way,
/// whatever its type.
Real integer_at(const unsigned char* at, unsigned size_log, bool is_signed, bool fraction);

/// The types above, as a number.
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

/// A type and how many there are of it.
using Components = std::uint8_t;
inline constexpr unsigned most_components = 6; ///< of Frustum and Ortho
constexpr Components components(Element element, unsigned count) {
    return static_cast<Components>(static_cast<unsigned>(element) << 3 | count);
}
/// With a type of one or two bytes: each lies at the beginning of a word of its own, as arguments come.
inline constexpr Components of_words = 0x80;

/// Components out of memory, the missing ones of (0, 0, 0, 1). A null pointer is INVALID_VALUE, and null.
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

// Light, Material, Fog, TexParameter...: the pname's shape decides what the values are.
enum class Number : std::uint8_t { f, i, d, x, b }; ///< of client memory; b, GLboolean, is only stored
/// A single value comes in a register, whatever its type: a double as the float that is kept of it.
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
/// And back, for queries (GL 1.3, 6.1.2).
void store_value(void* array, std::size_t index, Number type, Kind kind, Param value);
/// Nothing is written when `found.count` is 0.
void store(Shape shape, const Params& found, void* out, Number type);

// One value of a given kind, as the queries return it (GL 1.3, 6.1.2).
GLfloat to_float(Kind kind, Param value);
GLdouble to_double(Kind kind, Param value);
GLint to_int(Kind kind, Param value);
GLfixed to_fixed(Kind kind, Param value);
GLboolean to_boolean(Kind kind, Param value);

// Arrays of the client, of the type their entry point says; they need not be aligned.
Real array_value(const Values& array, std::size_t index);
void store_array_value(const Values& array, std::size_t index, Kind kind, Param value);

} // namespace spangle::gl::convert

#include "gl/api/convert.hpp"

#include <cstring>

#include "gl/api/issue.hpp"
#include "gl/pixel/component.hpp"

namespace spangle::gl::convert {

Real cast_special(std::uint32_t bits) {
    return numeric::from_float_bits(bits);
}
Real cast_d(GLdouble v) {
    return numeric::from_double(v);
}
Real cast_x(GLfixed v) {
    return numeric::from_fixed16(v);
}
Real cast_i(GLint v) {
    return numeric::from_i32(v);
}

Real unit_b(GLbyte v) {
    return numeric::normalized_byte(v);
}
Real unit_s(GLshort v) {
    return numeric::normalized_short(v);
}
Real unit_i(GLint v) {
    return numeric::normalized_int(v);
}
Real unit_ub(GLubyte v) {
    return numeric::normalized_ubyte(v);
}
Real unit_us(GLushort v) {
    return numeric::normalized_ushort(v);
}
Real unit_ui(GLuint v) {
    return numeric::normalized_uint(v);
}

Real integer_at(const unsigned char* at, unsigned size_log, bool is_signed, bool fraction) {
    const std::uint32_t word = load_element(at, 1u << size_log, false);
    const int bits = 8 << size_log;
    if (!is_signed)
        return fraction ? numeric::normalized_unsigned(word, bits) : numeric::from_u32(word);
    const std::int32_t value = static_cast<std::int32_t>(word << (32 - bits)) >> (32 - bits);
    return fraction ? numeric::normalized_signed(value, bits) : numeric::from_i32(value);
}

namespace {

// A float given for an integer is rounded (GL 1.3, 3.6.1 for PixelStore, 6.1.2). An enum or a boolean given
// as a GLfixed is not scaled (GL_OES_fixed_point).
Param param_real(Kind kind, Real v) {
    return kind == Kind::integer ? Param::from_integer(static_cast<std::uint32_t>(numeric::to_i32_round(v)))
                                 : Param::from(v);
}
Param param_i(Kind kind, GLint v) {
    if (kind == Kind::integer)
        return Param::from_integer(static_cast<std::uint32_t>(v));
    return Param::from(kind == Kind::color ? unit_i(v) : cast_i(v));
}
[[maybe_unused]] Param param_x(Kind kind, GLfixed v) {
    return kind == Kind::integer ? Param::from_integer(static_cast<std::uint32_t>(v))
                                 : Param::from(cast_x(v));
}

template <class T> T element(const void* array, std::size_t index) {
    T value;
    std::memcpy(&value, static_cast<const unsigned char*>(array) + index * sizeof(T), sizeof value);
    return value;
}

Real component(Element type, const void* v, std::size_t i) {
    switch (type) {
    case Element::cast_f:
        return cast_f(element<GLfloat>(v, i));
    case Element::cast_s:
        return cast_i(element<GLshort>(v, i));
    case Element::cast_i:
        return cast_i(element<GLint>(v, i));
    case Element::cast_d:
        return cast_d(element<GLdouble>(v, i));
#if SPANGLE_FEATURE_FIXED_POINT
    case Element::cast_x:
        return cast_x(element<GLfixed>(v, i));
#endif
    case Element::unit_b:
        return unit_b(element<GLbyte>(v, i));
    case Element::unit_s:
        return unit_s(element<GLshort>(v, i));
    case Element::unit_i:
        return unit_i(element<GLint>(v, i));
    case Element::unit_ub:
        return unit_ub(element<GLubyte>(v, i));
    case Element::unit_us:
        return unit_us(element<GLushort>(v, i));
    default:
        return unit_ui(element<GLuint>(v, i));
    }
}

} // namespace

Loaded load(const void* v, Components kind, const char* null_text) {
    Loaded out;
    if (v == nullptr) {
        refuse_null(null_text);
        out.null = true;
        return out;
    }
    const auto type = static_cast<Element>(kind >> 3 & 15);
    const std::size_t step = (kind & of_words) == 0 ? 1 : type < Element::unit_s ? 4 : 2;
    for (std::size_t i = 0; i < most_components; ++i)
        out.at[i] = i < (kind & 7u) ? component(type, v, i * step) : i == 3 ? numeric::one : numeric::zero;
    return out;
}

Matrix16 matrix(const void* m, Element kind) {
    Matrix16 out;
    for (std::size_t i = 0; i < 16; ++i)
        out.m[i] = component(kind, m, i);
    return out;
}

namespace {

Param param(Kind kind, const void* values, std::size_t i, Number type) {
    switch (type) {
    case Number::f:
        return param_real(kind, cast_f(element<GLfloat>(values, i)));
    case Number::d:
        return param_real(kind, cast_d(element<GLdouble>(values, i)));
#if SPANGLE_FEATURE_FIXED_POINT
    case Number::x:
        return param_x(kind, element<GLfixed>(values, i));
#endif
    default:
        return param_i(kind, element<GLint>(values, i));
    }
}

template <class T> void store_element(void* array, std::size_t index, T value) {
    std::memcpy(static_cast<unsigned char*>(array) + index * sizeof(T), &value, sizeof value);
}

} // namespace

void store_value(void* array, std::size_t index, Number type, Kind kind, Param value) {
    switch (type) {
    case Number::f:
        return store_element(array, index, to_float(kind, value));
    case Number::d:
        return store_element(array, index, to_double(kind, value));
    case Number::b:
        return store_element(array, index, to_boolean(kind, value));
#if SPANGLE_FEATURE_FIXED_POINT
    case Number::x:
        return store_element(array, index, to_fixed(kind, value));
#endif
    default:
        return store_element(array, index, to_int(kind, value));
    }
}

} // namespace spangle::gl::convert

namespace spangle::gl {

Shape find_shape(const ShapeRow* rows, GLenum pname) {
    while (rows->names != 0 && pname - rows->name >= rows->names)
        ++rows;
    return {rows->kind, rows->count};
}

} // namespace spangle::gl

namespace spangle::gl::convert {

Params vector(Shape shape, const void* values, Number type) {
    Params out;
    for (; out.count < shape.count; ++out.count)
        out.v[out.count] = param(shape.kind, values, out.count, type);
    return out;
}

void store(Shape shape, const Params& found, void* out, Number type) {
    for (std::uint32_t i = 0; i < found.count; ++i)
        store_value(out, i, type, shape.kind, found.v[i]);
}

GLfloat to_float(Kind kind, Param value) {
    return numeric::to_float(kind == Kind::integer ? cast_i(value.integer()) : value.real());
}
GLdouble to_double(Kind kind, Param value) {
    if (kind != Kind::integer)
        return numeric::to_double(value.real());
    // A double holds every 32-bit integer; a Real would round it.
    const std::int32_t v = value.integer();
    if (v == 0)
        return std::bit_cast<double>(std::uint64_t{0});
    const std::uint32_t magnitude = numeric::abs_u32(v);
    const int top = 31 - numeric::clz32(magnitude);
    const std::uint64_t fraction = (std::uint64_t{magnitude} << (52 - top)) & ((std::uint64_t{1} << 52) - 1);
    return std::bit_cast<double>(std::uint64_t{v < 0} << 63 | static_cast<std::uint64_t>(1023 + top) << 52 |
                                 fraction);
}
GLint to_int(Kind kind, Param value) {
    switch (kind) {
    case Kind::integer:
        return value.integer();
    case Kind::color:
        return numeric::to_normalized_int(value.real());
    default:
        return numeric::to_i32_round(value.real());
    }
}
GLfixed to_fixed(Kind kind, Param value) {
    return kind == Kind::integer ? value.integer() : numeric::to_fixed16(value.real());
}
GLboolean to_boolean(Kind kind, Param value) {
    return kind == Kind::integer ? value.word != 0 : numeric::to_bool(value.real());
}

Real array_value(const Values& array, std::size_t index) {
    switch (array.type) {
    case GL_FLOAT:
        return numeric::from_float_bits(element<std::uint32_t>(array.at, index));
    case GL_DOUBLE:
        return numeric::from_double_bits(element<std::uint64_t>(array.at, index));
#if SPANGLE_FEATURE_FIXED_POINT
    case GL_FIXED:
        return cast_x(element<GLfixed>(array.at, index));
#endif
    default:
        return cast_i(element<GLint>(array.at, index));
    }
}

void store_array_value(const Values& array, std::size_t index, Kind kind, Param value) {
    store_value(const_cast<void*>(array.at), index,
                array.type == GL_FLOAT    ? Number::f
                : array.type == GL_DOUBLE ? Number::d
                : array.type == GL_FIXED  ? Number::x
                                          : Number::i,
                kind, value);
}

} // namespace spangle::gl::convert

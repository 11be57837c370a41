// Converts a component of a vertex array, by code for each type.
#pragma once

#include "gl/context/context.hpp"
#include "gl/vertex/client_memory.hpp"

namespace spangle::gl {

/// Converts a component to a Real. If `normalized`, an integer becomes a fraction, as for colours and
/// normals; otherwise it keeps its value (GL 1.3, table 2.6).
SPANGLE_RUN_CALL inline Real array_component(const std::uint8_t* at, GLenum type, bool normalized) {
    switch (array_type(type)) {
    case GL_FLOAT:
        return numeric::from_float_bits(read<std::uint32_t>(at));
    case GL_DOUBLE:
        return numeric::from_double_bits(read<std::uint64_t>(at));
    case GL_FIXED:
        return numeric::from_fixed16(read<std::int32_t>(at));
    case GL_BYTE:
        return normalized ? numeric::normalized_byte(read<std::int8_t>(at))
                          : numeric::from_i32(read<std::int8_t>(at));
    case GL_UNSIGNED_BYTE:
        return normalized ? numeric::normalized_ubyte(*at) : numeric::from_i32(*at);
    case GL_SHORT:
        return normalized ? numeric::normalized_short(read<std::int16_t>(at))
                          : numeric::from_i32(read<std::int16_t>(at));
    case GL_UNSIGNED_SHORT:
        return normalized ? numeric::normalized_ushort(read<std::uint16_t>(at))
                          : numeric::from_i32(read<std::uint16_t>(at));
    case GL_INT:
        return normalized ? numeric::normalized_int(read<std::int32_t>(at))
                          : numeric::from_i32(read<std::int32_t>(at));
    default:
        return normalized ? numeric::normalized_uint(read<std::uint32_t>(at))
                          : numeric::from_u32(read<std::uint32_t>(at));
    }
}

} // namespace spangle::gl

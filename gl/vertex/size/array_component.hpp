// Converts a component of a vertex array, by the code that also converts arguments.
#pragma once

#include "gl/api/convert.hpp"
#include "gl/context/context.hpp"
#include "gl/vertex/client_memory.hpp"

namespace spangle::gl {

/// Converts a component to a Real. If `normalized`, an integer becomes a fraction, as for colours and
/// normals; otherwise it keeps its value (GL 1.3, table 2.6).
/// The tokens of integer types follow each other from GL_BYTE on, signed and unsigned types in turn.
inline Real array_component(const std::uint8_t* at, GLenum type, bool normalized) {
    type = array_type(type);
    if (type == GL_FLOAT)
        return numeric::from_float_bits(read<std::uint32_t>(at));
    if (has_array_type(GL_DOUBLE) && type == GL_DOUBLE)
        return numeric::from_double(read<GLdouble>(at));
    if (has_array_type(GL_FIXED) && type == GL_FIXED)
        return numeric::from_fixed16(read<std::int32_t>(at));
    static_assert(GL_BYTE % 2 == 0 && GL_UNSIGNED_BYTE - GL_BYTE == 1 && GL_SHORT - GL_BYTE == 2 &&
                  GL_UNSIGNED_SHORT - GL_BYTE == 3 && GL_INT - GL_BYTE == 4 &&
                  GL_UNSIGNED_INT - GL_BYTE == 5);
    return convert::integer_at(at, (type - GL_BYTE) / 2, type % 2 == 0, normalized);
}

} // namespace spangle::gl

// The types that generated descriptors of command families use.
#pragma once

#include <cstdint>

#include <spangle/GL/gl.h>

#include "gl/context/error.hpp"
#include "gl/context/features.hpp"
#include "gl/context/threads.hpp"

namespace spangle::gl {

/// How NewList treats a family (GL 1.3, 5.4).
enum class Listing : std::uint8_t {
    words,       ///< arguments stored word by word
    attribute,   ///< packed into runs of vertices
    client_data, ///< a handwritten encoder, because client memory is read at compilation
    never,       ///< runs at once
};

/// The kind of a pname's values, which decides how they are converted (GL 1.3, 2.13 and 6.1.2).
enum class Kind : std::uint8_t { real, color, integer };

/// The kind and the number of the values that a pname takes. If `count` is 0, the pname is unknown.
struct Shape {
    Kind kind = Kind::real;
    std::uint8_t count = 0;
};

/// The shape that several consecutive pnames have. A row whose `names` is 0 ends the table of a family.
struct ShapeRow {
    std::uint16_t name = 0; ///< first token
    std::uint8_t names = 0;
    Kind kind : 4 = Kind::real;
    std::uint8_t count : 4 = 0;
};
Shape find_shape(const ShapeRow* rows, GLenum pname);

#if SPANGLE_THREADS

template <auto function> struct Sharing;
template <class R, class... A, R (*function)(Context&, A...)> struct Sharing<function> {
    static R run(Context& context, A... args) {
        const SharedObjects held(context);
        return function(context, args...);
    }
};

/// The function of a family, wrapped so that the lock of the shared objects is held while it runs.
template <auto function> inline constexpr auto sharing = &Sharing<function>::run;

#else

template <auto function> inline constexpr auto sharing = function;

#endif

} // namespace spangle::gl

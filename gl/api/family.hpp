// What the generated descriptors of command families are made of.
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
    client_data, ///< an encoder by hand, because it reads client memory now
    never,       ///< runs at once
};

/// What the values of a pname are; decides every conversion (GL 1.3, 2.13 and 6.1.2).
enum class Kind : std::uint8_t { real, color, integer };

/// Number of values a pname takes; 0 = unknown pname.
struct Shape {
    Kind kind = Kind::real;
    std::uint8_t count = 0;
};

/// Of pnames that follow each other; a row of none ends those of a family.
struct ShapeRow {
    std::uint16_t name = 0; ///< the first
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

/// A family's function, called with the shared objects held.
template <auto function> inline constexpr auto sharing = &Sharing<function>::run;

#else

template <auto function> inline constexpr auto sharing = function;

#endif

} // namespace spangle::gl

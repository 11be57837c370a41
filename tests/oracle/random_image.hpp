// Images of the program's in any layout, what is done to them on their way, and a window to read from.
#pragma once

#include "tests/oracle/random_values.hpp"
#include "tests/oracle/state_families.hpp"

namespace spangle::oracle {

struct Layout {
    GLenum format, type;
};
/// Any format and type of colours.
Layout color_layout(test::Random& random);

/// Any pixel storage for rows of `width` groups.
void store(test::Random& random, int width, bool pack);
/// Of bytes that lie one behind the other.
void store_tight();

/// Bytes, or floats a little beyond 0 and 1.
struct Client {
    alignas(8) GLubyte bytes[40000];
    Client(test::Random& random, GLenum type);
};

/// Scales and biases, and as they are initially.
void transfer(test::Random& random);
void untransferred();

/// Colours, depths and stencil values to read, copy and draw over.
void background(test::Random& random);

} // namespace spangle::oracle

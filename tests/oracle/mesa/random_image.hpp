// Images of the program in any layout, pixel transfer, and a background to read from.
#pragma once

#include "tests/oracle/mesa/random_values.hpp"
#include "tests/oracle/mesa/state_families.hpp"

namespace spangle::oracle {

struct Layout {
    GLenum format, type;
};
/// Returns any format and type of colours.
Layout color_layout(test::Random& random);

/// Sets any pixel storage for rows of `width` groups.
void store(test::Random& random, int width, bool pack);
/// Sets the pixel storage of images without gaps.
void store_tight();

/// Client memory with random bytes, or with floats in a range a little larger than 0 to 1.
struct Client {
    alignas(8) GLubyte bytes[40000];
    Client(test::Random& random, GLenum type);
};

/// Sets random scales and biases; untransferred() sets the initial ones.
void transfer(test::Random& random);
void untransferred();

/// Draws colours, depths and stencil values to read, copy and draw over.
void background(test::Random& random);

} // namespace spangle::oracle

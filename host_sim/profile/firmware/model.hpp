// A baked model as a program; `spangle profile` writes its constants.
#pragma once

#include <spangle/baked.hpp>

namespace spangle::measure {

extern const baked::Mesh& model_mesh;

struct Model {
    static void setup(int width, int height);
    static void draw(int frame);
};
inline constexpr Model model;

} // namespace spangle::measure

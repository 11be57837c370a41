// Small programs of public GL of which a profile is recorded. Each uses few systems of GL, other ones than
// the scenes use.
#pragma once

#include <spangle/GL/gl.h>

namespace spangle::programs {

struct Program {
    const char* name;
    void (*setup)(int width, int height);
    void (*draw)(int frame);
};

extern const Program gouraud_cube, sprites_only, lit_parallel, lit_perspective, terrain_fog, particles,
    cutaway, two_textures, wires, foliage, chrome;

inline constexpr const Program* all[] = {&gouraud_cube, &sprites_only, &lit_parallel, &lit_perspective,
                                         &terrain_fog,  &particles,    &cutaway,      &two_textures,
                                         &wires,        &foliage,      &chrome};

/// Sends a ball of radius 1 in strips; position and normal of a vertex are the same.
void ball();

} // namespace spangle::programs

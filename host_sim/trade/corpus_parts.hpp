// Parts that several programs of the corpus draw: a view, a sheet, a plane to the horizon, a sphere.
#pragma once

#include "boards/scenes/scene.hpp"

namespace spangle::trade {

/// Sets a view along -z from the origin, 90 degrees wide, and turns the depth test on.
void look(int width, int height, float nearest, float farthest);

/// Clears all planes and loads the identity.
void clear();

/// Draws a rectangle across the view at depth z, with another colour at each vertex.
void sheet(float left, float bottom, float right, float top, float z, float alpha);

/// Draws a plane from under the eye to the horizon, with a texture that repeats every metre.
void ground();

/// Draws a sphere of radius 1 with normals and texture coordinates, from that many rings of quads.
void sphere(int rings);

/// The programs of corpus_fragments.cpp and corpus_textures.cpp.
extern const scenes::Scene shadow_scene, outline_scene, equations_scene, patterns_scene, smooth_scene,
    cutout_scene;
extern const scenes::Scene combine_scene, mirror_scene, wraps_scene, volume_scene, spots_scene, decals_scene;

} // namespace spangle::trade

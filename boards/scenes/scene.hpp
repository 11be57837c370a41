// A scene: a program of public GL calls that draws frame f of a W x H picture. No scene clears more, or asks
// for more systems, than it needs; S1 to S9 are the benchmark set, with triangle and fragment counts that are
// known.
#pragma once

namespace spangle::scenes {

struct Scene {
    const char* id;    ///< what the command line calls it: "S4r"
    const char* title; ///< one line for people
    /// Sets all state the scene needs in a fresh context and makes its textures and lists.
    void (*setup)(int width, int height);
    /// Draws frame f >= 0, clears included. Frames do not depend on each other.
    void (*draw)(int frame);
};

/// All scenes, in the order of their ids.
struct SceneList {
    const Scene* first;
    int count;
    const Scene* begin() const { return first; }
    const Scene* end() const { return first + count; }
};
SceneList all();

/// The scene with this id, or null.
const Scene* find(const char* id);

extern const Scene clear, two_triangles, gouraud, plane, plane_rolled, plane_linear, gears, torus, sprites,
    wireframe, torus_textured, hud, rocket, tiny, cube;

} // namespace spangle::scenes

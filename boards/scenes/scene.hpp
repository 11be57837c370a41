// A scene is a program of public GL calls that draws frame f of a picture of W x H pixels. A scene clears no
// more buffers, and uses no more systems of GL, than it needs. S1 to S9 are the benchmark set; their counts
// of triangles and fragments are known.
#pragma once

namespace spangle::scenes {

struct Scene {
    const char* id;    ///< the name on command lines: "S4r"
    const char* title; ///< one line for people to read
    /// Sets all state that the scene needs in a fresh context, and makes its textures and lists.
    void (*setup)(int width, int height);
    /// Draws frame f >= 0, clears included. A frame does not depend on other frames.
    void (*draw)(int frame);
};

/// All scenes: S1 to S9, then the scenes that have names.
struct SceneList {
    const Scene* first;
    int count;
    const Scene* begin() const { return first; }
    const Scene* end() const { return first + count; }
};
SceneList all();

/// Returns the scene with this id, or null.
const Scene* find(const char* id);

extern const Scene clear, two_triangles, gouraud, plane, plane_rolled, plane_linear, gears, torus, sprites,
    wireframe, torus_textured, hud, rocket, tiny, cube;

} // namespace spangle::scenes

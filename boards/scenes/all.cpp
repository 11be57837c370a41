#include "boards/scenes/scene.hpp"

namespace spangle::scenes {

namespace {

bool same(const char* a, const char* b) {
    while (*a != '\0' && *a == *b) {
        ++a;
        ++b;
    }
    return *a == *b;
}

} // namespace

SceneList all() {
    static const Scene list[] = {clear,          two_triangles, gouraud, plane,   plane_linear,
                                 plane_rolled,   gears,         torus,   sprites, wireframe,
                                 torus_textured, hud,           rocket,  tiny,    cube};
    return {list, static_cast<int>(sizeof list / sizeof list[0])};
}

const Scene* find(const char* id) {
    for (const Scene& scene : all())
        if (same(scene.id, id))
            return &scene;
    return nullptr;
}

} // namespace spangle::scenes

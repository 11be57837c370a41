// S6, S8 and S9: the torus, lit, as wires, and textured in fog.
#include "boards/scenes/torus.hpp"

#include "boards/scenes/scene.hpp"
#include "boards/scenes/textures.hpp"
#include "boards/scenes/view.hpp"

namespace spangle::scenes {

namespace {

constexpr int fine_around = 72, fine_tube = 70, coarse_around = 36, coarse_tube = 20;
constexpr auto fine = make_torus<fine_around, fine_tube>(1.0, 0.45, 1.0, 1.0);
constexpr auto fine_strips = make_torus_strips<fine_around, fine_tube>();
constexpr auto coarse = make_torus<coarse_around, coarse_tube>(1.0, 0.45, 8.0, 4.0);
constexpr auto coarse_strips = make_torus_strips<coarse_around, coarse_tube>();

/// Indices of the wires: 72 x 70 segments of rings around the tube. make_axis_rings() gives 70 x 72 segments
/// around the axis.
constexpr auto make_tube_rings() {
    std::array<std::array<unsigned short, fine_tube + 1>, fine_around> rings{};
    for (unsigned u = 0; u < fine_around; ++u)
        for (unsigned v = 0; v <= fine_tube; ++v)
            rings[u][v] = static_cast<unsigned short>(u * (fine_tube + 1) + v);
    return rings;
}
constexpr auto make_axis_rings() {
    std::array<std::array<unsigned short, fine_around + 1>, fine_tube> rings{};
    for (unsigned v = 0; v < fine_tube; ++v)
        for (unsigned u = 0; u <= fine_around; ++u)
            rings[v][u] = static_cast<unsigned short>(u * (fine_tube + 1) + v);
    return rings;
}
constexpr auto tube_rings = make_tube_rings();
constexpr auto axis_rings = make_axis_rings();

template <class Mesh> void point_arrays_at(const Mesh& mesh) {
    const TorusVertex& v = mesh.vertices[0];
    glVertexPointer(3, GL_FLOAT, sizeof(TorusVertex), v.position);
    glNormalPointer(GL_FLOAT, sizeof(TorusVertex), v.normal);
    glTexCoordPointer(2, GL_FLOAT, sizeof(TorusVertex), v.texcoord);
    glEnableClientState(GL_VERTEX_ARRAY);
}

void light(const GLfloat (&material)[4]) {
    static constexpr GLfloat direction[4] = {0.4f, 0.6f, 0.7f, 0.0f};
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, direction);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, material);
    glEnableClientState(GL_NORMAL_ARRAY);
}

void setup_common(int width, int height) {
    clear_color();
    perspective(width, height, 2.0f, 10.0f);
    glEnable(GL_DEPTH_TEST);
}

void setup_torus(int width, int height) {
    setup_common(width, height);
    glEnable(GL_CULL_FACE);
    point_arrays_at(fine);
    light({0.85f, 0.55f, 0.25f, 1.0f});
}

void setup_wireframe(int width, int height) {
    setup_common(width, height);
    point_arrays_at(fine);
    glColor3f(1.0f, 0.8f, 0.2f);
}

void setup_textured(int width, int height) {
    static constexpr GLfloat clear[4] = {0.125f, 0.25f, 0.375f, 1.0f};
    setup_common(width, height);
    glEnable(GL_CULL_FACE);
    point_arrays_at(coarse);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    light({1.0f, 1.0f, 1.0f, 1.0f});
    make_checkerboard(GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 2.6f);
    glFogf(GL_FOG_END, 5.2f);
    glFogfv(GL_FOG_COLOR, clear);
}

/// Clears the picture, and places the torus of this frame.
void begin_frame(int frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0.0f, 0.12f, -3.75f);
    glRotatef(-45.0f, 1.0f, 0.0f, 0.0f);
    glRotatef(static_cast<float>(2 * (frame % 90)), 0.0f, 0.0f, 1.0f);
}

template <class Lists> void draw_each(GLenum mode, const Lists& lists) {
    for (const auto& list : lists)
        glDrawElements(mode, static_cast<GLsizei>(list.size()), GL_UNSIGNED_SHORT, list.data());
}

void draw_torus(int frame) {
    begin_frame(frame);
    draw_each(GL_TRIANGLE_STRIP, fine_strips);
}

void draw_wireframe(int frame) {
    begin_frame(frame);
    draw_each(GL_LINE_STRIP, tube_rings);
    draw_each(GL_LINE_STRIP, axis_rings);
}

void draw_textured(int frame) {
    begin_frame(frame);
    draw_each(GL_TRIANGLE_STRIP, coarse_strips);
}

} // namespace

const Scene torus{"S6", "lit torus of 10,080 triangles", setup_torus, draw_torus};
const Scene wireframe{"S8", "the torus as 10,080 lines with depth", setup_wireframe, draw_wireframe};
const Scene torus_textured{"S9", "textured, lit torus in fog", setup_textured, draw_textured};

} // namespace spangle::scenes

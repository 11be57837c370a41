// BAKED: a lit, textured model that lies in flash as `spangle bake` wrote it. It is small enough for boards
// with a few kilobytes of memory.
#include "boards/scenes/gl.hpp" // this header comes first, because it names the GL that draws the model

#include "boards/scenes/models/rocket.hpp"
#include "boards/scenes/scene.hpp"

namespace spangle::scenes {

namespace {

namespace model = baked::rocket;

void setup(int width, int height) {
    static constexpr GLfloat light[4] = {0.5f, 0.6f, 0.8f, 0.0f};
    glClearColor(0.05f, 0.07f, 0.16f, 1.0f);
    // The model has radius 1 and a distance of 4, and fits a square viewport in the middle. So the scene
    // computes no floats, for which small boards would need a library.
    const int side = width < height ? width : height;
    glViewport((width - side) / 2, (height - side) / 2, side, side);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-0.28, 0.28, -0.28, 0.28, 1.0, 8.0);
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    baked::load(model::textures[0]);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glEnable(GL_TEXTURE_2D);
    baked::scale_texcoords(model::mesh);
    glLoadIdentity();
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glEnable(GL_RESCALE_NORMAL);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    baked::material(model::parts[0]);
    baked::point_arrays(model::parts[0]);
}

void draw(int frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -4.0f);
    glRotatef(-32.0f, 0.0f, 0.0f, 1.0f);
    glRotatef(18.0f, 1.0f, 0.0f, 0.0f);
    glRotatef(static_cast<float>(4 * (frame % 90)), 0.0f, 1.0f, 0.0f);
    baked::scale_positions(model::mesh);
    baked::draw(model::parts[0]);
}

} // namespace

const Scene rocket{"BAKED", "a baked model: lit, textured, drawn from flash", setup, draw};

} // namespace spangle::scenes

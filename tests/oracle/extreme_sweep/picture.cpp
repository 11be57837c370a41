#include "tests/oracle/extreme_sweep/picture.hpp"

#include "gl/context/context.hpp"

#include <spangle/GL/gl.h>

namespace spangle::test {
namespace {

constexpr GLuint own_texture = 77;

void vertex(float x, float y, float z) {
    glTexCoord2f(x + 0.25F, 0.5F - y);
    glColor4f(0.5F + x / 2, 0.5F - y / 2, 0.7F, 0.8F);
    glNormal3f(x / 2, y / 2, 1);
    glVertex3f(x, y, z);
}

void pop_all(GLenum depth, GLint lowest, void (*pop)()) {
    GLint levels = 0;
    for (glGetIntegerv(depth, &levels); levels > lowest; --levels)
        pop();
}

void own_image() {
    GLubyte texels[4 * 4 * 3];
    for (unsigned i = 0; i < sizeof texels; ++i)
        texels[i] = static_cast<GLubyte>(40 + i * 37 % 200);
    glBindTexture(GL_TEXTURE_2D, own_texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

} // namespace

void draw_primitives() {
    glBegin(GL_TRIANGLES);
    vertex(-0.9F, -0.8F, 0.5F);
    vertex(0.8F, -0.6F, -0.5F);
    vertex(-0.1F, 0.9F, 0);
    glEnd();
    glBegin(GL_QUADS);
    vertex(-0.4F, -0.4F, 0.2F);
    vertex(0.9F, -0.5F, 0.1F);
    vertex(0.7F, 0.6F, -0.3F);
    vertex(-0.5F, 0.4F, 0.1F);
    glEnd();
    glBegin(GL_LINES);
    vertex(-0.9F, 0.8F, -0.9F);
    vertex(0.9F, -0.3F, -0.8F);
    glEnd();
    glBegin(GL_POINTS);
    vertex(0.3F, 0.7F, 0.6F);
    glEnd();
}

void leave_everything() {
    const gl::Context& context = *gl::current_context();
    if (context.inside_begin_end())
        glEnd();
    if (context.list.index != 0)
        glEndList();
    glEndQuery(GL_SAMPLES_PASSED);
    glRenderMode(GL_RENDER);
    pop_all(GL_ATTRIB_STACK_DEPTH, 0, glPopAttrib);
    pop_all(GL_CLIENT_ATTRIB_STACK_DEPTH, 0, glPopClientAttrib);
    for (const auto& [mode, depth] : {std::pair<GLenum, GLenum>{GL_PROJECTION, GL_PROJECTION_STACK_DEPTH},
                                      {GL_MODELVIEW, GL_MODELVIEW_STACK_DEPTH}}) {
        glMatrixMode(mode);
        pop_all(depth, 1, glPopMatrix);
        glLoadIdentity();
    }
    glMatrixMode(GL_TEXTURE);
    for (GLenum unit = gl::texture_units; unit-- > 0;) {
        glActiveTexture(GL_TEXTURE0 + unit);
        pop_all(GL_TEXTURE_STACK_DEPTH, 1, glPopMatrix);
        glLoadIdentity();
    }
    glMatrixMode(GL_MODELVIEW);
}

void draw_picture() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    own_image();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_FOG);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    draw_primitives();
    glDisable(GL_LIGHTING);
    glDisable(GL_TEXTURE_2D);
    glTranslatef(0.2F, 0.1F, 0);
    draw_primitives();
}

} // namespace spangle::test

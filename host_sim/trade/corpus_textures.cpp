// Programs of the corpus about what colours a fragment: environments, generated coordinates, wraps, images of
// other shapes, lights.
#include "host_sim/trade/corpus_parts.hpp"

#include <initializer_list>
#include <vector>

#include <spangle/GL/gl.h>

#include "boards/scenes/textures.hpp"

namespace spangle::trade {

namespace {

/// Makes an image of normals, as DOT3 reads them, with a bump in the middle of each cell of 8 texels.
void make_bumps() {
    constexpr int size = 32, bump = 8;
    std::vector<GLubyte> texels;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const int u = x % bump - bump / 2, v = y % bump - bump / 2;
            for (const int c : {128 + 24 * u, 128 + 24 * v, 230 - 6 * (u * u + v * v)})
                texels.push_back(static_cast<GLubyte>(c < 0 ? 0 : c > 255 ? 255 : c));
        }
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, size, size, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
}

void combine_setup(int w, int h) {
    look(w, h, 1, 60);
    make_bumps();
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_TEXTURE);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_RGB, GL_PRIMARY_COLOR);
    glActiveTexture(GL_TEXTURE1);
    scenes::make_checkerboard(GL_LINEAR);
    glEnable(GL_TEXTURE_2D);
    const GLfloat share[] = {0.3f, 0.5f, 0.7f, 1};
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, share);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_INTERPOLATE);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_PREVIOUS);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_RGB, GL_TEXTURE);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE2_RGB, GL_CONSTANT);
    glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_SRC_COLOR);
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 2);
    glActiveTexture(GL_TEXTURE0);
}
void combine_draw(int f) {
    constexpr float corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    clear();
    glTranslatef(0, 0, -2.5f);
    glRotatef(50 + 3 * static_cast<float>(f), 1, 0.5f, 0);
    glBegin(GL_QUADS);
    for (const auto& corner : corners) {
        glColor3f(0.5f + 0.3f * corner[0], 0.5f + 0.3f * corner[1], 0.9f);
        glMultiTexCoord2f(GL_TEXTURE0, 2 * corner[0], 2 * corner[1]);
        glMultiTexCoord2f(GL_TEXTURE1, corner[0] + 0.1f, corner[1]);
        glVertex3f(1.6f * corner[0], 1.3f * corner[1], 0);
    }
    glEnd();
}

void mirror_setup(int w, int h) {
    look(w, h, 2, 10);
    constexpr int size = 32;
    for (int face = 0; face < 6; ++face) {
        std::vector<GLubyte> texels;
        for (int i = 0; i < size * size; ++i)
            for (const int bit : {1, 2, 4})
                texels.push_back(
                    static_cast<GLubyte>(((face + 1) & bit) != 0 ? 120 + i % size * 4 : i / size * 6));
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face), 0, GL_RGB, size, size, 0,
                     GL_RGB, GL_UNSIGNED_BYTE, texels.data());
    }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    for (const GLenum axis : std::initializer_list<GLenum>{GL_S, GL_T, GL_R})
        glTexGeni(axis, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP);
    for (const GLenum axis :
         std::initializer_list<GLenum>{GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R})
        glEnable(axis);
    glEnable(GL_TEXTURE_CUBE_MAP);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
}
void mirror_draw(int f) {
    clear();
    glTranslatef(0, 0, -3.4f);
    glRotatef(9 * static_cast<float>(f), 1, 1, 0);
    sphere(20);
}

void wraps_setup(int w, int h) {
    look(w, h, 1, 60);
    scenes::make_checkerboard(GL_LINEAR);
    const GLfloat border[] = {0.9f, 0.1f, 0.6f, 0.5f};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_BLEND);
    const GLfloat env[] = {0.2f, 0.9f, 0.3f, 1};
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, env);
    glEnable(GL_TEXTURE_2D);
}
void wraps_draw(int f) {
    constexpr GLint wraps[] = {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT};
    clear();
    glTranslatef(0, 0, -2);
    glRotatef(25 + 4 * static_cast<float>(f), 0.3f, 1, 0);
    for (int i = 0; i < 10; ++i) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wraps[i % 5]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wraps[(i + i / 5) % 5]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, i < 5 ? GL_LINEAR : GL_NEAREST);
        const float x = static_cast<float>(i % 5) * 0.8f - 2, y = i < 5 ? -0.9f : 0.05f;
        glBegin(GL_QUADS);
        glColor3f(0.9f, 0.4f, 0.1f);
        glTexCoord2f(-1, -0.75f), glVertex3f(x, y, 0);
        glTexCoord2f(2, -0.75f), glVertex3f(x + 0.75f, y, 0);
        glColor3f(0.3f, 0.6f, 0.9f);
        glTexCoord2f(2, 1.75f), glVertex3f(x + 0.75f, y + 0.85f, -0.3f);
        glTexCoord2f(-1, 1.75f), glVertex3f(x, y + 0.85f, -0.3f);
        glEnd();
    }
}

void volume_setup(int w, int h) {
    look(w, h, 1, 60);
    constexpr int size = 16;
    std::vector<GLubyte> texels;
    for (int i = 0; i < size * size * size; ++i)
        for (const int c : {i % size * 17, i / size % size * 17, i / size / size * 17})
            texels.push_back(static_cast<GLubyte>(c));
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB, size, size, size, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_3D);
}
void volume_draw(int f) {
    constexpr float corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    clear();
    glTranslatef(0, 0, -3);
    glRotatef(30 + 6 * static_cast<float>(f), 1, 1, 0.3f);
    glBegin(GL_QUADS);
    for (int i = 0; i < 5; ++i)
        for (const auto& corner : corners) {
            const float z = static_cast<float>(i) * 0.4f - 0.8f;
            glTexCoord3f(0.5f + 0.5f * corner[0], 0.5f + 0.5f * corner[1], 0.5f + 0.5f * z);
            glVertex3f((1.5f - 0.2f * static_cast<float>(i)) * corner[0], corner[1], z);
        }
    glEnd();
}

void spots_setup(int w, int h) {
    look(w, h, 2, 20);
    const GLfloat colors[2][4] = {{1, 0.6f, 0.3f, 1}, {0.3f, 0.6f, 1, 1}}, shine[] = {0.9f, 0.9f, 0.9f, 1};
    for (int i = 0; i < 2; ++i) {
        const GLenum name = GL_LIGHT0 + static_cast<GLenum>(i);
        const GLfloat position[] = {i == 0 ? -1.5f : 1.5f, 1, -0.5f, 1},
                      aim[] = {i == 0 ? 0.5f : -0.5f, -0.4f, -1};
        glLightfv(name, GL_POSITION, position);
        glLightfv(name, GL_SPOT_DIRECTION, aim);
        glLightf(name, GL_SPOT_CUTOFF, 40);
        glLightf(name, GL_SPOT_EXPONENT, 12);
        glLightf(name, GL_LINEAR_ATTENUATION, 0.2f);
        glLightfv(name, GL_DIFFUSE, colors[i]);
        glLightfv(name, GL_SPECULAR, colors[i]);
        glEnable(name);
    }
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glMaterialfv(GL_FRONT, GL_SPECULAR, shine);
    glMaterialf(GL_FRONT, GL_SHININESS, 60);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_LIGHTING);
    scenes::make_checkerboard(GL_LINEAR);
    glEnable(GL_TEXTURE_2D);
}
void spots_draw(int f) {
    clear();
    glTranslatef(0, 0, -3.6f);
    glRotatef(12 * static_cast<float>(f), 0, 1, 0.4f);
    glColor3f(0.9f, 0.9f, 0.9f);
    sphere(24);
}

void decals_setup(int w, int h) {
    look(w, h, 1, 60);
    scenes::make_ball();
    glEnable(GL_TEXTURE_2D);
    const GLfloat color[] = {0.7f, 0.7f, 0.8f, 1};
    glFogfv(GL_FOG_COLOR, color);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 1);
    glFogf(GL_FOG_END, 9);
    glEnable(GL_FOG);
}
void decals_draw(int f) {
    constexpr GLint modes[] = {GL_DECAL, GL_ADD, GL_MODULATE, GL_REPLACE};
    clear();
    glRotatef(3 + 5 * static_cast<float>(f), 0, 0, 1);
    for (int i = 0; i < 16; ++i) {
        const int row = i / 4;
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, modes[i % 4]);
        const float x = static_cast<float>(i % 4) * 0.9f - 1.8f, y = static_cast<float>(row) * 0.6f - 1.2f;
        glBegin(GL_TRIANGLE_STRIP);
        glColor4f(0.9f, 0.2f, 0.1f, 0.8f);
        glTexCoord2f(0, 0), glVertex3f(x, y, -1.5f);
        glTexCoord2f(1, 0), glVertex3f(x + 0.8f, y, -2.5f);
        glColor4f(0.1f, 0.4f, 0.9f, 0.6f);
        glTexCoord2f(0, 1), glVertex3f(x, y + 0.6f, -2);
        glTexCoord2f(1, 1), glVertex3f(x + 0.8f, y + 0.6f, -6);
        glEnd();
    }
}

} // namespace

const scenes::Scene combine_scene = {"COMBINE", "bumps by DOT3 and a second unit that interpolates",
                                     combine_setup, combine_draw};
const scenes::Scene mirror_scene = {"MIRROR", "a sphere that reflects a cube map", mirror_setup, mirror_draw};
const scenes::Scene wraps_scene = {"WRAPS", "the five wrap modes, with a border colour", wraps_setup,
                                   wraps_draw};
const scenes::Scene volume_scene = {"VOLUME", "slices of a texture of three dimensions", volume_setup,
                                    volume_draw};
const scenes::Scene spots_scene = {"SPOTS", "two spot lights on a textured sphere", spots_setup, spots_draw};
const scenes::Scene decals_scene = {"DECALS", "four texture environments in linear fog", decals_setup,
                                    decals_draw};

} // namespace spangle::trade

#include "host_sim/trade/corpus.hpp"

#include <cmath>
#include <vector>

#include <spangle/GL/gl.h>

#include "boards/scenes/textures.hpp"
#include "host_sim/trade/corpus_parts.hpp"

namespace spangle::trade {

namespace {

/// Makes a texture in which every level has a colour of its own.
void make_levels(GLenum filter) {
    std::vector<GLubyte> texels;
    for (int level = 0, size = 64; size != 0; ++level, size /= 2) {
        texels.clear();
        for (int i = 0; i < size * size; ++i) {
            const bool dark = ((i % size * 8 / size) ^ (i / size * 8 / size)) % 2 != 0;
            for (const int bit : {1, 2, 4})
                texels.push_back(
                    static_cast<GLubyte>(((level + 1) & bit) != 0 ? (dark ? 140 : 250) : (dark ? 20 : 60)));
        }
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGB, size, size, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
}

void ground_setup(int w, int h) {
    look(w, h, 0.5f, 2000);
    scenes::make_checkerboard(GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
}
void ground_draw(int f) {
    clear();
    glRotatef(static_cast<float>(7 * f), 0, 0, 1);
    ground();
}
const scenes::Scene ground_scene = {"GROUND", "a textured plane to the horizon, rolled", ground_setup,
                                    ground_draw};

void levels_setup(int w, int h) {
    look(w, h, 0.5f, 2000);
    make_levels(GL_NEAREST_MIPMAP_NEAREST);
}
void smooth_levels_setup(int w, int h) {
    look(w, h, 0.5f, 2000);
    make_levels(GL_LINEAR_MIPMAP_LINEAR);
}
const scenes::Scene levels_scene = {"LEVELS", "mipmaps of a plane, a colour a level", levels_setup,
                                    ground_draw};
const scenes::Scene trilinear_scene = {"TRILINEAR", "the same, between levels", smooth_levels_setup,
                                       ground_draw};

void sphere_setup(int w, int h) {
    look(w, h, 2, 10);
    const GLfloat position[] = {1, 2, 3, 0}, shine[] = {0.6f, 0.6f, 0.6f, 1}, body[] = {0.7f, 0.3f, 0.2f, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glMaterialfv(GL_FRONT, GL_SPECULAR, shine);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, body);
    glMaterialf(GL_FRONT, GL_SHININESS, 30);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
}
void sphere_draw(int f) {
    clear();
    glTranslatef(0, 0, -3.2f);
    glRotatef(static_cast<float>(11 * f), 1, 1, 0);
    sphere(36); // 36 rings make 5184 triangles
}
const scenes::Scene sphere_scene = {"SPHERE", "a lit sphere of 5184 triangles with a highlight", sphere_setup,
                                    sphere_draw};

void fog_setup(int w, int h) {
    look(w, h, 1, 60);
    const GLfloat color[] = {0.125f, 0.25f, 0.375f, 1};
    glFogfv(GL_FOG_COLOR, color);
    glFogi(GL_FOG_MODE, GL_EXP2);
    glFogf(GL_FOG_DENSITY, 0.06f);
    glEnable(GL_FOG);
}
void fog_draw(int f) {
    clear();
    glRotatef(static_cast<float>(5 * f), 0, 0, 1);
    for (int i = 0; i < 12; ++i)
        sheet(-9 + static_cast<float>(i), -1, -8 + static_cast<float>(i) * 2, 1,
              static_cast<float>(-3 - 3 * i), 1);
    ground();
}
const scenes::Scene fog_scene = {"FOG", "posts on a plane in exponential fog", fog_setup, fog_draw};

void blend_setup(int w, int h) {
    look(w, h, 1, 60);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
}
void blend_draw(int f) {
    constexpr GLenum factors[][2] = {{GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA},
                                     {GL_SRC_ALPHA, GL_ONE},
                                     {GL_ZERO, GL_SRC_COLOR},
                                     {GL_ONE_MINUS_DST_COLOR, GL_ONE}};
    clear();
    for (int i = 0; i < 16; ++i) {
        glBlendFunc(factors[i % 4][0], factors[i % 4][1]);
        const float at = static_cast<float>((7 * i + f) % 9) * 0.3f - 1.6f;
        sheet(at, at * 0.6f - 0.5f, at + 1.2f, at * 0.6f + 0.7f, -1.5f,
              0.15f + 0.05f * static_cast<float>(i));
    }
}
const scenes::Scene blend_scene = {"BLENDS", "sixteen sheets blended in four ways", blend_setup, blend_draw};

void clip_setup(int w, int h) {
    sphere_setup(w, h);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glEnable(GL_CLIP_PLANE0);
    glEnable(GL_CLIP_PLANE1);
}
void clip_draw(int f) {
    const GLdouble first[] = {1, 0.4, 0, 0.3}, second[] = {-0.2, 1, 0.3, 0.4};
    clear();
    glTranslatef(0, 0, -2.6f);
    glClipPlane(GL_CLIP_PLANE0, first);
    glClipPlane(GL_CLIP_PLANE1, second);
    glRotatef(static_cast<float>(11 * f), 1, 1, 0);
    sphere(14);
}
const scenes::Scene clip_scene = {"CLIPPED", "a sphere cut by two planes and the near one", clip_setup,
                                  clip_draw};

void offset_setup(int w, int h) {
    look(w, h, 1, 100);
    glDepthFunc(GL_LEQUAL);
}
void offset_draw(int f) {
    clear();
    glRotatef(static_cast<float>(9 * f), 0, 0, 1);
    glEnable(GL_POLYGON_OFFSET_FILL);
    for (int i = 0; i < 4; ++i) { // four sheets in one plane; only their offsets make each nearer
        const float at = static_cast<float>(i) * 0.7f - 2;
        glPolygonOffset(static_cast<float>(-i), static_cast<float>(-i));
        glPushMatrix();
        glTranslatef(0, 0, -4);
        glRotatef(70, 1, 0, 0);
        sheet(at, at, at + 2, at + 2, 0, 1);
        glPopMatrix();
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
}
const scenes::Scene offset_scene = {"OFFSET", "sheets in one plane, told apart by offsets", offset_setup,
                                    offset_draw};

void lines_setup(int w, int h) {
    look(w, h, 1, 60);
}
void lines_draw(int f) {
    clear();
    glTranslatef(0, 0, -2);
    for (int i = 0; i < 48; ++i) {
        const float a = static_cast<float>(i) * 0.131f + static_cast<float>(f) * 0.01f;
        glLineWidth(static_cast<float>(1 + i % 4));
        glBegin(GL_LINES);
        glColor3f(1, 0.8f, 0.2f), glVertex3f(0.1f * std::cos(a), 0.1f * std::sin(a), 0);
        glColor3f(0.2f, 0.8f, 1), glVertex3f(3 * std::cos(a), 3 * std::sin(a), -4 * std::sin(3 * a));
        glEnd();
    }
}
const scenes::Scene lines_scene = {"LINES", "a star of lines of four widths, into depth", lines_setup,
                                   lines_draw};

} // namespace

scenes::SceneList corpus() {
    static const scenes::Scene programs[] = {
        blend_scene,     clip_scene,     combine_scene, cutout_scene, decals_scene, equations_scene,
        fog_scene,       ground_scene,   levels_scene,  lines_scene,  mirror_scene, offset_scene,
        outline_scene,   patterns_scene, shadow_scene,  smooth_scene, sphere_scene, spots_scene,
        trilinear_scene, volume_scene,   wraps_scene};
    return {programs, static_cast<int>(sizeof programs / sizeof *programs)};
}

bool needs_stencil(const scenes::Scene& program) {
    return program.draw == shadow_scene.draw || program.draw == outline_scene.draw;
}

} // namespace spangle::trade

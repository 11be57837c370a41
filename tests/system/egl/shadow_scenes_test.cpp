// Draws random scenes through all of GL with a double beside every number. Continuous values stay within
// their bounds everywhere. Choices (a texel, a level) may differ where two are equally near, and do so
// rarely.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/reference.hpp>

#include "raster/reference/shadow.hpp"

namespace spangle::test {
namespace {

using Stage = raster::ShadowStage;

/// Repeatable random choices; each call is a statement of its own.
class Dice {
  public:
    explicit Dice(unsigned seed) : random_(seed) {}
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    bool often() { return below(2) != 0; }
    GLfloat between(GLfloat low, GLfloat high) {
        return low + (high - low) * static_cast<GLfloat>(below(10001)) / 10000;
    }
    template <std::size_t N> GLenum one_of(const GLenum (&tokens)[N]) { return tokens[below(int{N})]; }
    struct Four {
        GLfloat v[4];
    };
    Four four(GLfloat low, GLfloat high, GLfloat last) {
        Four f{};
        for (GLfloat& c : f.v)
            c = between(low, high);
        f.v[3] = last;
        return f;
    }

  private:
    std::mt19937 random_;
};

void set_lights(Dice& dice) {
    for (const GLenum light : {GL_LIGHT0, GL_LIGHT1}) {
        if (dice.often())
            glEnable(light);
        glLightfv(light, GL_POSITION, dice.four(-3, 3, dice.often() ? 1.0f : 0.0f).v);
        glLightfv(light, GL_DIFFUSE, dice.four(0, 1, 1).v);
        glLightfv(light, GL_SPECULAR, dice.four(0, 1, 1).v);
        if (dice.often())
            glLightf(light, GL_LINEAR_ATTENUATION, dice.between(0, 0.5f));
        if (dice.below(3) != 0)
            continue;
        glLightf(light, GL_SPOT_CUTOFF, dice.between(10, 90));
        glLightfv(light, GL_SPOT_DIRECTION, dice.four(-1, 1, 0).v);
        glLightf(light, GL_SPOT_EXPONENT, dice.between(0, 20));
    }
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, dice.below(2));
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, dice.below(2));
    if (dice.often())
        glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glMaterialfv(GL_FRONT, GL_SPECULAR, dice.four(0, 1, 1).v);
    glMaterialfv(GL_BACK, GL_DIFFUSE, dice.four(0, 1, 1).v);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, dice.between(0, 60));
}

void set_texture(Dice& dice) {
    const GLenum format = dice.one_of({GL_RGBA, GL_RGB, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_ALPHA});
    const int log2_width = dice.below(6), log2_height = dice.below(6);
    const bool mipmaps = dice.often();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int level = 0; level <= (mipmaps ? std::max(log2_width, log2_height) : 0); ++level) {
        const int width = 1 << std::max(0, log2_width - level),
                  height = 1 << std::max(0, log2_height - level);
        std::vector<GLubyte> texels(static_cast<std::size_t>(4 * width * height));
        for (GLubyte& t : texels)
            t = static_cast<GLubyte>(dice.below(256));
        glTexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(format), width, height, 0, format,
                     GL_UNSIGNED_BYTE, texels.data());
    }
    const auto set = [](GLenum name, GLenum value) {
        glTexParameteri(GL_TEXTURE_2D, name, static_cast<GLint>(value));
    };
    const GLenum wraps[] = {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER};
    set(GL_TEXTURE_WRAP_S, dice.one_of(wraps));
    set(GL_TEXTURE_WRAP_T, dice.one_of(wraps));
    set(GL_TEXTURE_MAG_FILTER, dice.one_of({GL_NEAREST, GL_LINEAR}));
    set(GL_TEXTURE_MIN_FILTER, mipmaps ? dice.one_of({GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST,
                                                      GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR})
                                       : dice.one_of({GL_NEAREST, GL_LINEAR}));
    const GLenum environment = dice.one_of({GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD});
    // DECAL is defined for RGB and RGBA only (GL 1.3, table 3.23).
    const bool undefined = environment == GL_DECAL && format != GL_RGB && format != GL_RGBA;
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
              static_cast<GLint>(undefined ? GLenum{GL_MODULATE} : environment));
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, dice.four(0, 1, 0.5f).v);
}

void set_fragments(Dice& dice) {
    for (const GLenum what : {GL_DEPTH_TEST, GL_LIGHTING, GL_TEXTURE_2D, GL_FOG, GL_BLEND, GL_NORMALIZE,
                              GL_COLOR_MATERIAL, GL_CULL_FACE})
        if (dice.below(what == GL_CULL_FACE ? 5 : 2) == 0)
            glEnable(what);
    if (dice.below(3) == 0)
        glShadeModel(GL_FLAT);
    glFogi(GL_FOG_MODE, static_cast<GLint>(dice.one_of({GL_LINEAR, GL_EXP, GL_EXP2})));
    glFogf(GL_FOG_DENSITY, dice.between(0.05f, 0.6f));
    glFogf(GL_FOG_START, dice.between(0, 3));
    glFogf(GL_FOG_END, dice.between(4, 10));
    glFogfv(GL_FOG_COLOR, dice.four(0, 1, 1).v);
    const GLenum source = dice.one_of({GL_ONE, GL_SRC_ALPHA, GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR, GL_ZERO});
    glBlendFunc(source, dice.one_of({GL_ZERO, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_SRC_COLOR}));
}

void set_view(Dice& dice) {
    glMatrixMode(GL_PROJECTION);
    if (dice.below(3) != 0)
        glFrustum(-1, 1, -1, 1, 1.5, 30);
    else
        glOrtho(-2, 2, -2, 2, -9, 9);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0, 0, -4);
    const Dice::Four axis = dice.four(-1, 1, 1);
    glRotatef(dice.between(0, 360), axis.v[0], axis.v[1], axis.v[2]);
    if (dice.below(4) != 0)
        return;
    glMatrixMode(GL_TEXTURE);
    glRotatef(dice.between(0, 360), 0, 0, 1);
    glMatrixMode(GL_MODELVIEW);
}

/// Vertices lie on a grid, so hardly any triangle is thin before it is turned.
void draw_primitives(Dice& dice) {
    for (int primitive = 0; primitive < 6; ++primitive) {
        glPointSize(static_cast<GLfloat>(1 + dice.below(9)));
        glLineWidth(static_cast<GLfloat>(1 + dice.below(4)));
        glBegin(static_cast<GLenum>(dice.below(GL_POLYGON + 1)));
        for (int v = 0; v < 8; ++v) {
            if (dice.below(3) != 0)
                glColor4fv(dice.four(0, 1, 0.7f).v);
            if (dice.below(3) != 0)
                glNormal3fv(dice.four(-1, 1, 0).v);
            glTexCoord2fv(dice.four(-2, 2, 0).v);
            const int x = dice.below(17), y = dice.below(17), z = dice.below(9);
            glVertex3f(static_cast<GLfloat>(x - 8) * 0.3f, static_cast<GLfloat>(y - 8) * 0.3f,
                       static_cast<GLfloat>(z - 4) * 0.4f);
        }
        glEnd();
    }
}

raster::ShadowReport draw_scene(unsigned seed) {
    Dice dice(seed);
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    EXPECT_TRUE(eglInitialize(display, nullptr, nullptr));
    const EGLint wish[] = {EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_ALPHA_SIZE,
                           8 * dice.below(2),
                           EGL_DEPTH_SIZE,
                           16 + 8 * dice.below(2),
                           EGL_PRECISION_SPANGLE,
                           EGL_PRECISION_SHADOW_SPANGLE,
                           EGL_NONE};
    const EGLint size[] = {EGL_WIDTH, 64, EGL_HEIGHT, 64, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    EXPECT_TRUE(eglChooseConfig(display, wish, &config, 1, &count));
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    EXPECT_TRUE(eglMakeCurrent(display, surface, surface, context));
    set_fragments(dice);
    set_lights(dice);
    set_texture(dice);
    set_view(dice);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    raster::ShadowReport report;
    raster::report_shadow(&report);
    draw_primitives(dice);
    raster::report_shadow(nullptr);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << seed;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    eglDestroySurface(display, surface);
    return report;
}

struct Bound {
    Stage stage;
    double worst, rms;
};
constexpr double half_step = 0.5 / 256 + 1e-5, any = 1e9;
/// The share of pixels that may exceed a bound: a triangle seen edge-on is interpolated along its length only
/// (Setup<Fixed>::thin_aspect).
constexpr double few = 0x1p-8;
constexpr Bound bounds[] = {
    {Stage::vertex_color, 0x1p-17, 0x1p-19},
    {Stage::vertex_coord, 0x1p-18, 0x1p-20},
    {Stage::vertex_fog, 0x1p-25, 0x1p-27},
    {Stage::window_x, half_step, half_step},
    {Stage::window_y, half_step, half_step},
    {Stage::snapping, 1, 0.25},
    {Stage::window_z, 0x1p-24, 0x1p-26},
    {Stage::inverse_w, 0x1p-24, 0x1p-26},
    {Stage::depth, any, few},
    {Stage::primary, any, few},
    {Stage::coord0, any, 0x1p-3},
    {Stage::lod0, any, 0.15},
    {Stage::texture0, any, 0x1p-5},
    {Stage::color_sum, any, 0x1p-5},
    {Stage::fog_factor, any, few},
    {Stage::fog, any, 0x1p-5},
    {Stage::blend, any, 0x1p-5},
};

TEST(ShadowScenes, RandomOnesStayWithinTheirBounds) {
    use_reference_engines();
    std::uint64_t values[raster::shadow_stages] = {};
    for (unsigned seed = 0; seed < 200; ++seed) {
        raster::ShadowReport report = draw_scene(seed);
        for (const Bound& bound : bounds) {
            const raster::ShadowRecord& r = report[bound.stage];
            EXPECT_LE(r.worst, bound.worst) << name_of(bound.stage) << " of scene " << seed;
            EXPECT_LE(r.rms(), bound.rms) << name_of(bound.stage) << " of scene " << seed;
            values[static_cast<unsigned>(bound.stage)] += r.count;
        }
    }
    for (const Bound& bound : bounds)
        EXPECT_GT(values[static_cast<unsigned>(bound.stage)], 1000u) << name_of(bound.stage);
}

} // namespace
} // namespace spangle::test

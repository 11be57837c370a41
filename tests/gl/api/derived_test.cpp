// Derived state follows every change of state. A context that changes state, changes it back and pops it must
// draw what a new context draws that was given the same state alone.
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>

#include "gl/context/features.hpp"
#include "tests/support/random.hpp"

#if SPANGLE_FEATURE_ATTRIB_STACKS

namespace {

constexpr bool whole = sizeof SPANGLE_LEFT_OUT == 1; // whether this build has all optional systems

constexpr int side = 24;

struct Change {
    std::string name;
    std::function<void()> apply;
};

struct Bound {
    EGLSurface surface;
    EGLContext context;
};

struct Derived : testing::Test {
    EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    std::vector<GLushort> elements = {0, 1, 2, 2, 1, 3};
    std::vector<GLfloat> arrays;

    void SetUp() override {
        ASSERT_EQ(eglInitialize(display, nullptr, nullptr), EGLBoolean{EGL_TRUE});
        spangle::test::Random random{9};
        for (int vertex = 0; vertex < 4; ++vertex) {
            for (int c = 0; c < 2 + 4 + 3; ++c) // two texture coordinates, four colours, three of the normal
                arrays.push_back(static_cast<GLfloat>(random.below(100)) / 100);
            for (const float at : {vertex % 2 * 1.6f - 0.8f, vertex / 2 * 1.6f - 0.8f, vertex * 0.2f - 0.3f})
                arrays.push_back(at);
        }
    }
    void TearDown() override {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglTerminate(display);
    }
    /// Makes a new current context and surface, with textures of two sizes bound to two units.
    Bound start(int color_bits) {
        const EGLint wishes[] = {EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT,
                                 EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_RED_SIZE,
                                 color_bits,
                                 EGL_DEPTH_SIZE,
                                 16,
                                 EGL_STENCIL_SIZE,
                                 8,
                                 EGL_NONE};
        const EGLint size[] = {EGL_WIDTH, side, EGL_HEIGHT, side, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint n = 0;
        EXPECT_TRUE(eglChooseConfig(display, wishes, &config, 1, &n) == EGL_TRUE && n == 1);
        const Bound bound = {eglCreatePbufferSurface(display, config, size),
                             eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr)};
        EXPECT_EQ(eglMakeCurrent(display, bound.surface, bound.surface, bound.context), EGLBoolean{EGL_TRUE});
        set_texture(5);
        return bound;
    }
    void end(const Bound& bound) {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, bound.context);
        eglDestroySurface(display, bound.surface);
    }
    static void set_texture(unsigned seed, GLenum format = GL_RGBA) {
        spangle::test::Random random{seed};
        std::vector<GLubyte> texels(8 * 8 * 4);
        for (GLubyte& texel : texels)
            texel = static_cast<GLubyte>(random.below(256));
        glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), 8, 8, 0, format, GL_UNSIGNED_BYTE,
                     texels.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    }
    static void clear() { glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT); }
    /// Returns what the state makes of two triangles from arrays, a line and a point, or of the triangles
    /// alone. Some state of fragments is derived whenever the kind of primitive changes. Triangles alone do
    /// not change it.
    std::vector<GLubyte> draw(bool triangles_alone = false) {
        const GLenum changed = glGetError(); // a build refuses changes of systems that it does not have
        EXPECT_TRUE(changed == GL_NO_ERROR || (!whole && changed == GL_INVALID_OPERATION)) << changed;
        glInterleavedArrays(GL_T2F_C4F_N3F_V3F, 0, arrays.data());
        glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, elements.data());
        glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, elements.data());
        if (!triangles_alone)
            draw_line_and_point();
        std::vector<GLubyte> out(side * side * 4);
        glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        return out;
    }
    static void draw_line_and_point() {
        glBegin(GL_LINES);
        glColor4f(0.9f, 0.5f, 0.1f, 0.6f);
        glVertex3f(-0.9f, 0.7f, -0.6f);
        glVertex3f(0.9f, -0.4f, 0.6f);
        glEnd();
        glBegin(GL_POINTS);
        glVertex3f(0.2f, 0.3f, -0.9f);
        glEnd();
    }
    void pop_each_change(const std::vector<Change>& changes, bool shown, bool triangles_alone);

    /// Number of changes that were visible.
    int visible_changes = 0;
};

std::vector<Change> all_changes() {
    std::vector<Change> all;
    for (const GLenum cap : {GL_ALPHA_TEST,     GL_BLEND,           GL_COLOR_LOGIC_OP,
                             GL_COLOR_MATERIAL, GL_COLOR_SUM,       GL_CULL_FACE,
                             GL_DEPTH_TEST,     GL_DITHER,          GL_FOG,
                             GL_LIGHTING,       GL_LINE_SMOOTH,     GL_LINE_STIPPLE,
                             GL_NORMALIZE,      GL_POINT_SMOOTH,    GL_POLYGON_OFFSET_FILL,
                             GL_POLYGON_SMOOTH, GL_POLYGON_STIPPLE, GL_SCISSOR_TEST,
                             GL_STENCIL_TEST,   GL_TEXTURE_2D,      GL_TEXTURE_GEN_S,
                             GL_CLIP_PLANE0,    GL_LIGHT0,          GL_POINT_SPRITE})
        all.push_back({"switch " + std::to_string(cap), [cap] {
                           if (glIsEnabled(cap) == GL_TRUE)
                               glDisable(cap);
                           else
                               glEnable(cap);
                       }});
    const auto add = [&](const char* name, std::function<void()> apply) {
        all.push_back({name, std::move(apply)});
    };
    add("viewport", [] { glViewport(3, 4, 15, 12); });
    add("scissor box", [] { glScissor(5, 5, 9, 12); });
    add("depth range", [] { glDepthRange(0.2, 0.4); });
    add("shade model", [] { glShadeModel(GL_FLAT); });
    add("front face", [] { glFrontFace(GL_CW); });
    add("cull mode", [] { glCullFace(GL_FRONT); });
    add("polygon mode", [] { glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); });
    add("polygon offset", [] { glPolygonOffset(2, 300); });
    add("line width", [] { glLineWidth(3); });
    add("stipple", [] { glLineStipple(2, 0x3333); });
    add("point size", [] { glPointSize(6); });
    add("blend", [] { glBlendFunc(GL_SRC_ALPHA, GL_ONE); });
    add("equation", [] { glBlendEquation(GL_FUNC_REVERSE_SUBTRACT); });
    add("alpha", [] { glAlphaFunc(GL_GREATER, 0.5f); });
    add("depth", [] { glDepthFunc(GL_GREATER); });
    add("depth mask", [] { glDepthMask(GL_FALSE); });
    add("stencil", [] { glStencilFunc(GL_NOTEQUAL, 0, 0xFF); });
    add("logic", [] { glLogicOp(GL_XOR); });
    add("mask", [] { glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE); });
    add("fog", [] { glFogi(GL_FOG_MODE, GL_LINEAR), glFogf(GL_FOG_END, 0.4f); });
    add("hint", [] { glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_FASTEST); });
    add("environment", [] { glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL); });
    add("filter", [] { glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST); });
    add("wrap", [] { glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE); });
    add("generation", [] { glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR); });
    add("light", [] {
        const GLfloat red[] = {1, 0.2f, 0.1f, 1};
        glLightfv(GL_LIGHT0, GL_DIFFUSE, red);
    });
    add("material", [] {
        const GLfloat green[] = {0.2f, 0.9f, 0.1f, 1};
        glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, green);
    });
    add("ambient", [] {
        const GLfloat blue[] = {0.1f, 0.2f, 0.9f, 1};
        glLightModelfv(GL_LIGHT_MODEL_AMBIENT, blue);
    });
    add("clip plane", [] {
        const GLdouble plane[] = {1, 0.3, 0, 0.1};
        glClipPlane(GL_CLIP_PLANE0, plane);
    });
    add("reference of points", [] { glPointParameterf(GL_POINT_SIZE_MIN, 3); });
    return all;
}

/// Enables everything, so that each change is visible.
void show_all() {
    for (const GLenum cap :
         {GL_DEPTH_TEST, GL_TEXTURE_2D, GL_BLEND, GL_FOG, GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE})
        glEnable(cap);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    const GLfloat ambient[] = {0.6f, 0.7f, 0.8f, 1};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    const GLdouble plane[] = {1, 0.3, 0, 0.1}; // visible as soon as a change enables it
    glClipPlane(GL_CLIP_PLANE0, plane);
}

void Derived::pop_each_change(const std::vector<Change>& changes, bool shown, bool triangles_alone) {
    for (const int bits : {5, 8}) {
        std::vector<std::vector<GLubyte>> alone;
        for (const Change& change : changes) {
            const Bound bound = start(bits);
            if (shown)
                show_all();
            clear();
            change.apply();
            alone.push_back(draw(triangles_alone));
            end(bound);
        }
        const Bound bound = start(bits);
        if (shown)
            show_all();
        clear();
        const std::vector<GLubyte> before = draw(triangles_alone);
        for (std::size_t i = 0; i < changes.size(); ++i) {
            clear();
            glPushAttrib(GL_ALL_ATTRIB_BITS);
            changes[i].apply();
            ASSERT_EQ(draw(triangles_alone), alone[i]) << changes[i].name;
            glPopAttrib();
            clear();
            ASSERT_EQ(draw(triangles_alone), before) << "after " << changes[i].name;
            visible_changes += alone[i] != before ? 1 : 0;
        }
        end(bound);
    }
}

TEST_F(Derived, StateThatIsPoppedIsDrawnAgain) {
    const std::vector<Change> changes = all_changes();
    for (const bool shown : {false, true})
        for (const bool triangles_alone : {false, true})
            pop_each_change(changes, shown, triangles_alone);
    EXPECT_GT(visible_changes, whole ? 150 : 100);
}

/// States come back, while textures and drawables change.
TEST_F(Derived, StatesThatComeBackAreDrawnAgain) {
    const std::vector<Change> changes = all_changes();
    spangle::test::Random random{77};
    const Bound narrow = start(5), wide = start(8);
    for (int round = 0; round < 60; ++round) {
        const Bound& bound = random.below(2) != 0 ? narrow : wide;
        const bool shown = random.below(2) != 0;
        const std::size_t one = random.below(6),
                          other = random.below(static_cast<std::uint32_t>(changes.size()));
        const unsigned seed = random.below(3);
        const GLenum format = random.below(2) != 0 ? GL_RGBA : GL_LUMINANCE;
        const auto drawn = [&] {
            set_texture(seed, format);
            clear();
            if (shown)
                show_all();
            changes[one].apply();
            const std::vector<GLubyte> first = draw();
            changes[other].apply();
            std::vector<GLubyte> out = draw();
            out.insert(out.end(), first.begin(), first.end());
            return out;
        };
        ASSERT_EQ(eglMakeCurrent(display, bound.surface, bound.surface, bound.context), EGLBoolean{EGL_TRUE});
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        const std::vector<GLubyte> again = drawn();
        glPopAttrib();
        const Bound fresh = start(bound.surface == narrow.surface ? 5 : 8);
        const std::vector<GLubyte> anew = drawn();
        end(fresh);
        ASSERT_EQ(again, anew) << round << ": " << changes[one].name << ", " << changes[other].name;
    }
    end(narrow);
    end(wide);
}

} // namespace

#endif

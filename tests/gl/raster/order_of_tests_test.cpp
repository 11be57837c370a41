// The alpha, stencil and depth tests happen in this order, and a fragment that one of them drops has no
// effect of the later ones (GL 1.3, 4.1, figure 4.1). A model in plain integers says what each pixel must
// become.
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_DRAW_PIXELS && SPANGLE_FEATURE_RASTER_POS

#include <optional>

#include "tests/gl/raster/window.hpp"

namespace spangle::test {
namespace {

constexpr int size = 64, pixel_count = size * size;

bool compared(GLenum func, unsigned incoming, unsigned stored) {
    switch (func) {
    case GL_NEVER:
        return false;
    case GL_LESS:
        return incoming < stored;
    case GL_EQUAL:
        return incoming == stored;
    case GL_LEQUAL:
        return incoming <= stored;
    case GL_GREATER:
        return incoming > stored;
    case GL_NOTEQUAL:
        return incoming != stored;
    case GL_GEQUAL:
        return incoming >= stored;
    default:
        return true;
    }
}

GLubyte after_op(GLenum op, unsigned stored, unsigned ref) {
    switch (op) {
    case GL_ZERO:
        return 0;
    case GL_REPLACE:
        return static_cast<GLubyte>(ref);
    case GL_INCR:
        return static_cast<GLubyte>(stored < 255 ? stored + 1 : 255);
    case GL_DECR:
        return static_cast<GLubyte>(stored > 0 ? stored - 1 : 0);
    case GL_INVERT:
        return static_cast<GLubyte>(~stored);
    default:
        return static_cast<GLubyte>(stored);
    }
}

/// What the buffers hold, and how many fragments have passed.
struct Buffers {
    std::vector<GLubyte> stencil = std::vector<GLubyte>(pixel_count), red = stencil;
    std::vector<GLuint> depth = std::vector<GLuint>(pixel_count); ///< codes of 24 bits
    GLuint passed = 0;
};

struct Tests {
    GLenum alpha, stencil, depth; ///< comparisons; 0: the test is off
    GLubyte alpha_ref, stencil_ref;
    GLenum fail, depth_fail, pass;
    bool writes_depth;
};

class OrderOfTests : public testing::TestWithParam<const char*> {
  protected:
    std::optional<HeadlessGl> current_;
    std::mt19937 random_{11};

    void SetUp() override {
        current_.emplace(size, size, std::initializer_list<EGLint>{EGL_STENCIL_SIZE, 8});
        glOrtho(0, size, 0, size, 0, 1);
        glDisable(GL_DITHER);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glRasterPos2i(0, 0);
        glColor3f(1, 1, 1);
    }
    void TearDown() override { EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}); }

    unsigned upto(unsigned n) { return static_cast<unsigned>(random_()) % n; }
    Tests lot() {
        constexpr GLenum funcs[] = {0,          GL_NEVER,    GL_LESS,   GL_EQUAL, GL_LEQUAL,
                                    GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS},
                         ops[] = {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT};
        const auto ref = [&] { return static_cast<GLubyte>(upto(4) * 50); };
        return {funcs[upto(9)],
                funcs[upto(9)],
                funcs[upto(9)],
                static_cast<GLubyte>(25 + ref()),
                static_cast<GLubyte>(upto(4)),
                ops[upto(6)],
                ops[upto(6)],
                ops[upto(6)],
                upto(2) != 0};
    }
    static void set(const Tests& tests) {
        const auto turn = [](GLenum cap, bool on) { (on ? glEnable : glDisable)(cap); };
        turn(GL_ALPHA_TEST, tests.alpha != 0);
        turn(GL_STENCIL_TEST, tests.stencil != 0);
        turn(GL_DEPTH_TEST, tests.depth != 0);
        if (tests.alpha != 0)
            glAlphaFunc(tests.alpha, static_cast<GLfloat>(tests.alpha_ref) / 255);
        if (tests.stencil != 0)
            glStencilFunc(tests.stencil, tests.stencil_ref, 0xFF);
        glStencilOp(tests.fail, tests.depth_fail, tests.pass);
        if (tests.depth != 0)
            glDepthFunc(tests.depth);
        glDepthMask(tests.writes_depth ? GL_TRUE : GL_FALSE);
    }
    static void reset() {
        set({0, 0, 0, 0, 0, GL_KEEP, GL_KEEP, GL_KEEP, true});
        glDisable(GL_TEXTURE_2D);
    }
    static Buffers read() {
        Buffers out;
        glReadPixels(0, 0, size, size, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, out.stencil.data());
        glReadPixels(0, 0, size, size, GL_RED, GL_UNSIGNED_BYTE, out.red.data());
        glReadPixels(0, 0, size, size, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, out.depth.data());
        for (GLuint& code : out.depth)
            code >>= 8;
        return out;
    }
    /// Fills the buffers with few different values, so that equality is frequent.
    Buffers background() {
        reset();
        glClear(GL_COLOR_BUFFER_BIT);
        std::vector<GLubyte> stencil(pixel_count);
        std::vector<GLuint> depth(pixel_count);
        for (GLubyte& v : stencil)
            v = static_cast<GLubyte>(upto(5) == 4 ? 255 : upto(4));
        for (GLuint& v : depth)
            v = upto(3) * 0x40000000u + 0x40000000u;
        glDrawPixels(size, size, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil.data());
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_ALWAYS);
        glDrawPixels(size, size, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth.data());
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        return read();
    }
    std::vector<GLubyte> alphas() {
        std::vector<GLubyte> all(pixel_count);
        for (GLubyte& v : all)
            v = static_cast<GLubyte>(upto(6) * 50);
        return all;
    }
    /// Draws a white fragment at every pixel, with the alpha of that pixel and the depth z: triangles that
    /// have a texture, or points.
    static void draw(bool points, const std::vector<GLubyte>& alpha, GLfloat z) {
        if (points) {
            glBegin(GL_POINTS);
            for (int i = 0; i < pixel_count; ++i) {
                glColor4ub(255, 255, 255, alpha[static_cast<std::size_t>(i)]);
                glVertex3f(static_cast<GLfloat>(i % size) + 0.5f, static_cast<GLfloat>(i / size) + 0.5f, z);
            }
            glEnd();
            return;
        }
        glTexImage2D(GL_TEXTURE_2D, 0, GL_ALPHA, size, size, 0, GL_ALPHA, GL_UNSIGNED_BYTE, alpha.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glEnable(GL_TEXTURE_2D);
        glColor4f(1, 1, 1, 1);
        glBegin(GL_QUADS);
        for (const auto& [x, y] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}, std::pair{0, 1}}) {
            glTexCoord2i(x, y);
            glVertex3f(static_cast<GLfloat>(x * size), static_cast<GLfloat>(y * size), z);
        }
        glEnd();
    }
    static Buffers expected(Buffers held, const Tests& tests, const std::vector<GLubyte>& alpha,
                            GLuint depth) {
        for (std::size_t i = 0; i < pixel_count; ++i) {
            if (tests.alpha != 0 && !compared(tests.alpha, alpha[i], tests.alpha_ref))
                continue;
            const bool reaches_depth =
                tests.stencil == 0 || compared(tests.stencil, tests.stencil_ref, held.stencil[i]);
            const bool passes =
                reaches_depth && (tests.depth == 0 || compared(tests.depth, depth, held.depth[i]));
            if (tests.stencil != 0)
                held.stencil[i] = after_op(!reaches_depth ? tests.fail
                                           : passes       ? tests.pass
                                                          : tests.depth_fail,
                                           held.stencil[i], tests.stencil_ref);
            if (!passes)
                continue;
            if (tests.depth != 0 && tests.writes_depth)
                held.depth[i] = depth;
            held.red[i] = 255;
            ++held.passed;
        }
        return held;
    }
};

TEST_P(OrderOfTests, IsAlphaStencilDepth) {
    const bool points = GetParam() == std::string("points");
    GLuint query = 0;
    glGenQueries(1, &query);
    for (int round = 0; round < 200; ++round) {
        const GLfloat z = -0.25f * static_cast<GLfloat>(1 + upto(3));
        reset();
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_ALWAYS);
        draw(true, alphas(), z);
        const GLuint depth = read().depth[0];
        const Buffers before = background();
        const std::vector<GLubyte> alpha = alphas();
        const Tests tests = lot();
        set(tests);
        const bool counts = round % 2 == 0; // a query is an effect of its own
        if (counts)
            glBeginQuery(GL_SAMPLES_PASSED, query);
        draw(points, alpha, z);
        if (counts)
            glEndQuery(GL_SAMPLES_PASSED);
        Buffers found = read();
        if (counts)
            glGetQueryObjectuiv(query, GL_QUERY_RESULT, &found.passed);
        const Buffers wanted = expected(before, tests, alpha, depth);
        ASSERT_EQ(found.stencil, wanted.stencil) << round;
        ASSERT_EQ(found.depth, wanted.depth) << round;
        ASSERT_EQ(found.red, wanted.red) << round;
        ASSERT_EQ(found.passed, counts ? wanted.passed : 0) << round;
    }
    glDeleteQueries(1, &query);
}

INSTANTIATE_TEST_SUITE_P(Shapes, OrderOfTests, testing::Values("triangles", "points"));

} // namespace
} // namespace spangle::test

#endif

// Rows A01, A02, A06, C16, H06: tests which state a command uses, when its effect is visible, and the order
// of the operations on a fragment.
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "tests/gl/vertex/canvas.hpp"

namespace spangle::test {
namespace {

using Bytes = std::array<GLubyte, 4>;

class Execution : public Canvas {
  protected:
    static Bytes pixel(int x, int y) {
        Bytes c{};
        glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, c.data());
        return c;
    }
    /// From here on object coordinates are window coordinates.
    static void use_pixels() {
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glOrtho(0, size, 0, size, -1, 1);
        glMatrixMode(GL_MODELVIEW);
    }
};

// --- A01: GL 1.3, 2.1 and 2.2

TEST_F(Execution, CommandsTakeEffectInTheirOrder) {
    use_pixels();
    const Bytes red{255, 0, 0, 255}, green{0, 255, 0, 255}, black{};
    glColor3ub(255, 0, 0);
    glRecti(0, 0, 20, 20);
    EXPECT_EQ(pixel(15, 15), red) << "a query sees every command before it";
    glColor3ub(0, 255, 0);
    glRecti(10, 10, 30, 30);
    EXPECT_EQ(pixel(5, 5), red);
    EXPECT_EQ(pixel(15, 15), green) << "the later one is on top";
    // A change of state applies to later commands, and only to these.
    glScissor(0, 0, 12, 12);
    glRecti(30, 0, 31, 1);
    glEnable(GL_SCISSOR_TEST);
    glColor3ub(255, 0, 0);
    glRecti(0, 0, 30, 30);
    EXPECT_EQ(pixel(11, 11), red);
    EXPECT_EQ(pixel(12, 12), green);
    glDisable(GL_SCISSOR_TEST);
    glRecti(31, 0, 32, 1);
    EXPECT_EQ(pixel(30, 0), green);
    EXPECT_EQ(pixel(31, 0), red);
    glColorMask(GL_FALSE, GL_TRUE, GL_TRUE, GL_TRUE);
    glRecti(10, 10, 30, 30);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    EXPECT_EQ(pixel(12, 12), (Bytes{0, 0, 0, 255}));
    EXPECT_EQ(pixel(11, 11), red);
    // A vertex is transformed and takes its attributes when it is given.
    glShadeModel(GL_FLAT);
    glBegin(GL_TRIANGLES);
    glVertex2i(40, 40);
    glVertex2i(60, 40);
    glColor3ub(0, 255, 0);
    glVertex2i(40, 60);
    glColor3ub(255, 0, 0);
    glEnd();
    EXPECT_EQ(pixel(45, 45), green);
    EXPECT_EQ(pixel(59, 59), black);
    glShadeModel(GL_SMOOTH);
    glBegin(GL_TRIANGLES);
    glColor3ub(255, 0, 0);
    glVertex2i(40, 40);
    glVertex2i(60, 40);
    glColor3ub(0, 255, 0);
    glVertex2i(40, 60);
    glEnd();
    EXPECT_GT(pixel(45, 45)[0], 100) << "no longer flat";
}

/// Client data are read during the call, and later changes of the memory do not matter.
TEST_F(Execution, ClientMemoryIsReadDuringTheCall) {
    use_pixels();
    const Bytes red{255, 0, 0, 255};
    GLshort position[4][2] = {{0, 0}, {20, 0}, {20, 20}, {0, 20}};
    GLubyte color[4][4] = {{255, 0, 0, 255}, {255, 0, 0, 255}, {255, 0, 0, 255}, {255, 0, 0, 255}};
    GLubyte indices[4] = {0, 1, 2, 3};
    const auto spoil = [&] {
        for (auto& p : position)
            p[0] = p[1] = 50;
        for (auto& c : color)
            c[0] = 7;
        for (GLubyte& i : indices)
            i = 0;
    };
    const auto restore = [&] {
        const GLshort corner[4][2] = {{0, 0}, {20, 0}, {20, 20}, {0, 20}};
        for (int i = 0; i < 4; ++i) {
            position[i][0] = corner[i][0], position[i][1] = corner[i][1];
            color[i][0] = 255;
            indices[i] = static_cast<GLubyte>(i);
        }
    };
    glVertexPointer(2, GL_SHORT, 0, position);
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    const auto draws = [&] { glDrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, indices); };
    draws();
    spoil();
    EXPECT_EQ(pixel(10, 10), red);
    // A list has the data that the arrays had when it was compiled.
    restore();
    glNewList(1, GL_COMPILE);
    draws();
    glEndList();
    spoil();
    glClear(GL_COLOR_BUFFER_BIT);
    glCallList(1);
    EXPECT_EQ(pixel(10, 10), red);
    EXPECT_EQ(pixel(50, 50), Bytes{});
    // An image and a matrix are also read during the call.
    GLubyte texel[4] = {255, 0, 0, 255};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    texel[0] = 9;
    GLfloat matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 30, 0, 0, 1};
    glLoadMatrixf(matrix);
    matrix[12] = 0;
    glDisableClientState(GL_COLOR_ARRAY);
    glEnable(GL_TEXTURE_2D);
    glColor3ub(255, 255, 255);
    glRecti(0, 0, 10, 10);
    EXPECT_EQ(pixel(35, 5), red);
}

// --- A02, C16: GL 1.3, 2.13.9

/// An unsigned byte that enters as a colour is the same unsigned byte when it is read back, whatever path it
/// took.
TEST_F(Execution, UbytesComeBackAsTheyWere) {
    use_pixels();
    const Bytes white{255, 255, 255, 255};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    for (int v = 0; v < 256; ++v) {
        const Bytes c{static_cast<GLubyte>(v), static_cast<GLubyte>(255 - v), static_cast<GLubyte>(v * 7),
                      static_cast<GLubyte>(v * 31 + 5)};
        const std::pair<const char*, std::function<void()>> ways[] = {
            {"point",
             [&] {
                 glColor4ubv(c.data());
                 glBegin(GL_POINTS);
                 glVertex2f(20.5f, 20.5f);
                 glEnd();
             }},
            {"triangle with three colours that are one",
             [&] {
                 glBegin(GL_TRIANGLES);
                 for (const auto& [x, y] : {std::pair<int, int>{-7, 3}, {63, 9}, {11, 60}}) {
                     glColor4ubv(c.data());
                     glVertex2i(x, y);
                 }
                 glEnd();
             }},
            {"times white",
             [&] {
                 glEnable(GL_TEXTURE_2D);
                 glColor4ubv(c.data());
                 glRecti(19, 19, 22, 22);
                 glDisable(GL_TEXTURE_2D);
             }},
            {"given as shorts",
             [&] {
                 glColor4us(static_cast<GLushort>(c[0] * 257), static_cast<GLushort>(c[1] * 257),
                            static_cast<GLushort>(c[2] * 257), static_cast<GLushort>(c[3] * 257));
                 glRecti(19, 19, 22, 22);
             }},
            {"clear",
             [&] {
                 glClearColor(static_cast<GLfloat>(c[0]) / 255, static_cast<GLfloat>(c[1]) / 255,
                              static_cast<GLfloat>(c[2]) / 255, static_cast<GLfloat>(c[3]) / 255);
                 glClear(GL_COLOR_BUFFER_BIT);
             }},
        };
        for (const auto& [name, way] : ways) {
            glClearColor(0, 0, 0, 0);
            glClear(GL_COLOR_BUFFER_BIT);
            way();
            EXPECT_EQ(pixel(20, 20), c) << name << ' ' << v;
        }
    }
}

// --- H06: GL 1.3, 5.5

TEST_F(Execution, FinishedCommandsAreInTheFramebuffer) {
    use_pixels();
    for (const auto complete : {&glFlush, &glFinish}) {
        glColor3ub(1, 2, 3);
        glRecti(0, 0, 4, 4);
        complete();
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        EXPECT_EQ(pixel(1, 1), (Bytes{1, 2, 3, 255}));
        glNewList(1, GL_COMPILE);
        complete(); // a list may contain Flush and Finish, too
        glEndList();
        glCallList(1);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        glBegin(GL_POINTS);
        complete();
        glEnd();
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
    }
}

// --- A06: GL 1.3, figures 3.1 and 4.1

using Rgba = std::array<double, 4>;
constexpr Rgba primary{0.8, 0.5, 0.3, 0.9}, secondary{0.1, 0.3, 0.2, 0}, texel{0.6, 1.0, 0.2, 0.8},
    fog_color{0.1, 0.2, 0.9, 0}, below{0.2, 0.6, 0.4, 0.4};
constexpr double fog_factor = 0.75;

const std::vector<std::function<void(Rgba&)>> color_operations = {
    [](Rgba& c) { // applies the texture environment MODULATE
        for (std::size_t i = 0; i < 4; ++i)
            c[i] *= texel[i];
    },
    [](Rgba& c) { // applies the colour sum
        for (std::size_t i = 0; i < 3; ++i)
            c[i] = std::fmin(1, c[i] + secondary[i]);
    },
    [](Rgba& c) { // applies fog
        for (std::size_t i = 0; i < 3; ++i)
            c[i] = fog_factor * c[i] + (1 - fog_factor) * fog_color[i];
    },
    [](Rgba& c) { // applies blending
        const double a = c[3];
        for (std::size_t i = 0; i < 4; ++i)
            c[i] = c[i] * a + below[i] * (1 - a);
    },
    [](Rgba& c) { c[3] = below[3]; }, // applies the mask of alpha
};

Rgba in_order(const std::vector<std::size_t>& order) {
    Rgba c = primary;
    for (const std::size_t i : order)
        color_operations[i](c);
    return c;
}

class Order : public Execution {
  protected:
    static constexpr GLint stencil_below = 5;

    static GLfloat f(double v) { return static_cast<GLfloat>(v); }
    static std::array<GLfloat, 4> fs(const Rgba& c) { return {f(c[0]), f(c[1]), f(c[2]), f(c[3])}; }

    void SetUp() override {
        Execution::SetUp();
        glDisable(GL_DITHER);
        // The primary colour is the emission, the secondary one a highlight of exponent 0.
        const GLfloat black[4] = {0, 0, 0, 1}, one[4] = {1, 1, 1, 1}, toward[4] = {0, 0, 1, 0},
                      diffuse[4] = {0, 0, 0, f(primary[3])};
        glEnable(GL_LIGHTING);
        glEnable(GL_LIGHT0);
        glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
        glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
        glLightfv(GL_LIGHT0, GL_POSITION, toward);
        glLightfv(GL_LIGHT0, GL_SPECULAR, one);
        glMaterialfv(GL_FRONT, GL_EMISSION, fs(primary).data());
        glMaterialfv(GL_FRONT, GL_SPECULAR, fs(secondary).data());
        glMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse);
        glNormal3i(0, 0, 0x7FFFFFFF);
        const std::array<GLfloat, 4> image = fs(texel);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_FLOAT, image.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glEnable(GL_TEXTURE_2D);
        glEnable(GL_FOG);
        glFogi(GL_FOG_MODE, GL_LINEAR);
        glFogf(GL_FOG_START, 0);
        glFogf(GL_FOG_END, 2); // the eye is half a unit away
        glFogfv(GL_FOG_COLOR, fs(fog_color).data());
        glEnable(GL_ALPHA_TEST);
        glEnable(GL_STENCIL_TEST);
        glStencilOp(GL_ZERO, GL_INCR, GL_INVERT);
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glEnable(GL_SCISSOR_TEST);
        glClearColor(f(below[0]), f(below[1]), f(below[2]), f(below[3]));
        glClearStencil(stencil_below);
        glClearDepth(0.5);
    }

    /// Draws one fragment into a cleared framebuffer.
    static void draw(bool owned, bool alpha, bool stencil, bool depth) {
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glScissor(0, 0, size, size);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        glScissor(owned ? 0 : 40, 0, 40, size);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
        glAlphaFunc(alpha ? GL_GREATER : GL_LESS, 0.5f); // alpha is 0.72, because the texture comes first
        glStencilFunc(stencil ? GL_EQUAL : GL_NOTEQUAL, stencil_below, 0xFF);
        glDepthFunc(depth ? GL_GREATER : GL_LESS);
        glBegin(GL_POINTS);
        glVertex3f(0.01f, 0.01f, -0.5f);
        glEnd();
    }
};

TEST_F(Order, OfWhatMakesTheColor) {
    const std::vector<std::size_t> order = {0, 1, 2, 3, 4};
    const Rgba right = in_order(order);
    // In this scene every exchange of two operations would change the result visibly.
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t k = i + 1; k < order.size(); ++k) {
            std::vector<std::size_t> other = order;
            std::swap(other[i], other[k]);
            double worst = 0;
            for (std::size_t c = 0; c < 4; ++c)
                worst = std::fmax(worst, std::fabs(in_order(other)[c] - right[c]));
            EXPECT_GT(worst, 6.0 / 255) << i << k;
        }
    glDepthRange(1, 0); // reverses depth, so 0.25 becomes 0.75
    draw(true, true, true, true);
    const Bytes got = pixel(size / 2, size / 2);
    for (std::size_t c = 0; c < 4; ++c)
        EXPECT_NEAR(got[c], 255 * right[c], 1.5) << c;
}

/// The tests are scissor, alpha, stencil, depth. A fragment that fails one test does not reach those behind
/// it.
TEST_F(Order, OfTheTests) {
    glDepthRange(1, 0);
    for (int which = 0; which < 16; ++which) {
        const bool owned = (which & 1) != 0, alpha = (which & 2) != 0, stencil = (which & 4) != 0,
                   depth = (which & 8) != 0;
        draw(owned, alpha, stencil, depth);
        const bool tested = owned && alpha, drawn = tested && stencil && depth;
        const int expected = !tested    ? stencil_below
                             : !stencil ? 0
                             : !depth   ? stencil_below + 1
                                        : 0xFF - stencil_below;
        GLubyte got = 0;
        glReadPixels(size / 2, size / 2, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &got);
        EXPECT_EQ(got, expected) << which;
        GLfloat z = 0;
        glReadPixels(size / 2, size / 2, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &z);
        EXPECT_NEAR(z, drawn ? 0.75 : 0.5, 1e-6) << which;
        EXPECT_EQ(pixel(size / 2, size / 2)[2] == std::lround(255 * below[2]), !drawn) << which;
    }
}

} // namespace
} // namespace spangle::test

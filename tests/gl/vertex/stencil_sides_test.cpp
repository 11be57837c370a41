// Tests stencil state of front and back faces (GL 2.0, 4.1.5), and which primitive has which side.
#include <vector>

#include "tests/gl/vertex/canvas.hpp"

namespace spangle::test {
namespace {

constexpr GLubyte front_value = 0x15, back_value = 0xA2;

/// Every fragment stores the number of its side in the stencil buffer.
class StencilSides : public Canvas {
  protected:
    void SetUp() override {
        Canvas::SetUp();
        glOrtho(0, size, 0, size, -1, 1);
        glClear(GL_STENCIL_BUFFER_BIT);
        glEnable(GL_STENCIL_TEST);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        glStencilFuncSeparate(GL_FRONT, GL_ALWAYS, front_value, ~0u);
        glStencilFuncSeparate(GL_BACK, GL_ALWAYS, back_value, ~0u);
    }
    /// Sends the four corners of a square, counter-clockwise or clockwise.
    static void corners(bool ccw) {
        const GLfloat x[] = {8, 56, 56, 8}, y[] = {8, 8, 56, 56};
        for (int i = 0; i < 4; ++i)
            glVertex2f(x[ccw ? i : 3 - i], y[ccw ? i : 3 - i]);
    }
    /// Pixels of each side. All other pixels must be untouched.
    struct Seen {
        int front = 0, back = 0;
    };
    static Seen seen() {
        std::vector<GLubyte> values(size * size);
        glReadPixels(0, 0, size, size, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, values.data());
        Seen result;
        for (const GLubyte v : values) {
            result.front += v == front_value;
            result.back += v == back_value;
            EXPECT_TRUE(v == 0 || v == front_value || v == back_value);
        }
        glClear(GL_STENCIL_BUFFER_BIT);
        return result;
    }
    static void expect(bool front, int pixels, const char* what) {
        const Seen s = seen();
        EXPECT_EQ(s.front, front ? pixels : 0) << what;
        EXPECT_EQ(s.back, front ? 0 : pixels) << what;
    }
};

TEST_F(StencilSides, OfPolygonsOfEveryMode) {
    for (const GLenum mode : {GL_QUADS, GL_POLYGON, GL_TRIANGLE_FAN})
        for (const bool ccw : {false, true})
            for (const GLenum front : {GL_CCW, GL_CW}) {
                glFrontFace(front);
                glBegin(mode);
                corners(ccw);
                glEnd();
                expect(ccw == (front == GL_CCW), 48 * 48, "filled");
            }
}

TEST_F(StencilSides, OfTheirLinesAndPoints) {
    glTranslatef(0.5f, 0.5f, 0); // lines go through pixel centres
    for (const bool ccw : {false, true}) {
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        glBegin(GL_QUADS);
        corners(ccw);
        glEnd();
        expect(ccw, 4 * 48, "outlined");
        glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
        glBegin(GL_QUADS);
        corners(ccw);
        glEnd();
        expect(ccw, 4, "corners");
    }
}

TEST_F(StencilSides, AllElseIsOfTheFront) {
    glBegin(GL_QUADS);
    corners(false); // draws a back face first
    glEnd();
    seen();
    glBegin(GL_LINES);
    glVertex2f(10, 20.5f), glVertex2f(30, 20.5f);
    glEnd();
    expect(true, 20, "line");
    glBegin(GL_POINTS);
    glVertex2f(10.5f, 20.5f);
    glEnd();
    expect(true, 1, "point");
    glRecti(56, 8, 8, 56);
    expect(false, 48 * 48, "a rectangle turned round");
}

/// A pass of shadow volumes: back faces count up, front faces count down, and each side has its own masks.
TEST_F(StencilSides, OperationsAndMasks) {
    glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
    const auto at = [] {
        GLubyte v = 0;
        glReadPixels(20, 20, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &v);
        return int{v};
    };
    glRecti(8, 8, 56, 56);
    EXPECT_EQ(at(), 255);
    glRecti(56, 8, 8, 56);
    EXPECT_EQ(at(), 0);
    glRecti(56, 8, 8, 56);
    EXPECT_EQ(at(), 1);
    glStencilMaskSeparate(GL_BACK, 0xF0);
    glRecti(56, 8, 8, 56);
    EXPECT_EQ(at(), 1) << "1 + 1 = 2 in masked bits";
    GLint value = 0;
    glGetIntegerv(GL_STENCIL_BACK_WRITEMASK, &value);
    EXPECT_EQ(value, 0xF0);
    glGetIntegerv(GL_STENCIL_WRITEMASK, &value);
    EXPECT_EQ(value, -1);
}

} // namespace
} // namespace spangle::test

// Rows C08 to C10: tests ColorMaterial, materials between Begin and End, and both sides.
#include <random>

#include "tests/gl/vertex/lighting_canvas.hpp"

namespace spangle::test {
namespace {

TEST_F(Lighting, ColorMaterialTracksEachPropertyOfEachFace) {
    const GLfloat gray[4] = {0.5f, 0.5f, 0.5f, 0.5f};
    const GLfloat rgba[4] = {0.1f, 0.2f, 0.3f, 0.4f}, other[4] = {0.9f, 0.8f, 0.7f, 0.6f};
    const GLenum properties[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION};
    const auto is = [](GLenum face, GLenum property, const GLfloat(&v)[4]) {
        GLfloat got[4];
        glGetMaterialfv(face, property, got);
        return std::equal(got, got + 4, v);
    };
    for (const GLenum mode : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE})
        for (const GLenum face : {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}) {
            glDisable(GL_COLOR_MATERIAL);
            for (const GLenum property : properties)
                glMaterialfv(GL_FRONT_AND_BACK, property, gray);
            glColor4fv(other);
            glColorMaterial(face, mode);
            const auto all_are = [&](const GLfloat(&tracked)[4], const GLfloat(&free)[4], const char* when) {
                for (const GLenum f : {GL_FRONT, GL_BACK})
                    for (const GLenum property : properties) {
                        const bool follows =
                            (face == f || face == GL_FRONT_AND_BACK) &&
                            (property == mode || (mode == GL_AMBIENT_AND_DIFFUSE &&
                                                  (property == GL_AMBIENT || property == GL_DIFFUSE)));
                        EXPECT_TRUE(follows ? is(f, property, tracked) : is(f, property, free))
                            << when << ": mode " << mode << ", face " << face << ", " << f << ' ' << property;
                    }
            };
            all_are(gray, gray, "while off");
            glEnable(GL_COLOR_MATERIAL);
            all_are(other, gray, "at once");
            glColor4fv(rgba);
            all_are(rgba, gray, "with the colour");
            for (const GLenum property : properties)
                glMaterialfv(GL_FRONT_AND_BACK, property, other);
            all_are(rgba, other, "Material has no effect on it");
            glDisable(GL_COLOR_MATERIAL);
            glColor4fv(gray);
            all_are(rgba, other, "values stay");
        }
}

TEST_F(Lighting, ColorMaterialChangedWhileOnTracksTheNewPropertyAtOnce) {
    const GLfloat rgba[4] = {0.1f, 0.2f, 0.3f, 0.4f};
    GLfloat got[4];
    glColor4fv(rgba);
    glColorMaterial(GL_FRONT, GL_DIFFUSE);
    glEnable(GL_COLOR_MATERIAL);
    glColorMaterial(GL_BACK, GL_EMISSION);
    glGetMaterialfv(GL_BACK, GL_EMISSION, got);
    EXPECT_TRUE(std::equal(got, got + 4, rgba));
}

/// A triangle that faces the viewer, or is turned away.
struct Triangle {
    static constexpr GLfloat corner[3][2] = {{-50, -50}, {50, -50}, {0, 50}};
    static void vertex(int i, bool front) { glVertex2fv(corner[front ? i : 2 - i]); }
};

TEST_F(Lighting, EachVertexHasTheMaterialOfItsTime) {
    const auto white = [](double v) {
        return std::array<GLfloat, 4>{static_cast<GLfloat>(v), static_cast<GLfloat>(v),
                                      static_cast<GLfloat>(v), 1};
    };
    glDisable(GL_LIGHT0);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, white(0).data());
    for (const bool by_color : {false, true}) {
        glColorMaterial(GL_FRONT_AND_BACK, GL_EMISSION);
        (by_color ? glEnable : glDisable)(GL_COLOR_MATERIAL);
        WindowRecorder recorder;
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < 3; ++i) {
            const auto shade = white(0.25 * (i + 1));
            if (by_color)
                glColor4fv(shade.data());
            else
                glMaterialfv(GL_FRONT, GL_EMISSION, shade.data());
            Triangle::vertex(i, true);
        }
        glMaterialfv(GL_FRONT, GL_EMISSION, white(1).data());
        glEnd();
        ASSERT_EQ(recorder.primitives.size(), 1u);
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(recorder.primitives[0].corner[i].color[0] / units, 0.25 * (i + 1), 1e-6) << by_color;
    }
}

/// Back faces have the material of each vertex, too, also at vertices that clipping makes: COLOR_MATERIAL
/// applies to a face that is not known yet.
TEST_F(Lighting, BothSidesHaveTheMaterialsOfTheirTime) {
    const GLfloat black[4] = {0, 0, 0, 1};
    glDisable(GL_LIGHT0);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    for (const bool by_color : {false, true})
        for (const bool front : {false, true})
            for (const bool cut : {false, true}) {
                glColorMaterial(GL_FRONT_AND_BACK, GL_EMISSION);
                (by_color ? glEnable : glDisable)(GL_COLOR_MATERIAL);
                WindowRecorder recorder;
                glBegin(GL_TRIANGLES);
                for (int i = 0; i < 3; ++i) { // red is 0.2, 0.4, 0.6 from left to right
                    const GLfloat at = static_cast<GLfloat>(i - 1) * (cut ? 2000.0f : 50.0f);
                    const GLfloat shade[4] = {0.2f * static_cast<GLfloat>(i + 1), 0, 0, 1};
                    if (by_color)
                        glColor4fv(shade);
                    else
                        glMaterialfv(front ? GL_FRONT : GL_BACK, GL_EMISSION, shade);
                    glVertex2f(at, i != 1 ? 50 : front ? -50 : 150);
                }
                glEnd();
                glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, black);
                ASSERT_GE(recorder.primitives.size(), 1u);
                for (const Primitive& p : recorder.primitives)
                    for (const raster::FixedVertex& v : p.corner) {
                        const double x = v.x / 256.0 * 400 / size - 200, share = x / (cut ? 2000 : 50);
                        EXPECT_NEAR(v.color[0] / units, 0.4 + 0.2 * share, 1e-4)
                            << by_color << front << cut << " at " << x;
                    }
            }
}

/// COLOR_MATERIAL of one face or of both, with every term of light on both sides: each vertex is compared
/// with the equation.
TEST_F(Lighting, TrackedMaterialsOfBothSides) {
    std::mt19937 random(5);
    const auto real = [&random](double low, double high) {
        return static_cast<double>(static_cast<float>(std::uniform_real_distribution<>(low, high)(random)));
    };
    const auto color = [&] { return Vec4{real(0, 0.4), real(0, 0.4), real(0, 0.4), real(0, 1)}; };
    int backs = 0;
    for (int n = 0; n < 3000; ++n) {
        LitVertex v;
        for (std::size_t i = 0; i < 2; ++i) {
            v.light[i].on = true;
            v.light[i].ambient = color(), v.light[i].diffuse = color(), v.light[i].specular = color();
            v.light[i].position = {real(-90, 90), real(-90, 90), real(-90, 90), n % 3 != 0 ? 1.0 : 0.0};
        }
        for (SurfaceMaterial& m : v.material)
            m.ambient = color(), m.diffuse = color(), m.emission = color(), m.specular = color(),
            m.shininess = real(1, 30);
        v.normalize = true;
        v.local_viewer = n % 2 != 0;
        specify(v);
        glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
        const GLenum faces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
        const GLenum face = faces[n % 3];
        glColorMaterial(face, GL_DIFFUSE);
        glEnable(GL_COLOR_MATERIAL);
        const bool front = n / 3 % 2 != 0;
        LitVertex corner[3] = {v, v, v};
        WindowRecorder recorder;
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < 3; ++i) {
            LitVertex& c = corner[i];
            const Vec4 now = color();
            for (int side = 0; side < 2; ++side)
                if (face == GL_FRONT_AND_BACK || (face == GL_BACK) == (side == 1))
                    c.material[side].diffuse = now;
            c.normal = {real(-1, 1), real(-1, 1), real(-1, 1)};
            c.position = {Triangle::corner[front ? i : 2 - i][0], Triangle::corner[front ? i : 2 - i][1],
                          real(-20, 20), 1};
            glColor4fv(floats(now).data());
            glNormal3fv(floats(c.normal).data());
            glVertex4fv(floats(c.position).data());
        }
        glEnd();
        glDisable(GL_COLOR_MATERIAL);
        ASSERT_EQ(recorder.primitives.size(), 1u);
        for (int i = 0; i < 3; ++i)
            if (const LitColor expected = equation(corner[i], front ? 0 : 1); expected.margin > 1e-6) {
                EXPECT_LT(difference(recorder.primitives[0].corner[i], expected), 0.01) << n << ' ' << i;
                backs += front ? 0 : 1;
            }
    }
    EXPECT_GT(backs, 4000);
}

TEST_F(Lighting, TwoSides) {
    LitVertex v;
    v.material[0].diffuse = {0.5, 0, 0, 0.25};
    v.material[1].diffuse = {0, 0.5, 0, 0.75};
    v.material[1].specular = {0, 0, 0.5, 1};
    v.material[1].shininess = 3;
    v.normal = {0.6f, 0, 0.8f};
    v.light[1].on = true; // lights the faces that are turned away
    v.light[1].position = {0, 0, -1, 0};
    v.light[1].diffuse = v.light[1].specular = {0.5, 1, 1, 1};
    v.local_viewer = true;
    specify(v);
    glNormal3fv(floats(v.normal).data());
    for (const bool two_side : {false, true})
        for (const bool clockwise_is_front : {false, true})
            for (const bool counterclockwise : {false, true}) {
                glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, two_side ? 1 : 0);
                glFrontFace(clockwise_is_front ? GL_CW : GL_CCW);
                WindowRecorder recorder;
                glBegin(GL_TRIANGLES);
                for (int i = 0; i < 3; ++i)
                    Triangle::vertex(i, counterclockwise);
                glEnd();
                ASSERT_EQ(recorder.primitives.size(), 1u);
                const int side = two_side && counterclockwise == clockwise_is_front ? 1 : 0;
                for (const raster::FixedVertex& corner : recorder.primitives[0].corner) {
                    // The place in the window gives back the position of the vertex.
                    LitVertex at = v;
                    at.position = {corner.x / 256.0 * 400 / size - 200, corner.y / 256.0 * 400 / size - 200,
                                   0, 1};
                    EXPECT_LT(difference(corner, equation(at, side)), 0.001)
                        << two_side << clockwise_is_front << counterclockwise;
                }
            }
}

/// Points and lines are always lit from the front (GL 1.3, 2.13.1).
TEST_F(Lighting, PointsAndLinesHaveNoBack) {
    LitVertex v;
    v.material[0].emission = {0.5, 0, 0, 1};
    v.material[1].emission = {0, 0.5, 0, 1};
    v.normal = {0, 0, -1};
    specify(v);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glFrontFace(GL_CW);
    for (const GLenum mode : {GL_POINTS, GL_LINES}) {
        WindowRecorder recorder;
        glBegin(mode);
        glNormal3f(0, 0, -1);
        glVertex2f(0, 0);
        glVertex2f(1, 1);
        glEnd();
        ASSERT_FALSE(recorder.primitives.empty());
        EXPECT_LT(difference(recorder.primitives[0].corner[0], equation(v, 0)), 0.001);
    }
}

/// Both sides of a clipped polygon are lit; the back colours come from interpolated normals and positions.
TEST_F(Lighting, TheBackOfAClippedPolygon) {
    for (const bool positional : {false, true}) {
        LitVertex v;
        v.material[1].diffuse = {0, 0.5, 0, 1};
        v.normal = {0, 0, -1};
        if (positional)
            v.light[0].position = {500, 0, 300, 1};
        specify(v);
        glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
        WindowRecorder recorder;
        glNormal3f(0, 0, -1);
        glBegin(GL_TRIANGLES);
        glVertex3f(0, 0, 0);
        glVertex3f(0, 10, 0);
        glVertex3f(5000, 5, 0); // beyond the guard band
        glEnd();
        ASSERT_FALSE(recorder.primitives.empty());
        for (const Primitive& p : recorder.primitives)
            for (const raster::FixedVertex& corner : p.corner) {
                LitVertex at = v;
                at.position = {corner.x / 256.0 * 400 / size - 200, corner.y / 256.0 * 400 / size - 200, 0,
                               1};
                EXPECT_LT(difference(corner, equation(at, 1)), positional ? 0.01 : 0.001) << at.position[0];
            }
    }
}

} // namespace
} // namespace spangle::test

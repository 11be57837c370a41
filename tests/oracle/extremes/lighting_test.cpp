// Compares lighting at the ends of its parameters with the equation of GL 1.3, 2.13.1 in double.
#include "tests/gl/vertex/lighting_equation.hpp"
#include "tests/oracle/extremes/extreme.hpp"

namespace spangle::test {
namespace {

/// Lights the window with one vertex's parameters, and compares the colour with the equation, in 255ths.
class Lit {
  public:
    double worst = 0;
    long colours = 0;

    explicit Lit(EGLint tier) : screen_(tier, 8) {
        glEnable(GL_LIGHTING);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
    }
    /// Returns what is drawn at the vertex, whose place `v` gives.
    Rgba draw(const LitVertex& v) {
        specify(v);
        glMatrixMode(GL_PROJECTION); // moves the vertex to the middle of the window
        glLoadIdentity();
        glScaled(1e-9, 1e-9, 1e-9);
        glMatrixMode(GL_MODELVIEW);
        glClear(GL_COLOR_BUFFER_BIT);
        glPointSize(9);
        glNormal3d(v.normal[0], v.normal[1], v.normal[2]);
        glBegin(GL_POINTS);
        glVertex4d(v.position[0], v.position[1], v.position[2], v.position[3]);
        glEnd();
        return screen_.pixel(4, 4);
    }
    void compare(const LitVertex& v) { compare(v, v); }
    /// `judged` takes the place of `v` if a cosine of the equation is above 4, at which cosines saturate.
    void compare(const LitVertex& v, const LitVertex& judged) {
        const Rgba is = draw(v);
        const LitColor exact = equation(judged, 0);
        if (exact.margin < 1e-6)
            return;
        ++colours;
        for (std::size_t c = 0; c < 3; ++c)
            worst = std::fmax(worst, std::fabs(is[c] - 255 * exact.primary[c]));
    }
    [[nodiscard]] const Screen& screen() const { return screen_; }

  private:
    Screen screen_;
};

/// Storing rounds by half a code, and arithmetic adds a tenth.
constexpr double allowed = 0.6;

LitVertex white() {
    LitVertex v;
    v.scene_ambient = {0, 0, 0, 1};
    v.material[0].ambient = {0, 0, 0, 1};
    v.material[0].diffuse = {0.8f, 0.4f, 0.2f, 1};
    v.normal = {0, 0, 1};
    return v;
}

TEST(Extreme, 21_SingularMatrices) {
    double worst = 0;
    for (const EGLint tier : tiers) {
        Lit lit(tier);
        glEnable(GL_NORMALIZE);
        // The matrix has no inverse, so the normal is arbitrary.
        for (const Mat4& m : {Mat4{}, Mat4{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1},
                              Mat4{1, 2, 3, 0, 2, 4, 6, 0, 3, 6, 9, 0, 0, 0, 0, 1},
                              Mat4{1e-38, 0, 0, 0, 0, 1e-38, 0, 0, 0, 0, 1e-38, 0, 0, 0, 0, 1e38}}) {
            specify(white());
            glLoadMatrixd(m.data());
            glBegin(GL_TRIANGLES);
            for (int i = 0; i < 6; ++i) {
                glNormal3i(i, 1, 1);
                glVertex3i(i % 3, i / 2, i);
            }
            glEnd();
        }
        for (const double scale : {1e-6, 1.0, 1e6, -1e-6}) {
            LitVertex v = white();
            v.normalize = true;
            v.modelview = {scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, 1};
            v.normal = {0.25, 0.5, scale < 0 ? -1.0 : 1.0};
            lit.compare(v);
        }
        worst = std::fmax(worst, lit.worst);
        EXPECT_EQ(lit.colours, 4);
    }
    EXPECT_LE(worst, allowed);
    row("no inverse: no crash; scales of 10^-6 and 10^6 leave unit normals", "the lighting equation",
        "%.2f of 255 off at most", worst);
}

TEST(Extreme, 22_LengthsOfNormals) {
    double worst = 0;
    for (const EGLint tier : tiers) {
        Lit lit(tier);
        for (const double length : {0x1p-100, 0x1p-15, 1.0, 0x1p15, 0x1p60}) {
            LitVertex v = white();
            v.normalize = true;
            v.normal = {0, 0.6 * length, 0.8 * length};
            lit.compare(v);
        }
        // Without NORMALIZE, a zero normal has no diffuse light, and a long normal has more than all.
        for (const double z : {0.0, 0x1p-15, 0x1p15}) {
            LitVertex v = white();
            v.material[0].emission = {0.25f, 0, 0, 1};
            v.normal = {0, 0, z};
            LitVertex judged = v;
            judged.normal = {0, 0, std::fmin(z, 4)};
            lit.compare(v, judged);
        }
        LitVertex none = white();
        none.normalize = true;
        none.normal = {0, 0, 0};
        const Rgba a = lit.draw(none);
        EXPECT_EQ(a[3], 255); // something is drawn, whatever its red is
        worst = std::fmax(worst, lit.worst);
        EXPECT_EQ(lit.colours, 8);
    }
    EXPECT_LE(worst, allowed);
    row("unit from 2^-100 to 2^60; none gives no diffuse light, long ones saturate", "the lighting equation",
        "%.2f of 255 off at most", worst);
}

TEST(Extreme, 23_Spots) {
    double worst = 0;
    long colours = 0;
    for (const EGLint tier : tiers) {
        Lit lit(tier);
        for (const double exponent : {0.0, 1.0, 128.0})
            for (const double cutoff : {0.0, 1.0, 89.0, 90.0, 180.0})
                for (const double x : {0.0, 0.05, 0.5, 40.0}) {
                    LitVertex v = white();
                    LightSource& l = v.light[0];
                    l.position = {x, 0, 2, 1};
                    l.spot_direction = {0, 0, -1};
                    l.spot_exponent = exponent, l.spot_cutoff = cutoff;
                    lit.compare(v);
                }
        // The light is at the vertex and has no direction; the result must still be a colour.
        LitVertex v = white();
        v.light[0].position = v.position;
        v.light[0].spot_cutoff = 45;
        EXPECT_EQ(lit.draw(v)[3], 255);
        const GLfloat above = 128.5F, below = -0.5F, wide = 90.5F;
        glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, above);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
        glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, below);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
        glLightxOES(GL_LIGHT0, GL_SPOT_CUTOFF, fixed(double{wide}));
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
        worst = std::fmax(worst, lit.worst);
        colours += lit.colours;
    }
    EXPECT_LE(worst, allowed);
    EXPECT_GT(colours, 120);
    row("exponents 0 to 128, cutoffs 0 to 90 and 180; 0 outside the cone", "the lighting equation",
        "%.2f of 255 off at most in %ld colours", worst, colours);
}

TEST(Extreme, 24_Shininess) {
    double worst = 0;
    long colours = 0, falls = 0;
    for (const EGLint tier : tiers) {
        Lit lit(tier);
        LitVertex v = white();
        v.material[0].specular = {1, 1, 1, 1};
        v.material[0].diffuse = {0, 0, 0, 1};
        for (const double shininess : {0.0, 0.5, 1.0, 64.0, 128.0}) {
            int before = 256;
            for (int degrees = 0; degrees < 120; ++degrees) {
                // n.h is the cosine of half the angle; at 0 it is exactly 1.
                const double angle = degrees * std::acos(-1.0) / 180;
                v.material[0].shininess = shininess;
                v.light[0].position = {std::sin(angle), 0, std::cos(angle), 0};
                v.normal = {0, 0, 1};
                if (degrees < 90)
                    lit.compare(v);
                const int now = lit.draw(v)[0];
                falls += now > before ? 1 : 0;
                before = now;
            }
        }
        // n.h is 0 and n.l is not: 0^0 is 1.
        v.material[0].shininess = 0;
        v.light[0].position = {1, 0, 0, 0};
        v.normal = {0.5, 0, -0.5};
        EXPECT_EQ(lit.draw(v)[0], 255);
        worst = std::fmax(worst, lit.worst);
        colours += lit.colours;
    }
    EXPECT_EQ(falls, 0);
    EXPECT_LE(worst, allowed);
    EXPECT_GT(colours, 1'200);
    row("0^0 is 1; monotone in n.h for 0 to 128", "the lighting equation",
        "%.2f of 255 off at most in %ld colours, %ld rises", worst, colours, falls);
}

TEST(Extreme, 25_Attenuation) {
    double worst = 0;
    long colours = 0;
    for (const EGLint tier : tiers) {
        Lit lit(tier);
        for (const double constant : {0.0, 0x1p-15, 1.0, 0x1p15})
            for (const double linear : {0.0, 0x1p-10, 0x1p15})
                for (const double quadratic : {0.0, 0x1p-20, 0x1p15})
                    for (const double distance : {0x1p-10, 1.0, 1000.0}) {
                        LitVertex v = white();
                        LightSource& l = v.light[0];
                        l.constant = constant, l.linear = linear, l.quadratic = quadratic;
                        l.position = {0, 0, distance, 1};
                        if (constant + linear + quadratic == 0)
                            // The input is not a number, so any colour is right.
                            EXPECT_EQ(lit.draw(v)[3], 255);
                        else
                            lit.compare(v);
                    }
        worst = std::fmax(worst, lit.worst);
        colours += lit.colours;
    }
    EXPECT_LE(worst, allowed);
    row("0, 0, 0 leaves a colour; 2^-15 to 2^15 as they are", "the lighting equation",
        "%.2f of 255 off at most in %ld colours", worst, colours);
}

} // namespace
} // namespace spangle::test

// Tests positions at the ends of their types, and how they are clipped.
#include <limits>

#include "tests/oracle/extremes/extreme.hpp"

namespace spangle::test {
namespace {

std::array<GLfloat, 16> modelview() {
    std::array<GLfloat, 16> m{};
    glGetFloatv(GL_MODELVIEW_MATRIX, m.data());
    return m;
}

TEST(Extreme, 01_PositionsOfAllBits) {
    const GLfixed lowest = std::numeric_limits<GLfixed>::min(), most = std::numeric_limits<GLfixed>::max();
    Tally tally;
    int queries = 0;
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        for (const Form form : forms) {
            const double end = form == Form::of_int ? 0x1p31 : 0x1p15;
            const std::array<Place, 3> v{{{-end, -end, 0, 1}, {end, -end, 0, 1}, {-end, end, 0, 1}}};
            glClear(GL_COLOR_BUFFER_BIT);
            polygon(form, GL_TRIANGLES, v);
            tally.count(screen.picture(), v);
        }
        // The smallest factor makes the largest coordinates 1/2. A rectangle of these covers 32 x 32 pixels.
        glScalexOES(1, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        polygon(Form::of_fixed, GL_QUADS,
                std::array<Place, 4>{{{-32768, -32768, 0, 1},
                                      {32768, -32768, 0, 1},
                                      {32768, 32768, 0, 1},
                                      {-32768, 32768, 0, 1}}});
        const Picture half = screen.picture();
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const bool inside = x >= 16 && x < 48 && y >= 16 && y < 48;
                tally.wrong += (half[static_cast<std::size_t>(y * side + x)][0] != 0) != inside ? 1 : 0;
            }
        for (const GLfixed number : {lowest, most, 1, -1}) {
            glLoadIdentity();
            glTranslatexOES(number, number, number);
            EXPECT_NEAR(modelview()[12], number / 65536.0, std::fabs(number / 65536.0) * 0x1p-24);
            glLoadIdentity();
            glScalexOES(number, number, number);
            EXPECT_NEAR(modelview()[5], number / 65536.0, std::fabs(number / 65536.0) * 0x1p-24);
            queries += 2;
            // These angles are whole turns plus 32768 mod 360 = 8 degrees.
            glLoadIdentity();
            glRotatexOES(number, 0, 0, 65536);
            EXPECT_NEAR(modelview()[0], std::cos(number / 65536.0 * std::acos(-1.0) / 180), 1e-6);
            glRotatexOES(65536, number, number, number);
            glTexCoord4xOES(number, number, number, number);
            glNormal3xOES(number, number, number);
            // This is an error, because its planes coincide, and changes nothing.
            glFrustumxOES(number, number, number, number, number, number);
            EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
            glLoadIdentity();
            glColor4xOES(number, number, number, number);
            glClear(GL_COLOR_BUFFER_BIT);
            rectangle(-1, -1, 1, 1);
            EXPECT_EQ(screen.pixel(9, 9)[0], number == most ? 255 : 0);
            glColor3f(1, 1, 1);
        }
    }
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_GT(tally.fragments, 20'000);
    row("saturates, no overflow", "exact edges; queries against the numbers",
        "%ld of %ld fragments wrong, %d queries", tally.wrong, tally.fragments, queries);
}

TEST(Extreme, 02_NoNumbers) {
    Tally tally;
    const double inf = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        for (const Form form : {Form::of_float, Form::of_double})
            for (const double zero : {0.0, -0.0, 1e-42, -1e-42, 1e-310, nan})
                for (const double far : {1e38, inf}) {
                    // Numbers that are not finite become 0 or the largest, so the drawing covers a quarter of
                    // the window.
                    glClear(GL_COLOR_BUFFER_BIT);
                    polygon(form, GL_TRIANGLES,
                            std::array<Place, 3>{
                                {{zero, zero, zero, 1}, {far, zero, zero, 1}, {zero, far, zero, 1}}});
                    tally.count(screen.picture(), {{{0, 0, 0, 1}, {1e9, 0, 0, 1}, {0, 1e9, 0, 1}}});
                }
        // Whatever such numbers reach, the context draws afterwards as before.
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        for (const double number : {nan, inf, -inf, 1e38, -1e308, 1e-42}) {
            const auto f = static_cast<GLfloat>(number);
            glPushMatrix();
            glRotated(number, number, 1, 0);
            glScalef(f, f, f);
            glTranslated(number, number, number);
            const std::array<GLfloat, 4> four{f, f, f, f};
            glEnable(GL_LIGHTING);
            glEnable(GL_LIGHT0);
            glLightfv(GL_LIGHT0, GL_POSITION, four.data());
            glLightfv(GL_LIGHT0, GL_DIFFUSE, four.data());
            glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, four.data());
            glEnable(GL_FOG);
            glFogfv(GL_FOG_COLOR, four.data());
            glNormal3fv(four.data());
            glTexCoord4fv(four.data());
            glBegin(GL_TRIANGLES);
            for (int i = 0; i < 6; ++i) {
                glVertex4d(i % 2, number, i, i < 3 ? 1 : number);
            }
            glEnd();
            glPopMatrix();
        }
        glPopAttrib();
        glColor3f(1, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        const std::array<Place, 3> v{{{-0.7, -0.4, 0, 1}, {0.8, 0.1, 0, 1}, {-0.2, 0.9, 0, 1}}};
        polygon(Form::of_float, GL_TRIANGLES, v);
        tally.count(screen.picture(), v);
    }
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_GT(tally.fragments, 50'000);
    row("NaN is 0, infinities are the largest number, state stays sane", "exact edges, afterwards too",
        "%ld of %ld fragments wrong", tally.wrong, tally.fragments);
}

TEST(Extreme, 03_WAtAndBelowZero) {
    Tally tally;
    Random random{3};
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        for (const Form form : forms)
            for (unsigned n = 0; n < 48; ++n) {
                const double ulp = form == Form::of_fixed ? 0x1p-16 : form == Form::of_int ? 1 : 0x1p-120;
                const double odd = n % 4 == 0 ? 0 : n % 4 == 1 ? ulp : n % 4 == 2 ? -ulp : -1;
                const unsigned many = n / 4 % 3 + 1;
                const double unit = form == Form::of_int ? 1000 : 1;
                std::array<Place, 3> v{};
                for (unsigned i = 0; i < 3; ++i) {
                    const auto lot = [&] { return (random.below(2001) / 1000.0 - 1) * unit; };
                    v[i] = {lot(), lot(), 0, i < many ? odd : unit};
                    if (form == Form::of_fixed)
                        v[i] = {fixed(v[i][0]) / 65536.0, fixed(v[i][1]) / 65536.0, 0, v[i][3]};
                    if (form == Form::of_int)
                        v[i] = {double(whole(v[i][0])), double(whole(v[i][1])), 0, v[i][3]};
                    if (form == Form::of_float)
                        v[i] = {double(float(v[i][0])), double(float(v[i][1])), 0, v[i][3]};
                }
                glClear(GL_COLOR_BUFFER_BIT);
                polygon(form, GL_TRIANGLES, v);
                const Picture picture = screen.picture();
                if (many == 3 && odd <= 0) { // nothing is in front of the eye
                    for (const Rgba& pixel : picture)
                        tally.wrong += pixel[0] != 0 ? 1 : 0;
                } else {
                    tally.count(picture, v);
                }
            }
    }
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_GT(tally.fragments, 50'000);
    row("drawn where w > 0, never behind", "homogeneous edges", "%ld of %ld fragments wrong", tally.wrong,
        tally.fragments);
}

TEST(Extreme, 04_NearPlane) {
    Tally tally;
    long twice = 0;
    Random random{4};
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        for (const Form form : fractions)
            for (int n = 0; n < 24; ++n) {
                // z is a x + b y + c, and two triangles share the diagonal of a square.
                const auto lot = [&] { return (random.below(4001) - 2000.0) / 1024; };
                const double a = lot(), b = lot(), c = lot() - 1;
                const auto corner = [&](double x, double y) { return Place{x, y, a * x + b * y + c, 1}; };
                const std::array<Place, 4> v{
                    {corner(-0.75, -0.75), corner(0.75, -0.75), corner(0.75, 0.75), corner(-0.75, 0.75)}};
                Screen::count_fragments();
                polygon(form, GL_TRIANGLES, std::array<Place, 6>{{v[0], v[1], v[2], v[2], v[3], v[0]}});
                const Picture picture = screen.picture();
                for (int y = 0; y < side; ++y)
                    for (int x = 0; x < side; ++x) {
                        const double u = (2 * x + 1.0) / side - 1, w = (2 * y + 1.0) / side - 1;
                        const double z = a * u + b * w + c, slope = std::hypot(a, b) * 2 / side + 1e-9;
                        const double in = 0.75 - std::fmax(std::fabs(u), std::fabs(w));
                        const Seen place{in > 0 && z >= -1 && z <= 1,
                                         std::fmin(std::fmin(std::fabs(z + 1), std::fabs(1 - z)) / slope,
                                                   std::fabs(in) * side / 2)};
                        const GLubyte count = picture[static_cast<std::size_t>(y * side + x)][0];
                        tally.count(count != 0, place, 1.0 / 64);
                        twice += count > 1 ? 1 : 0;
                    }
            }
        // Vertices on the plane are inside.
        glDisable(GL_BLEND);
        glColor3f(1, 1, 1);
        for (const Form form : forms) {
            glClear(GL_COLOR_BUFFER_BIT);
            const std::array<Place, 3> v{{{-1, -1, -1, 1}, {1, -1, -1, 1}, {-1, 1, -1, 1}}};
            polygon(form, GL_TRIANGLES, v);
            tally.count(screen.picture(), v);
        }
    }
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_EQ(twice, 0);
    EXPECT_GT(tally.fragments, 50'000);
    row("a vertex on the plane is inside; clipped shared edges meet", "z of each pixel; counting blend",
        "%ld of %ld fragments wrong, %ld twice", tally.wrong, tally.fragments, twice);
}

TEST(Extreme, 05_AllPlanesAtOnce) {
    Tally tally;
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        GLint planes = 0;
        glGetIntegerv(GL_MAX_CLIP_PLANES, &planes);
        ASSERT_GE(planes, 6);
        for (const Form form : fractions)
            for (int n = 0; n < 12; ++n) {
                std::array<std::array<double, 3>, 6> cut{};
                for (unsigned i = 0; i < 6; ++i) {
                    const double angle = (i * 60 + n * 5) * std::acos(-1.0) / 180;
                    cut[i] = {std::cos(angle), std::sin(angle), 0.5 + 0.07 * n};
                    const std::array<GLdouble, 4> plane{cut[i][0], cut[i][1], 0, cut[i][2]};
                    std::array<GLfixed, 4> x{};
                    std::array<GLfloat, 4> f{};
                    std::transform(plane.begin(), plane.end(), x.begin(), fixed);
                    std::copy(plane.begin(), plane.end(), f.begin());
                    if (form == Form::of_fixed)
                        glClipPlanexOES(GL_CLIP_PLANE0 + i, x.data());
                    else if (form == Form::of_float)
                        glClipPlanefOES(GL_CLIP_PLANE0 + i, f.data());
                    else
                        glClipPlane(GL_CLIP_PLANE0 + i, plane.data());
                    glEnable(GL_CLIP_PLANE0 + i);
                }
                // The slope of z makes the near and the far plane clip, too.
                const double a = 1.5, b = n % 2 == 0 ? 0.5 : -0.5;
                const auto corner = [&](double x, double y) { return Place{x, y, a * x + b * y, 1}; };
                glClear(GL_COLOR_BUFFER_BIT);
                polygon(form, GL_TRIANGLES,
                        std::array<Place, 3>{{corner(-8, -8), corner(8, -8), corner(0, 16)}});
                const Picture picture = screen.picture();
                for (int y = 0; y < side; ++y)
                    for (int x = 0; x < side; ++x) {
                        const double u = (2 * x + 1.0) / side - 1, w = (2 * y + 1.0) / side - 1;
                        const double z = a * u + b * w;
                        double in = (1 - std::fabs(z)) / std::hypot(a, b);
                        for (const auto& plane : cut)
                            in = std::fmin(in, plane[0] * u + plane[1] * w + plane[2]);
                        tally.count(picture[static_cast<std::size_t>(y * side + x)][0] != 0,
                                    {in > 0, std::fabs(in) * side / 2}, 1.0 / 32);
                    }
            }
    }
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_GT(tally.fragments, 50'000);
    row("six planes of the volume and six of the user's cut one triangle", "the planes at each pixel",
        "%ld of %ld fragments wrong", tally.wrong, tally.fragments);
}

TEST(Extreme, 06_AThousandViewports) {
    Tally tally;
    Random random{6};
    for (const EGLint tier : tiers) {
        const Screen screen(tier);
        for (const Form form : forms)
            for (int n = 0; n < 12; ++n) {
                std::array<Place, 3> v{};
                for (Place& place : v)
                    place = {random.below(4001) - 2000.0, random.below(4001) - 2000.0, 0, 1};
                v[0][0] = n % 2, v[0][1] = 0; // one corner is near, so that edges cross the window
                glClear(GL_COLOR_BUFFER_BIT);
                polygon(form, GL_TRIANGLES, v);
                tally.count(screen.picture(), v);
            }
    }
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_GT(tally.fragments, 50'000);
    row("no wrap: the part in the window is drawn", "exact edges", "%ld of %ld fragments wrong", tally.wrong,
        tally.fragments);
}

} // namespace
} // namespace spangle::test

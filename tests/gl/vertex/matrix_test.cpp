// Rows C01 to C03: compares matrices, stacks, viewport and depth range with formulas in double.
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/lighting_equation.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

/// Makes a matrix of rows, as GL 1.3, 2.10.2 prints them.
Mat4 rows(const Vec4& a, const Vec4& b, const Vec4& c, const Vec4& d) {
    Mat4 m;
    for (std::size_t j = 0; j < 4; ++j)
        m[4 * j] = a[j], m[4 * j + 1] = b[j], m[4 * j + 2] = c[j], m[4 * j + 3] = d[j];
    return m;
}
Mat4 rotation(double degrees, Vec3 axis) {
    const double a = degrees * std::acos(-1.0) / 180, c = std::cos(a), s = std::sin(a), k = 1 - c;
    const auto [x, y, z] = unit(axis);
    return rows({x * x * k + c, x * y * k - z * s, x * z * k + y * s, 0},
                {y * x * k + z * s, y * y * k + c, y * z * k - x * s, 0},
                {z * x * k - y * s, z * y * k + x * s, z * z * k + c, 0}, {0, 0, 0, 1});
}
Mat4 translation(double x, double y, double z) {
    return rows({1, 0, 0, x}, {0, 1, 0, y}, {0, 0, 1, z}, {0, 0, 0, 1});
}
Mat4 scaling(double x, double y, double z) {
    return rows({x, 0, 0, 0}, {0, y, 0, 0}, {0, 0, z, 0}, {0, 0, 0, 1});
}
Mat4 frustum(double l, double r, double b, double t, double n, double f) {
    return rows({2 * n / (r - l), 0, (r + l) / (r - l), 0}, {0, 2 * n / (t - b), (t + b) / (t - b), 0},
                {0, 0, -(f + n) / (f - n), -2 * f * n / (f - n)}, {0, 0, -1, 0});
}
Mat4 ortho(double l, double r, double b, double t, double n, double f) {
    return rows({2 / (r - l), 0, 0, -(r + l) / (r - l)}, {0, 2 / (t - b), 0, -(t + b) / (t - b)},
                {0, 0, -2 / (f - n), -(f + n) / (f - n)}, {0, 0, 0, 1});
}

class Matrices : public Canvas {
  protected:
    std::mt19937 random_{5};

    /// Returns a number that every form can hold: 13 fraction bits, and no more than 24 bits in all.
    double number(double low, double high) {
        return std::floor(std::uniform_real_distribution<>(low, high)(random_) * 8192 + 0.5) / 8192;
    }
    static GLfloat f(double v) { return static_cast<GLfloat>(v); }
    static GLfixed x(double v) { return static_cast<GLfixed>(v * 65536); }

    static Mat4 current(GLenum name) {
        Mat4 m;
        glGetDoublev(name, m.data());
        return m;
    }

    /// Calls one of the commands in one of its forms, and returns its matrix.
    Mat4 command(int which, int form);
};

Mat4 Matrices::command(int which, int form) {
    const double a = number(-3, 3), b = number(-3, 3), c = number(-3, 3), angle = number(-720, 720);
    const double l = number(-9, -1), r = number(1, 9), bottom = number(-9, -1), top = number(1, 9),
                 n = number(1, 5), far = number(6, 99);
    Mat4 m;
    for (double& v : m)
        v = number(-2, 2);
    GLfloat mf[16];
    GLfixed mx[16];
    for (std::size_t i = 0; i < 16; ++i)
        mf[i] = f(m[i]), mx[i] = x(m[i]);
    switch (which) {
    case 0:
        form == 0   ? glRotatef(f(angle), f(a), f(b), f(c))
        : form == 1 ? glRotated(angle, a, b, c)
                    : glRotatexOES(x(angle), x(a), x(b), x(c));
        return rotation(angle, {a, b, c});
    case 1:
        form == 0   ? glTranslatef(f(a), f(b), f(c))
        : form == 1 ? glTranslated(a, b, c)
                    : glTranslatexOES(x(a), x(b), x(c));
        return translation(a, b, c);
    case 2:
        form == 0   ? glScalef(f(a), f(b), f(c))
        : form == 1 ? glScaled(a, b, c)
                    : glScalexOES(x(a), x(b), x(c));
        return scaling(a, b, c);
    case 3:
        form < 2 ? glFrustum(l, r, bottom, top, n, far)
                 : glFrustumxOES(x(l), x(r), x(bottom), x(top), x(n), x(far));
        return frustum(l, r, bottom, top, n, far);
    case 4:
        form < 2 ? glOrtho(l, r, bottom, top, n, far)
                 : glOrthoxOES(x(l), x(r), x(bottom), x(top), x(n), x(far));
        return ortho(l, r, bottom, top, n, far);
    default:
        form == 0 ? glMultMatrixf(mf) : form == 1 ? glMultMatrixd(m.data()) : glMultMatrixxOES(mx);
        return m;
    }
}

/// Returns by how much each element of m may be wrong: elements of a rotation by a part of 1, others by a
/// part of their size.
Mat4 sizes(const Mat4& m, bool rotates) {
    Mat4 r;
    for (std::size_t i = 0; i < 16; ++i)
        r[i] = rotates && i % 4 < 3 && i < 12 ? 1 : std::fabs(m[i]);
    return r;
}

/// Multiplies up to 12 commands on each stack. Sums may cancel, so errors are relative to the sum of the
/// terms' sizes.
TEST_F(Matrices, EveryCommandInEveryForm) {
    double worst = 0;
    const std::pair<GLenum, GLenum> stacks[] = {{GL_MODELVIEW, GL_MODELVIEW_MATRIX},
                                                {GL_PROJECTION, GL_PROJECTION_MATRIX},
                                                {GL_TEXTURE, GL_TEXTURE_MATRIX}};
    for (int chain = 0; chain < 3000; ++chain) {
        const auto [mode, name] = stacks[chain % 3];
        glMatrixMode(mode);
        glLoadIdentity();
        Mat4 expected = identity(), terms = identity();
        for (int k = 0; k <= chain % 12; ++k) {
            const int which = static_cast<int>(random_() % 6), form = static_cast<int>(random_() % 3);
            const Mat4 m = command(which, form);
            expected = times(expected, m);
            terms = times(terms, sizes(m, which == 0));
            const Mat4 got = current(name);
            for (std::size_t i = 0; i < 16; ++i) {
                // A query returns a float, which adds 2^-24 of the element to the error.
                const double error =
                    std::fabs(got[i] - expected[i]) - std::ldexp(std::fabs(expected[i]), -24);
                ASSERT_LE(error, std::ldexp(terms[i], -28))
                    << "chain " << chain << ", command " << which << ", form " << form << ", element " << i;
                if (terms[i] > 0)
                    worst = std::fmax(worst, error / terms[i]);
            }
        }
    }
    std::printf("matrices: worst error 2^%.1f of the sum of terms\n", std::log2(worst));
}

/// Row-major matrices in every form, and their queries (GL 1.3, 2.10.2 and 6.1.2).
TEST_F(Matrices, TransposedMatrices) {
    GLdouble rows[16], expected[16], got[16];
    GLfloat rows_f[16];
    GLfixed rows_x[16];
    for (int i = 0; i < 16; ++i) {
        rows[i] = number(-3, 3);
        rows_f[i] = f(rows[i]);
        rows_x[i] = x(rows[i]);
        expected[i % 4 * 4 + i / 4] = rows[i];
    }
    const struct {
        GLenum mode, name, transposed;
    } stacks[] = {{GL_MODELVIEW, GL_MODELVIEW_MATRIX, GL_TRANSPOSE_MODELVIEW_MATRIX},
                  {GL_PROJECTION, GL_PROJECTION_MATRIX, GL_TRANSPOSE_PROJECTION_MATRIX},
                  {GL_TEXTURE, GL_TEXTURE_MATRIX, GL_TRANSPOSE_TEXTURE_MATRIX}};
    for (const auto& stack : stacks) {
        glMatrixMode(stack.mode);
        for (int form = 0; form < 6; ++form) {
            glLoadIdentity();
            form == 0   ? glLoadTransposeMatrixd(rows)
            : form == 1 ? glLoadTransposeMatrixf(rows_f)
            : form == 2 ? glLoadTransposeMatrixxOES(rows_x)
            : form == 3 ? glMultTransposeMatrixd(rows)
            : form == 4 ? glMultTransposeMatrixf(rows_f)
                        : glMultTransposeMatrixxOES(rows_x);
            glGetDoublev(stack.name, got);
            for (int i = 0; i < 16; ++i)
                EXPECT_EQ(got[i], expected[i]) << stack.mode << ' ' << form << ' ' << i;
            glGetDoublev(stack.transposed, got);
            for (int i = 0; i < 16; ++i)
                EXPECT_EQ(got[i], rows[i]) << stack.mode << ' ' << form << ' ' << i;
        }
        glTranslatef(1, 2, 3);
        glMultTransposeMatrixd(rows); // multiplies on the right
        glGetDoublev(stack.name, got);
        Mat4 product;
        std::copy(expected, expected + 16, product.begin());
        product = times(times(product, translation(1, 2, 3)), product);
        for (std::size_t i = 0; i < 16; ++i)
            EXPECT_NEAR(got[i], product[i], 1e-4);
    }
}

/// Angles of any size are reduced without error: a float is a number of whole degrees and a fraction.
TEST_F(Matrices, LargeAngles) {
    for (const GLfloat angle : {123456.75f, -98765.5f, 1e7f, 16777215.0f, -3e9f, 1e20f, 3e38f}) {
        glLoadIdentity();
        glRotatef(angle, 0, 0, 3);
        const Mat4 got = current(GL_MODELVIEW_MATRIX),
                   expected = rotation(std::fmod(angle, 360.0), {0, 0, 1});
        for (std::size_t i = 0; i < 16; ++i)
            EXPECT_NEAR(got[i], expected[i], std::ldexp(1, -24)) << angle << ' ' << i;
    }
}

/// With a condition number of 2^40 the product is as good as its terms allow, and so is its inverse, which
/// lighting uses.
TEST_F(Matrices, IllConditioned) {
    glScalef(std::ldexp(1.0f, 20), 1, std::ldexp(1.0f, -20));
    glRotatef(30, 1, 1, 0);
    glScalef(std::ldexp(1.0f, -20), 1, std::ldexp(1.0f, 20));
    const Mat4 r = rotation(30, {1, 1, 0}), got = current(GL_MODELVIEW_MATRIX);
    const double left[3] = {std::ldexp(1, 20), 1, std::ldexp(1, -20)},
                 right[3] = {std::ldexp(1, -20), 1, std::ldexp(1, 20)};
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i) {
            const double expected = r[4 * j + i] * left[i] * right[j];
            EXPECT_NEAR(got[4 * j + i], expected, std::ldexp(left[i] * right[j], -24)) << i << j;
        }
}

/// Elements beyond the largest number become the largest, and elements below the smallest become zero.
/// Nothing undefined follows.
TEST_F(Matrices, Extremes) {
    const GLfloat most = std::numeric_limits<GLfloat>::max(), nan = std::numeric_limits<GLfloat>::quiet_NaN(),
                  infinity = std::numeric_limits<GLfloat>::infinity();
    for (int n = 0; n < 4; ++n)
        glScalef(1e30f, -1e30f, 1e-30f);
    GLfloat m[16];
    glGetFloatv(GL_MODELVIEW_MATRIX, m);
    EXPECT_EQ(m[0], most);
    EXPECT_EQ(m[5], most) << "four times turned";
    EXPECT_EQ(m[10], 0.0f);
    EXPECT_EQ(m[15], 1.0f);
    glScalef(1, -1, 1);
    glGetFloatv(GL_MODELVIEW_MATRIX, m);
    EXPECT_EQ(m[5], -most);
    const GLfloat odd[16] = {nan, infinity, -infinity, 1e-45f, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    glLoadMatrixf(odd);
    glGetFloatv(GL_MODELVIEW_MATRIX, m);
    EXPECT_EQ(m[0], 0.0f);
    EXPECT_EQ(m[1], most);
    EXPECT_EQ(m[2], -most);
    EXPECT_EQ(m[3], 1e-45f);
    const GLdouble far_off[16] = {1e300, -1e300, 1e-300, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    glLoadMatrixd(far_off);
    glGetFloatv(GL_MODELVIEW_MATRIX, m);
    EXPECT_EQ(m[0], most);
    EXPECT_EQ(m[1], -most);
    EXPECT_EQ(m[2], 0.0f);
}

/// Every stack holds as many matrices as the limits say: 32, 2 and 2.
TEST_F(Matrices, StacksOverflowAndUnderflow) {
    const struct {
        GLenum mode, limit, depth;
        GLint least;
    } stacks[] = {{GL_MODELVIEW, GL_MAX_MODELVIEW_STACK_DEPTH, GL_MODELVIEW_STACK_DEPTH, 32},
                  {GL_PROJECTION, GL_MAX_PROJECTION_STACK_DEPTH, GL_PROJECTION_STACK_DEPTH, 2},
                  {GL_TEXTURE, GL_MAX_TEXTURE_STACK_DEPTH, GL_TEXTURE_STACK_DEPTH, 2}};
    for (const auto& stack : stacks) {
        glMatrixMode(stack.mode);
        GLint most = 0, depth = 0;
        glGetIntegerv(stack.limit, &most);
        EXPECT_GE(most, stack.least);
        glPopMatrix();
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_STACK_UNDERFLOW));
        for (int n = 1; n < most; ++n)
            glPushMatrix();
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        glPushMatrix();
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_STACK_OVERFLOW));
        glGetIntegerv(stack.depth, &depth);
        EXPECT_EQ(depth, most);
        for (int n = 1; n < most; ++n)
            glPopMatrix();
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
}

TEST_F(Matrices, LoadMatrixInEveryForm) {
    Mat4 m;
    GLfloat mf[16];
    GLfixed mx[16];
    for (std::size_t i = 0; i < 16; ++i)
        m[i] = number(-99, 99), mf[i] = f(m[i]), mx[i] = x(m[i]);
    for (int form = 0; form < 3; ++form) {
        glLoadIdentity();
        form == 0 ? glLoadMatrixf(mf) : form == 1 ? glLoadMatrixd(m.data()) : glLoadMatrixxOES(mx);
        EXPECT_EQ(current(GL_MODELVIEW_MATRIX), m) << form;
        GLfixed back[16];
        glGetFixedvOES(GL_MODELVIEW_MATRIX, back);
        EXPECT_TRUE(std::equal(back, back + 16, mx)) << form;
    }
}

TEST_F(Matrices, AQueryReturnsWhatWasSet) {
    for (int n = 0; n < 2000; ++n) {
        GLfloat set[16], got[16];
        for (GLfloat& v : set)
            v = static_cast<GLfloat>(std::ldexp(number(-2, 2), static_cast<int>(random_() % 270) - 145));
        glLoadMatrixf(set);
        glGetFloatv(GL_MODELVIEW_MATRIX, got);
        for (int i = 0; i < 16; ++i)
            ASSERT_EQ(got[i], set[i]) << n << ' ' << i;
    }
}

TEST_F(Matrices, StacksAreSeparateAndPopBringsBack) {
    const std::pair<GLenum, GLenum> stacks[] = {{GL_MODELVIEW, GL_MODELVIEW_MATRIX},
                                                {GL_PROJECTION, GL_PROJECTION_MATRIX},
                                                {GL_TEXTURE, GL_TEXTURE_MATRIX}};
    const GLenum depths[] = {GL_MODELVIEW_STACK_DEPTH, GL_PROJECTION_STACK_DEPTH, GL_TEXTURE_STACK_DEPTH};
    for (int s = 0; s < 3; ++s) {
        glMatrixMode(stacks[s].first);
        glTranslatef(f(1 + s), 0, 0);
        glPushMatrix();
        EXPECT_EQ(current(stacks[s].second), translation(1 + s, 0, 0)) << "a pushed matrix is a copy";
        glScalef(2, 2, 2);
        GLint depth = 0;
        glGetIntegerv(depths[s], &depth);
        EXPECT_EQ(depth, 2);
    }
    for (int s = 0; s < 3; ++s) {
        EXPECT_EQ(current(stacks[s].second), times(translation(1 + s, 0, 0), scaling(2, 2, 2)));
        glMatrixMode(stacks[s].first);
        glPopMatrix();
        EXPECT_EQ(current(stacks[s].second), translation(1 + s, 0, 0));
    }
}

TEST_F(Matrices, ErrorsChangeNothing) {
    const auto refused = [](auto call, GLenum expected) {
        const Mat4 before = current(GL_MODELVIEW_MATRIX);
        call();
        EXPECT_EQ(glGetError(), expected);
        EXPECT_EQ(current(GL_MODELVIEW_MATRIX), before);
    };
    glTranslatef(1, 2, 3);
    const GLenum value = GL_INVALID_VALUE;
    refused([] { glFrustum(-1, 1, -1, 1, 0, 2); }, value);
    refused([] { glFrustum(-1, 1, -1, 1, -1, 2); }, value);
    refused([] { glFrustum(-1, 1, -1, 1, 1, 0); }, value);
    refused([] { glFrustum(-1, 1, -1, 1, 1, -2); }, value);
    refused([] { glFrustum(1, 1, -1, 1, 1, 2); }, value);
    refused([] { glFrustum(-1, 1, 1, 1, 1, 2); }, value);
    refused([] { glFrustum(-1, 1, -1, 1, 2, 2); }, value);
    refused([] { glOrtho(1, 1, -1, 1, 1, 2); }, value);
    refused([] { glOrtho(-1, 1, 1, 1, 1, 2); }, value);
    refused([] { glOrtho(-1, 1, -1, 1, 2, 2); }, value);
    refused([] { glMatrixMode(GL_COLOR); }, GL_INVALID_ENUM);
    glOrtho(-1, 1, -1, 1, -1, -2); // planes behind the eye are legal
    glRotatef(30, 0, 0, 0);        // GL does not define the result; it must do no harm
}

// --- From object to window coordinates

TEST_F(Matrices, WindowCoordinates) {
    double worst_xy = 0, worst_z = 0, worst_w = 0, worst_fog = 0;
    int seen = 0;
    glEnable(GL_FOG);
    for (int n = 0; n < 40000; ++n) {
        const int view[4] = {static_cast<int>(random_() % 90) - 45, static_cast<int>(random_() % 90) - 45,
                             static_cast<int>(random_() % 2048) + 1, static_cast<int>(random_() % 2048) + 1};
        const double near_depth = number(0, 1), far_depth = number(0, 1);
        glViewport(view[0], view[1], view[2], view[3]);
        glDepthRange(near_depth, far_depth);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        const Mat4 projection = command(3 + n % 2, n % 3);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        const double depth = number(1, 60);
        glTranslated(0, 0, -depth);
        Mat4 modelview = translation(0, 0, -depth);
        modelview = times(modelview, command(0, n % 3));
        modelview = times(modelview, command(2, n % 3));
        const Vec4 object{number(-3, 3), number(-3, 3), number(-3, 3), number(0.5, 2)};
        const Vec4 eye = times(modelview, object), clip = times(projection, eye);
        WindowRecorder recorder;
        glBegin(GL_POINTS);
        glVertex4dv(object.data());
        glEnd();
        const double edge = std::fmax(std::fmax(std::fabs(clip[0]), std::fabs(clip[1])), std::fabs(clip[2]));
        const double margin = (clip[3] - edge) / std::fmax(std::fabs(clip[3]), edge);
        if (std::fabs(margin) < 1e-6)
            continue;
        ASSERT_EQ(recorder.primitives.empty(), margin < 0) << n;
        if (margin < 0)
            continue;
        ++seen;
        const raster::FixedVertex& v = recorder.primitives[0].corner[0];
        const double x = view[0] + view[2] * (clip[0] / clip[3] + 1) / 2,
                     y = view[1] + view[3] * (clip[1] / clip[3] + 1) / 2,
                     z = (far_depth - near_depth) / 2 * clip[2] / clip[3] + (near_depth + far_depth) / 2;
        worst_xy = std::fmax(worst_xy, std::fmax(std::fabs(v.x / 256.0 - x), std::fabs(v.y / 256.0 - y)));
        worst_z = std::fmax(worst_z, std::fabs(v.z / static_cast<double>(raster::depth_one) - z));
        worst_w = std::fmax(worst_w, std::fabs(std::ldexp(v.w_mantissa, v.w_exponent) * clip[3] - 1));
        // Coordinates of the eye are homogeneous, so fog takes z without a division by w.
        worst_fog = std::fmax(worst_fog,
                              std::fabs(std::ldexp(v.fog_mantissa, v.fog_exponent) / std::fabs(eye[2]) - 1));
    }
    std::printf("%d vertices: x, y within 1/512 + %.2g pixel; z 2^%.1f; 1/w 2^%.1f; fog distance 2^%.1f\n",
                seen, worst_xy - 1.0 / 512, std::log2(worst_z), std::log2(worst_w), std::log2(worst_fog));
    EXPECT_GT(seen, 10000);
    EXPECT_LT(worst_xy, 1.0 / 512 + 1.0 / 65536);
    EXPECT_LT(worst_z, std::ldexp(1, -24));
    EXPECT_LT(worst_w, std::ldexp(1, -24));
    EXPECT_LT(worst_fog, std::ldexp(1, -22));
}

TEST_F(Matrices, ViewportAndDepthRangeLimits) {
    GLint view[4], most[2];
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, most);
    glViewport(3, -4, most[0] + 1, 1 << 30);
    glGetIntegerv(GL_VIEWPORT, view);
    EXPECT_EQ(std::vector<GLint>(view, view + 4), (std::vector<GLint>{3, -4, most[0], most[1]}));
    for (const auto& [w, h] : {std::pair<int, int>{-1, 5}, {5, -1}}) {
        glViewport(0, 0, w, h);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
    }
    glGetIntegerv(GL_VIEWPORT, view);
    EXPECT_EQ(view[1], -4) << "an error changes nothing";
    glDepthRange(-3, 7);
    GLdouble depth[2];
    glGetDoublev(GL_DEPTH_RANGE, depth);
    EXPECT_EQ(depth[0], 0.0);
    EXPECT_EQ(depth[1], 1.0);
    glDepthRangexOES(0xC000, 0x4000);
    glGetDoublev(GL_DEPTH_RANGE, depth);
    EXPECT_EQ(depth[0], 0.75) << "near may be beyond far";
    EXPECT_EQ(depth[1], 0.25);
}

} // namespace
} // namespace spangle::test

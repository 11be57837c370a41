// Positions, normals and texture coordinates up to 2^32 are right within 1 part in 10^5 (GL 1.3, 2.1.1). The
// results are read from feedback, from queries and from the rasterizer.
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "gl/context/features.hpp"
#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/lighting_equation.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

constexpr double largest = 4294967296.0, accuracy = 1e-5;

#if SPANGLE_FEATURE_FEEDBACK

/// Results of a vertex: x, y, z in the window, w of the clip coordinates, colour, texture coordinates.
struct Fed {
    std::array<double, 4> window, texture;
};

class Range : public Canvas {
  protected:
    template <class F> static std::vector<Fed> feed(F draw) {
        std::vector<GLfloat> buffer(4096);
        glFeedbackBuffer(4096, GL_4D_COLOR_TEXTURE, buffer.data());
        glRenderMode(GL_FEEDBACK);
        draw();
        const GLint count = glRenderMode(GL_RENDER);
        std::vector<Fed> out;
        for (std::size_t i = 0; i + 13 <= static_cast<std::size_t>(std::max(count, 0)); i += 13) {
            EXPECT_EQ(buffer[i], GL_POINT_TOKEN);
            Fed v{};
            for (std::size_t c = 0; c < 4; ++c) {
                v.window[c] = static_cast<double>(buffer[i + 1 + c]);
                v.texture[c] = static_cast<double>(buffer[i + 9 + c]);
            }
            out.push_back(v);
        }
        return out;
    }
    /// Returns a float of up to `most`, as likely large as small. Numbers of a vector share an exponent:
    /// those of 2^-12 of the largest are exact enough, those of 2^-31 are lost.
    double number(double most) {
        const double size = std::exp2(std::uniform_real_distribution<>(-12, 0)(random_));
        return static_cast<double>(static_cast<float>((random_() & 1) != 0 ? most * size : -most * size));
    }
    Mat4 matrix(double most) {
        Mat4 m{};
        for (double& v : m)
            v = number(most);
        return m;
    }
    /// Returns the error as a part of the sum of the terms.
    static double part(double got, double expected, double terms) {
        return std::fabs(got - expected) / terms;
    }

    std::mt19937 random_{7};
};

/// Positions and matrices are random, but products stay in range and points lie in the view volume.
TEST_F(Range, PositionsInTheWindow) {
    double worst = 0;
    int seen = 0;
    for (int n = 0; n < 20000; ++n) {
        const Vec4 v = {number(largest), number(largest), number(largest), 1};
        Mat4 m = matrix(1);
        for (std::size_t i = 0; i < 4; ++i)
            m[12 + i] = number(largest);
        const Vec4 clip = times(m, v);
        const double w =
            1.01 * std::fmax(std::fabs(clip[0]), std::fmax(std::fabs(clip[1]), std::fabs(clip[2])));
        Mat4 projection = identity(); // the w of this size divides all coordinates
        projection[11] = projection[3] = projection[7] = 0;
        projection[15] = static_cast<double>(static_cast<float>(w));
        m[3] = m[7] = m[11] = 0;
        m[15] = 1;
        glMatrixMode(GL_PROJECTION);
        glLoadMatrixd(projection.data());
        glMatrixMode(GL_MODELVIEW);
        glLoadMatrixd(m.data());
        const auto fed = feed([&v] {
            glBegin(GL_POINTS);
            glVertex4dv(v.data());
            glEnd();
        });
        if (fed.size() != 1)
            continue;
        ++seen;
        for (std::size_t c = 0; c < 2; ++c) {
            double terms = 0;
            for (std::size_t k = 0; k < 4; ++k)
                terms += std::fabs(m[4 * k + c] * v[k]);
            const double got = (fed[0].window[c] - 32) / 32 * projection[15];
            worst = std::fmax(worst, part(got, times(m, v)[c], std::fmax(terms, projection[15])));
        }
    }
    std::printf("%d positions up to 2^32: off by %.2g of their terms at most\n", seen, worst);
    EXPECT_GT(seen, 15000);
    EXPECT_LT(worst, accuracy);
}

TEST_F(Range, TextureCoordinates) {
    double worst = 0;
    glMatrixMode(GL_TEXTURE);
    for (int n = 0; n < 2000; ++n) {
        const Mat4 m = matrix(1000);
        Vec4 v;
        for (double& c : v)
            c = number(largest);
        glLoadMatrixd(m.data());
        const auto fed = feed([&v] {
            glTexCoord4dv(v.data());
            glBegin(GL_POINTS);
            glVertex2f(0, 0);
            glEnd();
        });
        ASSERT_EQ(fed.size(), 1u);
        const Vec4 expected = times(m, v);
        double all = 0; // coordinates share an exponent, so a small one has fewer bits
        for (std::size_t c = 0; c < 4; ++c)
            for (std::size_t k = 0; k < 4; ++k)
                all = std::fmax(all, std::fabs(m[4 * k + c] * v[k]));
        for (std::size_t c = 0; c < 4; ++c)
            worst = std::fmax(worst, part(fed[0].texture[c], expected[c], all));
    }
    std::printf("texture coordinates up to 2^32: off by %.2g\n", worst);
    EXPECT_LT(worst, accuracy);
}

#if SPANGLE_FEATURE_TEXGEN
TEST_F(Range, GeneratedCoordinates) {
    double worst = 0;
    for (int n = 0; n < 2000; ++n) {
        const Vec4 v = {number(largest), number(largest), number(largest), 1};
        const bool eye = n % 2 != 0;
        const double scale = std::fmax(std::fabs(v[0]), std::fmax(std::fabs(v[1]), std::fabs(v[2]))) * 1.01;
        Vec4 plane;
        for (double& c : plane)
            c = number(1000);
        glLoadIdentity();
        glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, eye ? GL_EYE_LINEAR : GL_OBJECT_LINEAR);
        glTexGenfv(GL_S, eye ? GL_EYE_PLANE : GL_OBJECT_PLANE, floats(plane).data());
        glEnable(GL_TEXTURE_GEN_S);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glScaled(1 / scale, 1 / scale, 1 / scale);
        glMatrixMode(GL_MODELVIEW);
        const auto fed = feed([&v] {
            glBegin(GL_POINTS);
            glVertex4dv(v.data());
            glEnd();
        });
        ASSERT_EQ(fed.size(), 1u);
        double expected = 0, terms = 0;
        for (std::size_t c = 0; c < 4; ++c) {
            expected += v[c] * static_cast<double>(static_cast<float>(plane[c]));
            terms += std::fabs(v[c] * plane[c]);
        }
        worst = std::fmax(worst, part(fed[0].texture[0], expected, std::fmax(terms, 1)));
    }
    std::printf("generated coordinates of positions up to 2^32: off by %.2g of their terms\n", worst);
    EXPECT_LT(worst, accuracy);
}
#endif

#if SPANGLE_FEATURE_EVALUATORS
TEST_F(Range, Evaluators) {
    double worst = 0;
    glEnable(GL_MAP1_VERTEX_3);
    glEnable(GL_MAP1_TEXTURE_COORD_4);
    for (int n = 0; n < 2000; ++n) {
        std::array<std::array<GLfloat, 4>, 8> point;
        double most = 0;
        for (auto& p : point)
            for (GLfloat& c : p) {
                c = static_cast<GLfloat>(number(largest));
                most = std::fmax(most, static_cast<double>(std::fabs(c)));
            }
        const GLfloat origin[3] = {};
        const int order = 1 + n % 8;
        glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 1, origin);
        glMap1f(GL_MAP1_TEXTURE_COORD_4, 0, 1, 4, order, point[0].data());
        const double u =
            static_cast<double>(static_cast<float>(std::uniform_real_distribution<>(0, 1)(random_)));
        const auto fed = feed([u] {
            glBegin(GL_POINTS);
            glEvalCoord1d(u);
            glEnd();
        });
        ASSERT_EQ(fed.size(), 1u);
        for (std::size_t c = 0; c < 4; ++c) {
            double expected = 0;
            for (int i = 0; i < order; ++i)
                expected += std::tgamma(order) / (std::tgamma(i + 1) * std::tgamma(order - i)) *
                            std::pow(u, i) * std::pow(1 - u, order - 1 - i) *
                            static_cast<double>(point[static_cast<std::size_t>(i)][c]);
            worst = std::fmax(worst, part(fed[0].texture[c], expected, most));
        }
    }
    std::printf("curves of points up to 2^32: off by %.2g\n", worst);
    EXPECT_LT(worst, accuracy);
}
#endif

#endif

#if SPANGLE_FEATURE_LIGHTING
/// Normals and lights up to 2^32, and colours up to 2^10 before they are clamped.
class LightRange : public Canvas {};

TEST_F(LightRange, NormalsAndLights) {
    std::mt19937 random(9);
    const auto number = [&random](double most) {
        return static_cast<double>(static_cast<float>(std::uniform_real_distribution<>(-most, most)(random)));
    };
    double worst = 0;
    glEnable(GL_LIGHTING);
    for (int n = 0; n < 4000; ++n) {
        const double size = std::exp2(static_cast<double>(n % 33));
        LitVertex v;
        v.normalize = true;
        v.normal = {number(size), number(size), number(size)};
        v.light[0].position = {number(size), number(size), number(size), n % 2 != 0 ? 1.0 : 0.0};
        v.light[0].diffuse = {512, 0.25, 0.5, 1};
        v.material[0].diffuse = {1.0 / 1024, 0.75, 1, 1};
        v.material[0].emission = {-1000, 0, 0, 1};
        v.scene_ambient = {1000, 0, 0, 1};
        v.material[0].ambient = {1, 0, 0, 1};
        specify(v);
        WindowRecorder recorder;
        glNormal3fv(floats(v.normal).data());
        glBegin(GL_POINTS);
        glVertex3f(0, 0, 0);
        glEnd();
        const LitColor expected = equation(v, 0);
        for (int c = 0; c < 3; ++c)
            worst =
                std::fmax(worst, std::fabs(recorder.primitives.at(0).corner[0].color[c] / (255 * 1048576.0) -
                                           expected.primary[static_cast<std::size_t>(c)]));
    }
    std::printf("lit by what is up to 2^32: off by %.2g\n", worst);
    EXPECT_LT(worst, accuracy);
}
#endif

} // namespace
} // namespace spangle::test

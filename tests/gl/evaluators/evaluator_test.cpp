// Compares evaluators with Bernstein sums in double (GL 1.3, 5.1).
#include <bit>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "gl/context/features.hpp"
#include "tests/gl/api/recording_context.hpp"

namespace spangle::test {
namespace {

#if SPANGLE_FEATURE_EVALUATORS

constexpr GLenum targets[] = {GL_MAP1_COLOR_4,         GL_MAP1_INDEX,           GL_MAP1_NORMAL,
                              GL_MAP1_TEXTURE_COORD_1, GL_MAP1_TEXTURE_COORD_2, GL_MAP1_TEXTURE_COORD_3,
                              GL_MAP1_TEXTURE_COORD_4, GL_MAP1_VERTEX_3,        GL_MAP1_VERTEX_4};
constexpr int components[] = {4, 1, 3, 1, 2, 3, 4, 3, 4};
constexpr GLenum to_map2 = GL_MAP2_COLOR_4 - GL_MAP1_COLOR_4;

double number(std::uint32_t bits) {
    return double{std::bit_cast<float>(bits)};
}

double bernstein(int i, int n, double t) {
    double v = 1;
    for (int k = 1; k <= i; ++k)
        v *= static_cast<double>(n - i + k) / k;
    return v * std::pow(t, i) * std::pow(1 - t, n - i);
}

/// The derivative of bernstein() with respect to t.
double bernstein_slope(int i, int n, double t) {
    return n == 0 ? 0 : n * ((i > 0 ? bernstein(i - 1, n - 1, t) : 0) - (i < n ? bernstein(i, n - 1, t) : 0));
}

class Evaluators : public RecordingContext {
  protected:
    Evaluators() : RecordingContext(false) {}

    double real(double low, double high) { return std::uniform_real_distribution<>(low, high)(random); }
    int whole(int low, int high) { return std::uniform_int_distribution<>(low, high)(random); }

    /// Returns the vertex that `draw` gives between Begin and End.
    template <class F> Event vertex_of(F draw) {
        events().clear();
        glBegin(GL_POINTS);
        draw();
        glEnd();
        EXPECT_EQ(events().size(), 3u);
        return events().size() == 3 ? events()[1] : Event{};
    }

    std::mt19937 random{7};
};

/// Returns component `c` of the evaluated target, as the vertex has it.
double seen(const Event& e, int target, int c) {
    if (target == 0)
        return number(e.color[c]);
    if (target == 2)
        return number(e.normal[c]);
    return number(target < 7 ? e.tex_coord[c] : e.position[c]);
}

TEST_F(Evaluators, CurvesAndSurfacesAreBernsteinSums) {
    double worst = 0;
    for (int n = 0; n < 4000; ++n) {
        const int t = whole(0, 8), k = components[t], orders[2] = {whole(1, 8), n % 2 == 0 ? 1 : whole(1, 8)};
        if (t == 1)
            continue; // in RGBA mode vertices have no index
        const int stride_v = k + whole(0, 2), stride_u = stride_v * orders[1] + whole(0, 3);
        const double size = std::ldexp(1, whole(-20, 20));
        std::vector<GLfloat> points(static_cast<std::size_t>(stride_u * 8 + stride_v * 8));
        for (GLfloat& p : points)
            p = static_cast<GLfloat>(real(-size, size));
        const auto from = static_cast<GLfloat>(real(-5, 5)), to = static_cast<GLfloat>(real(-5, 5));
        const auto from_v = static_cast<GLfloat>(real(-5, 5)), to_v = static_cast<GLfloat>(real(-5, 5));
        const double place = n % 5 == 0 ? 0 : n % 5 == 1 ? 1 : real(0, 1), place_v = real(0, 1);
        const auto u = n % 5 == 0   ? from
                       : n % 5 == 1 ? to
                                    : static_cast<GLfloat>(from + (double{to} - from) * place);
        const auto v = static_cast<GLfloat>(from_v + (double{to_v} - from_v) * place_v);
        const GLfloat vertex[3] = {};
        const GLenum vertex_map = t == 7 ? GL_MAP1_VERTEX_4 : GL_MAP1_VERTEX_3;
        Event e;
        if (n % 2 == 0) {
            glMap1f(vertex_map, 0, 1, 4, 1, std::vector<GLfloat>(4).data());
            glMap1f(targets[t], from, to, stride_u, orders[0], points.data());
            glEnable(vertex_map);
            glEnable(targets[t]);
            if (t == 7)
                glDisable(vertex_map);
            e = vertex_of([&] { glEvalCoord1f(u); });
            glDisable(vertex_map);
            glDisable(targets[t]);
        } else {
            if (t < 7) {
                glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 1, 0, 1, 3, 1, vertex);
                glEnable(GL_MAP2_VERTEX_3);
            }
            glMap2f(targets[t] + to_map2, from, to, stride_u, orders[0], from_v, to_v, stride_v, orders[1],
                    points.data());
            glEnable(targets[t] + to_map2);
            e = vertex_of([&] { glEvalCoord2f(u, v); });
            glDisable(GL_MAP2_VERTEX_3);
            glDisable(targets[t] + to_map2);
        }
        ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        const double at = (double{u} - from) / (double{to} - from),
                     at_v = n % 2 == 0 ? 0 : (double{v} - from_v) / (double{to_v} - from_v);
        for (int c = 0; c < k; ++c) {
            double sum = 0;
            for (int i = 0; i < orders[0]; ++i)
                for (int j = 0; j < orders[1]; ++j)
                    sum += bernstein(i, orders[0] - 1, at) * bernstein(j, orders[1] - 1, at_v) *
                           points[static_cast<std::size_t>(i * stride_u + j * stride_v + c)];
            worst = std::max(worst, std::fabs(seen(e, t, c) - sum) / size);
            if (n % 2 == 0 && n % 5 < 2) { // an end of a curve is its control point
                const int end = n % 5 == 0 ? 0 : orders[0] - 1;
                EXPECT_EQ(seen(e, t, c), double{points[static_cast<std::size_t>(end * stride_u + c)]});
            }
        }
        EXPECT_LE(worst, 0x1p-23) << "target " << t << ", orders " << orders[0] << ' ' << orders[1];
    }
    RecordProperty("worst_of_largest_control_point", std::to_string(worst));
}

TEST_F(Evaluators, PlacesOutsideOfTheDomainAreExtrapolated) {
    const GLfloat points[] = {0, 0, 0, 1, 2, 3};
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, points);
    glEnable(GL_MAP1_VERTEX_3);
    const Event e = vertex_of([] { glEvalCoord1f(-2); });
    EXPECT_EQ(number(e.position[1]), -4);
    EXPECT_EQ(number(e.position[3]), 1);
}

TEST_F(Evaluators, AutoNormalIsTheCrossProductOfTheDerivatives) {
    glEnable(GL_AUTO_NORMAL);
    double worst = 0;
    for (int n = 0; n < 1000; ++n) {
        const bool four = n % 2 != 0;
        const int k = four ? 4 : 3, orders[2] = {whole(2, 8), whole(2, 8)};
        std::vector<GLfloat> points;
        for (int i = 0; i < orders[0]; ++i) // a bent sheet, far from degenerate
            for (int j = 0; j < orders[1]; ++j) {
                const double w = four ? real(0.5, 2) : 1;
                for (const double p : {i + real(-0.2, 0.2), j + real(-0.2, 0.2), real(-1, 1)})
                    points.push_back(static_cast<GLfloat>(p * w));
                if (four)
                    points.push_back(static_cast<GLfloat>(w));
            }
        const GLenum target = four ? GL_MAP2_VERTEX_4 : GL_MAP2_VERTEX_3;
        const bool turned[2] = {n % 3 == 0, n % 5 < 2}; // whether the domains of u and v run backwards
        glMap2f(target, turned[0] ? 1 : 0, turned[0] ? 0 : 1, k * orders[1], orders[0], turned[1] ? 1 : 0,
                turned[1] ? 0 : 1, k, orders[1], points.data());
        glEnable(target);
        const auto u = static_cast<GLfloat>(real(0, 1)), v = static_cast<GLfloat>(real(0, 1));
        const Event e = vertex_of([&] { glEvalCoord2f(u, v); });
        glDisable(target);
        double p[4] = {0, 0, 0, 0}, pu[4] = {}, pv[4] = {};
        const double at = turned[0] ? 1 - double{u} : double{u}, over = turned[1] ? 1 - double{v} : double{v};
        for (int i = 0; i < orders[0]; ++i)
            for (int j = 0; j < orders[1]; ++j)
                for (int c = 0; c < k; ++c) {
                    const double r = points[static_cast<std::size_t>((i * orders[1] + j) * k + c)];
                    const int a = orders[0] - 1, b = orders[1] - 1;
                    p[c] += r * bernstein(i, a, at) * bernstein(j, b, over);
                    pu[c] += r * bernstein_slope(i, a, at) * bernstein(j, b, over) * (turned[0] ? -1 : 1);
                    pv[c] += r * bernstein(i, a, at) * bernstein_slope(j, b, over) * (turned[1] ? -1 : 1);
                }
        double q[2][3];
        for (int c = 0; c < 3; ++c) {
            q[0][c] = four ? (pu[c] * p[3] - p[c] * pu[3]) / (p[3] * p[3]) : pu[c];
            q[1][c] = four ? (pv[c] * p[3] - p[c] * pv[3]) / (p[3] * p[3]) : pv[c];
        }
        double m[3], length = 0;
        for (int c = 0; c < 3; ++c) {
            const int y = (c + 1) % 3, z = (c + 2) % 3;
            m[c] = q[0][y] * q[1][z] - q[0][z] * q[1][y];
            length += m[c] * m[c];
        }
        for (int c = 0; c < 3; ++c)
            worst = std::max(worst, std::fabs(number(e.normal[c]) - m[c] / std::sqrt(length)));
    }
    EXPECT_LE(worst, 0x1p-22);
    glDisable(GL_AUTO_NORMAL);
}

/// EvalCoord gives values as Color, Normal and others do, but does not change the current values.
TEST_F(Evaluators, CurrentValuesStay) {
    const GLfloat color[] = {0.25f, 0.5f, 0.75f, 1}, normal[] = {1, 2, 3}, tex[] = {5, 6}, at[] = {7, 8, 9};
    glMap1f(GL_MAP1_COLOR_4, 0, 1, 4, 1, color);
    glMap1f(GL_MAP1_NORMAL, 0, 1, 3, 1, normal);
    glMap1f(GL_MAP1_TEXTURE_COORD_2, 0, 1, 2, 1, tex);
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 1, at);
    for (GLenum cap : {GL_MAP1_COLOR_4, GL_MAP1_NORMAL, GL_MAP1_TEXTURE_COORD_2, GL_MAP1_VERTEX_3})
        glEnable(cap);
    glColor4f(0, 1, 0, 1);
    glTexCoord4f(1, 2, 3, 4);
    const auto before = snapshot();
    const Event e = vertex_of([] { glEvalCoord1f(0.5f); });
    EXPECT_EQ(snapshot(), before);
    for (int c = 0; c < 4; ++c)
        EXPECT_EQ(number(e.color[c]), double{color[c]});
    for (int c = 0; c < 3; ++c)
        EXPECT_EQ(number(e.normal[c]), double{normal[c]});
    const double expected_tex[] = {5, 6, 0, 1};
    for (int c = 0; c < 4; ++c)
        EXPECT_EQ(number(e.tex_coord[c]), expected_tex[c]);
    EXPECT_EQ(number(e.position[2]), 9);
    glEvalCoord1f(0.5f); // outside of Begin and End a vertex has no effect
    EXPECT_EQ(snapshot(), before);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(Evaluators, TheMapOfMostCoordinatesWins) {
    const GLfloat three[] = {1, 2, 3}, four[] = {4, 5, 6, 7}, one[] = {8};
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 1, three);
    glMap1f(GL_MAP1_VERTEX_4, 0, 1, 4, 1, four);
    glMap1f(GL_MAP1_TEXTURE_COORD_3, 0, 1, 3, 1, three);
    glMap1f(GL_MAP1_TEXTURE_COORD_1, 0, 1, 1, 1, one);
    for (GLenum cap : {GL_MAP1_VERTEX_3, GL_MAP1_VERTEX_4, GL_MAP1_TEXTURE_COORD_1, GL_MAP1_TEXTURE_COORD_3})
        glEnable(cap);
    const Event e = vertex_of([] { glEvalCoord1f(0); });
    EXPECT_EQ(number(e.position[3]), 7);
    EXPECT_EQ(number(e.tex_coord[2]), 3);
}

TEST_F(Evaluators, WithoutAVertexMapNothingIsDrawn) {
    glEnable(GL_MAP1_COLOR_4);
    glEnable(GL_MAP2_VERTEX_3);
    glBegin(GL_POINTS);
    glEvalCoord1f(0.5f);
    glEvalPoint1(0);
    glEnd();
    EXPECT_EQ(events().size(), 2u);
}

TEST_F(Evaluators, MapsReplacedAndInitial) {
    GLfloat v[32] = {};
    GLint order[2] = {};
    const double initial[9][4] = {{1, 1, 1, 1}, {1},          {0, 0, 1}, {0},         {0, 0},
                                  {0, 0, 0},    {0, 0, 0, 1}, {0, 0, 0}, {0, 0, 0, 1}};
    for (int t = 0; t < 9; ++t)
        for (const GLenum target : {targets[t], targets[t] + to_map2}) {
            const bool two = target >= GL_MAP2_COLOR_4;
            std::fill(std::begin(v), std::end(v), -77.0f);
            glGetMapfv(target, GL_COEFF, v);
            for (int c = 0; c < components[t]; ++c)
                EXPECT_EQ(double{v[c]}, initial[t][c]) << std::hex << target;
            EXPECT_EQ(v[components[t]], -77);
            order[1] = -77;
            glGetMapiv(target, GL_ORDER, order);
            EXPECT_EQ(order[0], 1);
            EXPECT_EQ(order[1], two ? 1 : -77);
            glGetMapfv(target, GL_DOMAIN, v);
            EXPECT_EQ(v[0], 0);
            EXPECT_EQ(v[1], 1);
            EXPECT_EQ(v[3], two ? 1 : components[t] > 3 ? v[3] : -77);
        }
    GLdouble points[2][3][5];
    for (int i = 0; i < 30; ++i)
        points[i / 15][i / 5 % 3][i % 5] = i + 0.25;
    glMap2d(GL_MAP2_VERTEX_4, -1, 2.5, 15, 2, 3, 4, 5, 3, &points[0][0][0]);
    points[1][2][3] = 99; // the control points were copied
    GLdouble d[24];
    glGetMapdv(GL_MAP2_VERTEX_4, GL_COEFF, d);
    for (int i = 0; i < 24; ++i)
        EXPECT_EQ(d[i], i / 12 * 15 + i / 4 % 3 * 5 + i % 4 + 0.25);
    glGetMapdv(GL_MAP2_VERTEX_4, GL_DOMAIN, d);
    EXPECT_EQ(d[0], -1);
    EXPECT_EQ(d[1], 2.5);
    EXPECT_EQ(d[2], 3);
    EXPECT_EQ(d[3], 4);
    GLint n[24];
    glGetMapiv(GL_MAP2_VERTEX_4, GL_COEFF, n);
    EXPECT_EQ(n[1], 1);
    glGetMapiv(GL_MAP2_VERTEX_4, GL_DOMAIN, n);
    EXPECT_EQ(n[1], 3) << "rounded";
#if SPANGLE_FEATURE_FIXED_POINT
    const GLfixed fixed[] = {1 << 16, 3 << 15, -(1 << 16)};
    glMap1xOES(GL_MAP1_NORMAL, 0, 1 << 15, 3, 1, fixed);
    GLfixed x[3];
    glGetMapxvOES(GL_MAP1_NORMAL, GL_COEFF, x);
    EXPECT_EQ(x[1], fixed[1]);
    glGetMapfv(GL_MAP1_NORMAL, GL_DOMAIN, v);
    EXPECT_EQ(v[1], 0.5f);
#endif
}

TEST_F(Evaluators, WrongMapsAreRefused) {
    const GLfloat p[64] = {};
    const auto refused = [&](GLenum code, auto call) {
        const auto before = snapshot();
        call();
        EXPECT_EQ(glGetError(), code);
        EXPECT_EQ(snapshot(), before);
    };
    for (int t = 0; t < 9; ++t) {
        refused(GL_INVALID_VALUE, [&] { glMap1f(targets[t], 0, 1, components[t] - 1, 1, p); });
        refused(GL_INVALID_VALUE,
                [&] { glMap2f(targets[t] + to_map2, 0, 1, 9, 1, 0, 1, components[t] - 1, 1, p); });
        refused(GL_INVALID_VALUE,
                [&] { glMap2f(targets[t] + to_map2, 0, 1, components[t] - 1, 1, 0, 1, 9, 1, p); });
        refused(GL_INVALID_ENUM, [&] { glMap1f(targets[t] + to_map2, 0, 1, 4, 1, p); });
        refused(GL_INVALID_ENUM, [&] { glMap2f(targets[t], 0, 1, 4, 1, 0, 1, 4, 1, p); });
    }
    refused(GL_INVALID_VALUE, [&] { glMap1f(GL_MAP1_NORMAL, 2, 2, 3, 1, p); });
    refused(GL_INVALID_VALUE, [&] { glMap2f(GL_MAP2_NORMAL, 0, 1, 3, 1, 2, 2, 3, 1, p); });
    refused(GL_INVALID_VALUE, [&] { glMap1f(GL_MAP1_NORMAL, 0, 1, 3, 9, p); });
    refused(GL_INVALID_VALUE, [&] { glMap1f(GL_MAP1_NORMAL, 0, 1, 3, 0, p); });
    refused(GL_INVALID_VALUE, [&] { glMap1f(GL_MAP1_NORMAL, 0, 1, 3, 1, nullptr); });
    refused(GL_INVALID_ENUM, [&] { glEvalMesh1(GL_FILL, 0, 1); });
    refused(GL_INVALID_VALUE, [&] { glMapGrid1f(0, 0, 1); });
    refused(GL_INVALID_VALUE, [&] { glMapGrid2f(1, 0, 1, -1, 0, 1); });
    GLfloat v[4];
    refused(GL_INVALID_ENUM, [&] { glGetMapfv(GL_MAP1_NORMAL, GL_COEFF + 3, v); });
    refused(GL_INVALID_ENUM, [&] { glGetMapfv(GL_MAP1_VERTEX_4 + 1, GL_COEFF, v); });
    glActiveTexture(GL_TEXTURE1);
    const GLenum code = gl::texture_units > 1 ? GL_INVALID_OPERATION : GL_INVALID_ENUM;
    glGetError();
    if (code == GL_INVALID_OPERATION)
        refused(code, [&] { glMap1f(GL_MAP1_NORMAL, 0, 1, 3, 1, p); });
}

TEST_F(Evaluators, NoMemoryKeepsTheMap) {
    const GLfloat old[] = {1, 2, 3}, next[24] = {};
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 1, old);
    std::vector<void*> taken;
    for (std::size_t bytes = arena_bytes; bytes >= 8; bytes /= 2)
        for (void* block = arena.allocate(bytes); block != nullptr; block = arena.allocate(bytes))
            taken.push_back(block);
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 8, next);
    EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
    GLfloat v[3] = {};
    glGetMapfv(GL_MAP1_VERTEX_3, GL_COEFF, v);
    EXPECT_EQ(v[2], 3);
    for (void* block : taken)
        arena.free(block);
}

// --- Grids and meshes

class Meshes : public Evaluators {
  protected:
    void SetUp() override {
        GLfloat points[4][4][3];
        for (int i = 0; i < 48; ++i)
            (&points[0][0][0])[i] = static_cast<GLfloat>(i * i % 17) / 3;
        glMap1f(GL_MAP1_VERTEX_3, 0.1f, 0.7f, 3, 4, &points[0][0][0]);
        glMap2f(GL_MAP2_VERTEX_3, 0.1f, 0.7f, 12, 4, -0.3f, 0.9f, 3, 4, &points[0][0][0]);
        glEnable(GL_MAP1_VERTEX_3);
        glEnable(GL_MAP2_VERTEX_3);
        glMapGrid1f(7, 0.1f, 0.7f);
        glMapGrid2f(7, 0.1f, 0.7f, 3, -0.3f, 0.9f);
    }
    static std::vector<Event> drawn(const std::function<void()>& draw) {
        events().clear();
        draw();
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        return events();
    }
};

TEST_F(Meshes, AreLoopsOverTheGrid) {
    const auto strip = [](GLenum mode, int first, int last, auto point) {
        glBegin(mode);
        for (int i = first; i <= last; ++i)
            point(i);
        glEnd();
    };
    for (const auto& [mode, primitive] : {std::pair{GL_POINT, GL_POINTS}, {GL_LINE, GL_LINE_STRIP}})
        EXPECT_EQ(drawn([m = mode] { glEvalMesh1(m, 0, 7); }),
                  drawn([&, p = primitive] { strip(p, 0, 7, [](int i) { glEvalPoint1(i); }); }));
    EXPECT_EQ(drawn([] { glEvalMesh2(GL_POINT, 1, 6, 0, 3); }), drawn([] {
                  glBegin(GL_POINTS);
                  for (int j = 0; j <= 3; ++j)
                      for (int i = 1; i <= 6; ++i)
                          glEvalPoint2(i, j);
                  glEnd();
              }));
    EXPECT_EQ(drawn([] { glEvalMesh2(GL_FILL, 0, 7, 0, 3); }), drawn([&] {
                  for (int j = 0; j < 3; ++j)
                      strip(GL_QUAD_STRIP, 0, 7, [j](int i) {
                          glEvalPoint2(i, j);
                          glEvalPoint2(i, j + 1);
                      });
              }));
    EXPECT_EQ(drawn([] { glEvalMesh2(GL_LINE, 0, 7, 0, 3); }), drawn([&] {
                  for (int j = 0; j <= 3; ++j)
                      strip(GL_LINE_STRIP, 0, 7, [j](int i) { glEvalPoint2(i, j); });
                  for (int i = 0; i <= 7; ++i)
                      strip(GL_LINE_STRIP, 0, 3, [i](int j) { glEvalPoint2(i, j); });
              }));
}

/// Neighbouring patches meet: the ends of a grid are the ends of the domain, to the bit.
TEST_F(Meshes, EndsOfTheGridAreExact) {
    EXPECT_EQ(drawn([] { glEvalMesh1(GL_POINT, 0, 0); }), drawn([] {
                  glBegin(GL_POINTS);
                  glEvalCoord1f(0.1f);
                  glEnd();
              }));
    EXPECT_EQ(drawn([] { glEvalMesh2(GL_POINT, 7, 7, 3, 3); }), drawn([] {
                  glBegin(GL_POINTS);
                  glEvalCoord2f(0.7f, 0.9f);
                  glEnd();
              }));
    for (GLint n = 1; n < 200; ++n) { // the domain is much longer than its upper end, 0.7
        glMapGrid1f(n, -1e6f, 0.7f);
        const auto end = drawn([n] { glEvalMesh1(GL_POINT, n, n); });
        EXPECT_EQ(end, drawn([] {
                      glBegin(GL_POINTS);
                      glEvalCoord1f(0.7f);
                      glEnd();
                  }));
    }
}

TEST_F(Meshes, PointsBetweenAreWhereTheGridSays) {
    const GLfloat line[] = {0, 0, 0, 1, 0, 0};
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, line);
    glMapGrid1d(10, -1, 3);
    const auto all = drawn([] { glEvalMesh1(GL_POINT, -2, 12); });
    ASSERT_EQ(all.size(), 17u);
    for (int i = -2; i <= 12; ++i)
        EXPECT_NEAR(number(all[static_cast<std::size_t>(i + 3)].position[0]), -1 + i * 0.4, 3e-7) << i;
}

TEST_F(Meshes, EmptyOnesDrawNoVertex) {
    EXPECT_EQ(drawn([] { glEvalMesh1(GL_LINE, 3, 2); }).size(), 2u);
    EXPECT_EQ(drawn([] { glEvalMesh2(GL_FILL, 0, 7, 2, 2); }).size(), 0u);
    EXPECT_EQ(drawn([] { glEvalMesh1(GL_POINT, INT32_MAX - 1, INT32_MAX); }).size(), 4u);
}

#if SPANGLE_FEATURE_LISTS
TEST_F(Meshes, MapsAreCopiedIntoLists) {
    GLfloat points[3][2][4] = {{{1, 2, 3}, {4, 5, 6}}, {{7, 8, 9}, {10, 11, 12}}, {{3, 1, 4}, {1, 5, 9}}};
    const auto draw = [] {
        glEvalMesh1(GL_LINE, 0, 7);
        glEvalMesh2(GL_FILL, 0, 7, 0, 3);
    };
    const auto map = [&points] {
        glMap1f(GL_MAP1_VERTEX_3, 0, 1, 4, 4, &points[0][0][0]);
        glMap2f(GL_MAP2_VERTEX_3, 0, 1, 8, 3, 0, 1, 4, 2, &points[0][0][0]);
    };
    map();
    const auto expected = drawn(draw);
    SetUp();
    glNewList(1, GL_COMPILE);
    map();
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 2, 4, &points[0][0][0]);
    draw();
    glEndList();
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << "errors come at execution";
    std::memset(points, 0, sizeof points);
    events().clear();
    glCallList(1);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    EXPECT_EQ(events(), expected);
}
#endif

#if SPANGLE_FEATURE_LIGHTING
TEST_F(Evaluators, ATrackedMaterialHasTheColorOfItsVertexOnly) {
    const GLfloat color[] = {0.25f, 0.5f, 0.75f, 1};
    glMap1f(GL_MAP1_COLOR_4, 0, 1, 4, 1, color);
    glEnable(GL_MAP1_COLOR_4);
    glEnable(GL_MAP1_VERTEX_3);
    glColorMaterial(GL_FRONT, GL_DIFFUSE);
    glEnable(GL_COLOR_MATERIAL);
    glColor3f(1, 0, 0);
    const Event e = vertex_of([] { glEvalCoord1f(0); });
    EXPECT_EQ(number(e.color[1]), 0.5);
    GLfloat diffuse[4];
    glGetMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse);
    EXPECT_EQ(diffuse[0], 1);
    EXPECT_EQ(diffuse[2], 0);
}
#endif

#endif

} // namespace
} // namespace spangle::test

// Rows C04, C06 to C10: colours of vertices against the equation of the specification.
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "raster/surface/units.hpp"
#include "tests/gl_vertex/canvas.hpp"
#include "tests/gl_vertex/lighting_equation.hpp"
#include "tests/gl_vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

constexpr double units = raster::color_one;

class Lighting : public Canvas {
  protected:
    void SetUp() override {
        Canvas::SetUp();
        glEnable(GL_LIGHTING);
        glMatrixMode(GL_PROJECTION);
        glOrtho(-200, 200, -200, 200, -200, 200);
        glMatrixMode(GL_MODELVIEW);
    }

    static raster::FixedVertex lit_point(const LitVertex& v) {
        specify(v);
        WindowRecorder recorder;
        glNormal3fv(floats(v.normal).data());
        glBegin(GL_POINTS);
        glVertex4fv(floats(v.position).data());
        glEnd();
        EXPECT_EQ(recorder.primitives.size(), 1u);
        return recorder.primitives.empty() ? raster::FixedVertex{} : recorder.primitives[0].corner[0];
    }

    /// Largest difference of a component, in 255ths.
    static double difference(const raster::FixedVertex& v, const LitColor& expected) {
        double worst = 0;
        for (std::size_t c = 0; c < 4; ++c)
            worst = std::fmax(worst, std::fabs(v.color[c] / units - expected.primary[c]));
        for (std::size_t c = 0; c < 3; ++c)
            worst = std::fmax(worst, std::fabs(v.secondary[c] / units - expected.secondary[c]));
        return worst * 255;
    }

    static Vec3 red_of(const raster::FixedVertex& v) {
        return {v.color[0] / units, v.color[1] / units, v.color[2] / units};
    }
};

Mat4 translation(double x, double y, double z) {
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1};
}
Mat4 scaling(double x, double y, double z) {
    return {x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1};
}
/// A quarter turn about x: y to z, z to -y.
Mat4 quarter_about_x() {
    return {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1};
}

/// Only this light's diffuse colour counts, on a white diffuse material.
void only_diffuse(LitVertex& v) {
    v.scene_ambient = {0, 0, 0, 1};
    v.material[0].diffuse = {1, 1, 1, 1};
}
void only_specular(LitVertex& v, double shininess) {
    only_diffuse(v);
    v.material[0].diffuse = {0, 0, 0, 1};
    v.material[0].specular = {1, 0.5, 0.25, 1};
    v.material[0].shininess = shininess;
}
/// LIGHT0 at the eye, looking down -z; the vertex at cosine 0.8 from its axis, 5 away; lit ambiently only.
void spot(LitVertex& v, double cutoff, double exponent) {
    only_diffuse(v);
    v.material[0].ambient = {1, 1, 1, 1};
    v.material[0].diffuse = {0, 0, 0, 1};
    v.light[0].ambient = {1, 1, 1, 1};
    v.light[0].position = {0, 0, 0, 1};
    v.light[0].spot_cutoff = cutoff;
    v.light[0].spot_exponent = exponent;
    v.position = {3, 0, -4, 1};
}

struct Row {
    const char* name;
    Vec3 expected; ///< worked out by hand
    std::function<void(LitVertex&)> change;
};

const Row table[] = {
    {"defaults: 0.2 0.2 + 0.8", {0.84, 0.84, 0.84}, [](LitVertex&) {}},
    {"no light: the scene's ambient light", {0.04, 0.04, 0.04}, [](LitVertex& v) { v.light[0].on = false; }},
    {"LIGHT1 is black by default", {0.84, 0.84, 0.84}, [](LitVertex& v) { v.light[1].on = true; }},
    {"scene ambient",
     {0.5, 0.25, 0},
     [](LitVertex& v) {
         v.light[0].on = false;
         v.scene_ambient = {1, 0.5, 0, 0};
         v.material[0].ambient = {0.5, 0.5, 0.5, 0};
     }},
    {"emission",
     {0.25, 0.5, 0.75},
     [](LitVertex& v) {
         v.light[0].on = false;
         v.scene_ambient = {0, 0, 0, 1};
         v.material[0].emission = {0.25, 0.5, 0.75, 0};
     }},
    {"a light's ambient reaches what faces away",
     {0.5, 0.25, 0.125},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].ambient = {1, 0.5, 0.25, 1};
         v.material[0].ambient = {0.5, 0.5, 0.5, 1};
         v.normal = {0, 0, -1};
     }},
    {"diffuse at 3-4-5",
     {0.8, 0.4, 0.2},
     [](LitVertex& v) {
         only_diffuse(v);
         v.material[0].diffuse = {1, 0.5, 0.25, 1};
         v.normal = {0.6f, 0, 0.8f};
     }},
    {"diffuse from behind",
     {0, 0, 0},
     [](LitVertex& v) {
         only_diffuse(v);
         v.normal = {0.6f, 0, -0.8f};
     }},
    {"a direction need not be a unit vector",
     {0.8, 0.8, 0.8},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].position = {30, 0, 40, 0};
     }},
    {"specular, exponent 2: 0.8^2",
     {0.64, 0.32, 0.16},
     [](LitVertex& v) {
         only_specular(v, 2);
         v.normal = {0.6f, 0, 0.8f};
     }},
    {"specular, exponent 0: 1 wherever light falls",
     {1, 0.5, 0.25},
     [](LitVertex& v) {
         only_specular(v, 0);
         v.normal = {0.96f, 0, 0.28f};
     }},
    {"specular, exponent 128: 0.96^128",
     {0.0053792, 0.0026896, 0.0013448},
     [](LitVertex& v) {
         only_specular(v, 128);
         v.normal = {0.28f, 0, 0.96f};
     }},
    {"no highlight where no light falls (f = 0)",
     {0, 0, 0},
     [](LitVertex& v) {
         only_specular(v, 1);
         v.light[0].position = {1, 0, -0.5, 0};
     }},
    {"local viewer: n.h = 1.8 / sqrt(3.6)",
     {0.9, 0.45, 0.225},
     [](LitVertex& v) {
         only_specular(v, 2);
         v.local_viewer = true;
         v.position = {3, 0, -4, 1};
     }},
    {"viewer at infinity",
     {1, 0.5, 0.25},
     [](LitVertex& v) {
         only_specular(v, 2);
         v.position = {3, 0, -4, 1};
     }},
    {"positional light",
     {0.8, 0.8, 0.8},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].position = {3, 0, 0, 1};
         v.position = {0, 0, -4, 1};
     }},
    {"positions are divided by w",
     {0.8, 0.8, 0.8},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].position = {6, 0, 0, 2};
         v.position = {0, 0, -16, 4};
     }},
    {"constant attenuation",
     {0.5, 0.5, 0.5},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].position = {0, 0, 5, 1};
         v.light[0].constant = 2;
     }},
    {"linear attenuation: 1 / (5 / 4)",
     {0.8, 0.8, 0.8},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].position = {0, 0, 5, 1};
         v.light[0].constant = 0;
         v.light[0].linear = 0.25;
     }},
    {"quadratic attenuation: 1 / (25 / 8)",
     {0.32, 0.32, 0.32},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].position = {0, 0, 5, 1};
         v.light[0].constant = 0;
         v.light[0].quadratic = 0.125;
     }},
    {"all three, and the ambient light, too: 1 / (0.5 + 1 + 1)",
     {0.4, 0.4, 0.4},
     [](LitVertex& v) {
         spot(v, 180, 0);
         v.light[0].constant = 0.5;
         v.light[0].linear = 0.2f;
         v.light[0].quadratic = 0.04f;
     }},
    {"a direction has no attenuation",
     {1, 1, 1},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].constant = 5;
     }},
    {"inside of a spot's cone", {1, 1, 1}, [](LitVertex& v) { spot(v, 37, 0); }},
    {"outside", {0, 0, 0}, [](LitVertex& v) { spot(v, 36.8f, 0); }},
    {"spot exponent 1", {0.8, 0.8, 0.8}, [](LitVertex& v) { spot(v, 60, 1); }},
    {"spot exponent 128 at 0.96",
     {0.0053792, 0.0053792, 0.0053792},
     [](LitVertex& v) {
         spot(v, 90, 128);
         v.position = {7, 0, -24, 1};
     }},
    {"cutoff 180 is no spot",
     {1, 1, 1},
     [](LitVertex& v) {
         spot(v, 180, 128);
         v.position = {3, 0, 4, 1};
     }},
    {"cutoff 90 lights half of the space",
     {1, 1, 1},
     [](LitVertex& v) {
         spot(v, 90, 0);
         v.position = {24, 0, -0.5, 1};
     }},
    {"and not the other",
     {0, 0, 0},
     [](LitVertex& v) {
         spot(v, 90, 0);
         v.position = {24, 0, 0.5, 1};
     }},
    {"cutoff 0 lights its axis",
     {1, 1, 1},
     [](LitVertex& v) {
         spot(v, 0, 3);
         v.position = {0, 0, -7, 1};
     }},
    {"a directional spot shines",
     {1, 1, 1},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].spot_cutoff = 10;
     }},
    {"or looks elsewhere",
     {0, 0, 0},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].spot_cutoff = 10;
         v.light[0].spot_direction = {1, 0, -1};
     }},
    {"spot and attenuation multiply",
     {0.4, 0.4, 0.4},
     [](LitVertex& v) {
         spot(v, 60, 1);
         v.light[0].constant = 2;
     }},
    {"eight lights",
     {0.5, 0.25, 0.125},
     [](LitVertex& v) {
         only_diffuse(v);
         for (LightSource& l : v.light) {
             l.on = true;
             l.diffuse = {0.0625, 0.03125, 0.015625, 1};
         }
     }},
    {"the eighth light",
     {0, 1, 0},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].on = false;
         v.light[7].on = true;
         v.light[7].diffuse = {0, 1, 0, 1};
     }},
    {"NORMALIZE",
     {0.8, 0.8, 0.8},
     [](LitVertex& v) {
         only_diffuse(v);
         v.normalize = true;
         v.normal = {30, 0, 40};
         v.modelview = scaling(7, 7, 7);
     }},
    {"without it lengths count",
     {0.25, 0.25, 0.25},
     [](LitVertex& v) {
         only_diffuse(v);
         v.modelview = scaling(4, 4, 4);
     }},
    {"RESCALE_NORMAL",
     {0.8, 0.8, 0.8},
     [](LitVertex& v) {
         only_diffuse(v);
         v.rescale = true;
         v.normal = {0.6f, 0, 0.8f};
         v.modelview = scaling(4, 4, 4);
     }},
    {"RESCALE_NORMAL does not make unit vectors",
     {0.25, 0.25, 0.25},
     [](LitVertex& v) {
         only_diffuse(v);
         v.rescale = true;
         v.normal = {0, 0, 0.25};
         v.modelview = scaling(0.125, 0.125, 0.125);
     }},
    {"normals go by the inverse transpose: (3, 0, 4 / 0.5)",
     {0.936329, 0.936329, 0.936329},
     [](LitVertex& v) {
         only_diffuse(v);
         v.normalize = true;
         v.normal = {3, 0, 4};
         v.modelview = scaling(1, 1, 0.5);
     }},
    {"a light stays where the modelview put it",
     {0.8, 0.8, 0.8},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].position = {0, 0, 0, 1};
         v.light_matrix = translation(3, 0, 4);
     }},
    {"a direction does not move",
     {1, 1, 1},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light_matrix = translation(3, 0, -40);
     }},
    {"but turns",
     {0, 0, 0},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light_matrix = quarter_about_x();
     }},
    {"so does the spot's direction",
     {1, 1, 1},
     [](LitVertex& v) {
         spot(v, 20, 0);
         v.light_matrix = quarter_about_x();
         v.position = {0, 5, 0, 1};
     }},
    {"moving the vertex does not move the light",
     {0.8, 0.8, 0.8},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].position = {3, 0, 0, 1};
         v.modelview = translation(0, 0, -4);
     }},
    {"light can be taken away",
     {0.5, 0.5, 0.5},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[1] = v.light[0];
         v.light[1].diffuse = {-0.5, -0.5, -0.5, 1};
     }},
    {"the sum is clamped, not its terms",
     {1, 0.75, 0},
     [](LitVertex& v) {
         only_diffuse(v);
         v.material[0].emission = {1, -0.25, -3, 1};
     }},
};

TEST_F(Lighting, TheTable) {
    for (const Row& row : table) {
        LitVertex v;
        row.change(v);
        const LitColor expected = equation(v, 0);
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_NEAR(expected.primary[c], row.expected[c], 1e-6) << row.name;
        const raster::FixedVertex got = lit_point(v);
        EXPECT_LT(difference(got, expected), 0.001)
            << row.name << ": " << red_of(got)[0] << ' ' << red_of(got)[1] << ' ' << red_of(got)[2];
    }
}

TEST_F(Lighting, AlphaIsThatOfTheDiffuseMaterial) {
    LitVertex v;
    v.material[0].diffuse[3] = 0.25;
    v.material[0].ambient[3] = v.light[0].diffuse[3] = v.scene_ambient[3] = 0.5;
    EXPECT_NEAR(lit_point(v).color[3] / units, 0.25, 1e-6);
}

TEST_F(Lighting, SeparateSpecularIsTheSecondaryColor) {
    LitVertex v;
    only_specular(v, 2);
    v.material[0].diffuse = {0.5, 0.5, 0.5, 1};
    v.normal = {0.6f, 0, 0.8f};
    v.separate_specular = true;
    const raster::FixedVertex got = lit_point(v);
    const double specular[3] = {0.64, 0.32, 0.16};
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(got.color[c] / units, 0.4, 1e-6);
        EXPECT_NEAR(got.secondary[c] / units, specular[c], 1e-6);
    }
    v.separate_specular = false;
    EXPECT_EQ(lit_point(v).secondary[0], 0u);
}

/// Every term at once. Where the equation jumps (the edge of a cone, the terminator of a highlight) rounding
/// may fall on either side: within 2^-20 of it nothing is compared.
TEST_F(Lighting, RandomScenes) {
    std::mt19937 random(3);
    const auto real = [&random](double low, double high) {
        return static_cast<double>(static_cast<float>(std::uniform_real_distribution<>(low, high)(random)));
    };
    const auto flip = [&random] { return (random() & 1) != 0; };
    const auto color = [&] { return Vec4{real(0, 1), real(0, 1), real(0, 1), real(0, 1)}; };
    const auto direction = [&] { return Vec3{real(-1, 1), real(-1, 1), real(-1, 1)}; };
    const auto turned = [&](double scale) {
        // Gram and Schmidt, then unequal axes; as floats, since GL keeps more of a matrix than a float's
        // bits.
        const Vec3 x = unit(direction()), d = direction();
        const Vec3 y = unit(sum(d, scaled(x, -dot(x, d))));
        const Vec3 z{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
        Mat4 m = identity();
        for (std::size_t i = 0; i < 3; ++i) {
            m[i] = static_cast<float>(x[i] * scale);
            m[4 + i] = static_cast<float>(y[i] * scale);
            m[8 + i] = static_cast<float>(z[i] * scale);
            m[12 + i] = real(-20, 20);
        }
        return m;
    };
    double worst = 0, total = 0;
    int compared = 0;
    for (int n = 0; n < 40000; ++n) {
        LitVertex v;
        const int lights = 1 + static_cast<int>(random() % 8);
        const double share = 1.0 / lights;
        for (int i = 0; i < lights; ++i) {
            LightSource& l = v.light[random() % 8];
            l.on = true;
            l.ambient = color(), l.diffuse = color(), l.specular = color();
            for (Vec4* part : {&l.ambient, &l.diffuse, &l.specular})
                for (double& c : *part)
                    c = static_cast<float>(c * share);
            l.position = {real(-30, 30), real(-30, 30), real(-30, 30), flip() ? 0 : real(0.5, 2)};
            l.spot_direction = direction();
            if (flip()) {
                l.spot_cutoff = real(20, 90);
                l.spot_exponent = flip() ? 0 : real(0, 128);
            }
            if (flip())
                l.constant = real(0.5, 2), l.linear = real(0, 0.2), l.quadratic = real(0, 0.02);
        }
        SurfaceMaterial& m = v.material[0];
        m.ambient = color(), m.diffuse = color(), m.emission = color();
        if (flip())
            m.specular = color(), m.shininess = real(0, 128);
        v.scene_ambient = color();
        v.local_viewer = flip(), v.separate_specular = flip();
        const int normals = static_cast<int>(random() % 3);
        v.normalize = normals == 1, v.rescale = normals == 2;
        v.light_matrix = turned(1);
        v.modelview = turned(normals == 0 ? 1 : real(0.2, 4));
        const Vec3 normal = unit(direction());
        for (std::size_t c = 0; c < 3; ++c)
            v.normal[c] = static_cast<float>(normal[c] * (v.normalize ? 3 : 1));
        v.position = {real(-20, 20), real(-20, 20), real(-20, 20), 1};
        const LitColor expected = equation(v, 0);
        if (expected.margin < 1.0 / (1 << 20))
            continue;
        const double error = difference(lit_point(v), expected);
        ++compared;
        total += error;
        worst = std::fmax(worst, error);
    }
    std::printf("%d random scenes: worst component off by %.6f / 255, mean of the worst %.7f / 255\n",
                compared, worst, total / compared);
    EXPECT_GT(compared, 39000);
    EXPECT_LT(worst, 0.01);
}

/// Lights that reach every vertex alike, on objects stretched by up to 2^9 before and after they are turned.
TEST_F(Lighting, StretchedObjects) {
    std::mt19937 random(5);
    const auto real = [&random](double low, double high) {
        return static_cast<double>(static_cast<float>(std::uniform_real_distribution<>(low, high)(random)));
    };
    const auto stretch = [&random] { return std::ldexp(1.0, static_cast<int>(random() % 10)); };
    const Mat4 turn = {2 / 3.0,  -2 / 3.0, 1 / 3.0, 0, 1 / 3.0, 2 / 3.0, 2 / 3.0, 0,
                       -2 / 3.0, -1 / 3.0, 2 / 3.0, 0, 0,       0,       0,       1};
    double worst = 0;
    for (int n = 0; n < 20000; ++n) {
        LitVertex v;
        only_diffuse(v);
        v.light[0].position = {real(-1, 1), real(-1, 1), real(-1, 1), 0};
        v.light[3] = v.light[0];
        v.light[3].position = {real(-1, 1), real(-1, 1), real(-1, 1), 0};
        const bool before = (n & 1) != 0, after = (n & 2) != 0;
        v.modelview = before ? times(turn, scaling(stretch(), stretch(), stretch())) : turn;
        if (after)
            v.modelview = times(scaling(stretch(), stretch(), stretch()), v.modelview);
        if ((n & 4) != 0)
            v.modelview = times(turn, v.modelview);
        for (double& e : v.modelview)
            e = static_cast<float>(e);
        v.normalize = true;
        for (double& c : v.normal)
            c = real(-1, 1) * stretch();
        if ((n & 8) != 0) { // what becomes a unit vector
            const Mat4& m = v.modelview;
            const Vec3 eye = unit(v.normal);
            for (std::size_t c = 0; c < 3; ++c)
                v.normal[c] =
                    static_cast<float>(m[4 * c] * eye[0] + m[4 * c + 1] * eye[1] + m[4 * c + 2] * eye[2]);
        }
        worst = std::fmax(worst, difference(lit_point(v), equation(v, 0)));
    }
    std::printf("stretched objects: worst component off by %.6f / 255\n", worst);
    EXPECT_LT(worst, 0.001);
}

/// Eight lights as bright as they can be, on a normal four times too long: the sum is 1, not what overflows.
TEST_F(Lighting, TooMuchLight) {
    LitVertex v;
    for (LightSource& l : v.light) {
        l.on = true;
        l.position = {0, 0, 1, 0};
        l.diffuse = {1e30, 40000, 1900, 1};
    }
    v.normal = {0, 0, 4};
    const raster::FixedVertex got = lit_point(v);
    for (int c = 0; c < 3; ++c)
        EXPECT_EQ(got.color[c], raster::color_one) << c;
}

/// Table 2.7, before anything is set.
TEST_F(Lighting, Defaults) {
    const LitVertex v;
    const auto light = [](GLenum name, GLenum property, auto expected) {
        GLfloat got[4] = {};
        glGetLightfv(name, property, got);
        for (std::size_t c = 0; c < expected.size(); ++c)
            EXPECT_EQ(got[c], static_cast<GLfloat>(expected[c])) << name << ' ' << property;
    };
    using One = std::array<double, 1>;
    for (GLenum i = 0; i < 8; ++i) {
        const LightSource& l = v.light[i];
        light(GL_LIGHT0 + i, GL_AMBIENT, l.ambient);
        light(GL_LIGHT0 + i, GL_DIFFUSE, l.diffuse);
        light(GL_LIGHT0 + i, GL_SPECULAR, l.specular);
        light(GL_LIGHT0 + i, GL_POSITION, l.position);
        light(GL_LIGHT0 + i, GL_SPOT_DIRECTION, l.spot_direction);
        light(GL_LIGHT0 + i, GL_SPOT_EXPONENT, One{0});
        light(GL_LIGHT0 + i, GL_SPOT_CUTOFF, One{180});
        light(GL_LIGHT0 + i, GL_CONSTANT_ATTENUATION, One{1});
        light(GL_LIGHT0 + i, GL_LINEAR_ATTENUATION, One{0});
        light(GL_LIGHT0 + i, GL_QUADRATIC_ATTENUATION, One{0});
    }
    for (const GLenum face : {GL_FRONT, GL_BACK}) {
        const SurfaceMaterial& m = v.material[0];
        GLfloat got[4];
        for (const auto& [property, expected] : {std::pair<GLenum, Vec4>{GL_AMBIENT, m.ambient},
                                                 {GL_DIFFUSE, m.diffuse},
                                                 {GL_SPECULAR, m.specular},
                                                 {GL_EMISSION, m.emission}}) {
            glGetMaterialfv(face, property, got);
            EXPECT_TRUE(std::equal(got, got + 4, floats(expected).begin())) << face << ' ' << property;
        }
        glGetMaterialfv(face, GL_SHININESS, got);
        EXPECT_EQ(got[0], 0.0f);
    }
    GLfloat ambient[4];
    glGetFloatv(GL_LIGHT_MODEL_AMBIENT, ambient);
    EXPECT_TRUE(std::equal(ambient, ambient + 4, floats(v.scene_ambient).begin()));
}

// --- ColorMaterial, materials inside Begin/End, sides

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

/// The corners of one triangle facing the viewer, or turned away.
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

/// The same of the back, also of corners that clipping makes: COLOR_MATERIAL of a face that is not known yet.
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

TEST_F(Lighting, TwoSides) {
    LitVertex v;
    v.material[0].diffuse = {0.5, 0, 0, 0.25};
    v.material[1].diffuse = {0, 0.5, 0, 0.75};
    v.material[1].specular = {0, 0, 0.5, 1};
    v.material[1].shininess = 3;
    v.normal = {0.6f, 0, 0.8f};
    v.light[1].on = true; // lights what faces away
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
                    // Where it is in the window says where it was.
                    LitVertex at = v;
                    at.position = {corner.x / 256.0 * 400 / size - 200, corner.y / 256.0 * 400 / size - 200,
                                   0, 1};
                    EXPECT_LT(difference(corner, equation(at, side)), 0.001)
                        << two_side << clockwise_is_front << counterclockwise;
                }
            }
}

/// GL 1.3, 2.13.1: points and lines are always lit from the front.
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

/// Both sides of a polygon that clipping cuts: back colours come from mixed normals and positions.
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

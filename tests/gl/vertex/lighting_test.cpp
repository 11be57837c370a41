// Rows C04, C06, C07: compares colours of vertices with the equation of the specification.
#include <functional>
#include <string>
#include <vector>

#include "tests/gl/vertex/lighting_canvas.hpp"

namespace spangle::test {
namespace {

void only_specular(LitVertex& v, double shininess) {
    only_diffuse(v);
    v.material[0].diffuse = {0, 0, 0, 1};
    v.material[0].specular = {1, 0.5, 0.25, 1};
    v.material[0].shininess = shininess;
}
/// Puts LIGHT0 at the eye, looking down -z, with ambient light only. The vertex is 5 away, at cosine 0.8 from
/// the light's axis.
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
    Vec3 expected; ///< computed by hand
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
    {"a divisor below 1 makes lights brighter: 13/256 / 0.0625",
     {0.8125, 0.40625, 0.203125},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].position = {0, 0, 5, 1};
         v.light[0].constant = 0.0625;
         v.light[0].diffuse = {0.05078125f, 0.025390625f, 0.0126953125f, 1};
     }},
    {"even a little brighter than four times: 0.1 / 0.1875",
     {8 / 15.0, 4 / 15.0, 2 / 15.0},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].position = {0, 0, 5, 1};
         v.light[0].constant = 0.1875;
         v.light[0].diffuse = {0.1F, 0.05F, 0.025F, 1};
     }},
    {"and spots: 0.8^4 / 0.0625 0.125",
     {0.8192, 0.4096, 0.2048},
     [](LitVertex& v) {
         spot(v, 60, 4);
         v.light[0].constant = 0.0625;
         v.light[0].ambient = {0.125, 0.0625, 0.03125, 1};
     }},
    {"and highlights: 0.8^2 / 0.125 0.125",
     {0.64, 0.32, 0.16},
     [](LitVertex& v) {
         only_specular(v, 2);
         v.normal = {0.6f, 0, 0.8f};
         v.light[0].position = {0, 0, 5, 1};
         v.light[0].constant = 0.125;
         v.light[0].specular = {0.125, 0.125, 0.125, 1};
     }},
    {"as bright as 2^60, beside a dark colour",
     {1, 0, 0},
     [](LitVertex& v) {
         only_diffuse(v);
         v.light[0].position = {0, 0, 5, 1};
         v.light[0].constant = 0x1p-60;
         v.light[0].diffuse = {1, 0, -1, 1};
     }},
    {"eight of them",
     {1, 1, 1},
     [](LitVertex& v) {
         only_diffuse(v);
         for (LightSource& l : v.light) {
             l.on = true;
             l.position = {0, 0, 5, 1};
             l.constant = 0x1p-60;
             l.diffuse = {1, 1, 1, 1};
         }
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

/// With eight lights as bright as possible, on a normal four times too long, the sum is 1 and does not
/// overflow.
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

/// Tests the values of GL 1.3, table 2.7, before anything is set.
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

} // namespace
} // namespace spangle::test

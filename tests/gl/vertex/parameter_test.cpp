// Rows A02, C07, C08, F09, F18, G02: sets parameters of lights, materials, fog and textures in every type,
// and reads them back.
#include <cmath>
#include <functional>
#include <vector>

#include "tests/gl/vertex/canvas.hpp"

namespace spangle::test {
namespace {

/// The forms of one family of commands, whose object is already chosen.
struct Forms {
    std::function<void(GLenum, GLfloat)> f;
    std::function<void(GLenum, GLint)> i;
    std::function<void(GLenum, GLfixed)> x;
    std::function<void(GLenum, const GLfloat*)> fv;
    std::function<void(GLenum, const GLint*)> iv;
    std::function<void(GLenum, const GLfixed*)> xv;
    std::function<void(GLenum, GLfloat*)> get_f;
    std::function<void(GLenum, GLint*)> get_i;
    std::function<void(GLenum, GLfixed*)> get_x;
};

#define SPANGLE_FORMS(name, ...)                                                                             \
    Forms {                                                                                                  \
        [](GLenum p, GLfloat v) { gl##name##f(__VA_ARGS__ p, v); },                                          \
            [](GLenum p, GLint v) { gl##name##i(__VA_ARGS__ p, v); },                                        \
            [](GLenum p, GLfixed v) { gl##name##xOES(__VA_ARGS__ p, v); },                                   \
            [](GLenum p, const GLfloat* v) { gl##name##fv(__VA_ARGS__ p, v); },                              \
            [](GLenum p, const GLint* v) { gl##name##iv(__VA_ARGS__ p, v); },                                \
            [](GLenum p, const GLfixed* v) { gl##name##xvOES(__VA_ARGS__ p, v); },                           \
            [](GLenum p, GLfloat* v) { glGet##name##fv(__VA_ARGS__ p, v); },                                 \
            [](GLenum p, GLint* v) { glGet##name##iv(__VA_ARGS__ p, v); },                                   \
            [](GLenum p, GLfixed* v) { glGet##name##xvOES(__VA_ARGS__ p, v); }                               \
    }
#define SPANGLE_SET_FORMS(name)                                                                              \
    Forms {                                                                                                  \
        gl##name##f, gl##name##i, gl##name##xOES, gl##name##fv, gl##name##iv, gl##name##xvOES,               \
            [](GLenum p, GLfloat* v) { glGetFloatv(p, v); },                                                 \
            [](GLenum p, GLint* v) { glGetIntegerv(p, v); },                                                 \
            [](GLenum p, GLfixed* v) { glGetFixedvOES(p, v); }                                               \
    }

class Parameters : public Canvas {
  protected:
    /// (2c + 1) / (2^32 - 1), as GL 1.3, table 2.6 has it.
    static double fraction(GLint c) { return (2.0 * c + 1) / 4294967295.0; }

    static void floats_are(const Forms& forms, GLenum pname, const std::vector<double>& expected) {
        GLfloat f[4] = {};
        forms.get_f(pname, f);
        for (std::size_t k = 0; k < expected.size(); ++k)
            EXPECT_NEAR(f[k], expected[k], std::ldexp(std::fabs(expected[k]), -23))
                << std::hex << pname << ' ' << k;
    }

    /// Sets colours of four components; integers are converted by table 2.6. With `clamps` they are kept in
    /// [0, 1].
    static void color(const Forms& forms, GLenum pname, bool clamps) {
        const auto kept = [clamps](double v) { return clamps ? std::fmin(1, std::fmax(0, v)) : v; };
        const GLfloat f[4] = {0.25f, -1.5f, 3, 1};
        forms.fv(pname, f);
        floats_are(forms, pname, {0.25, kept(-1.5), kept(3), 1});
        const GLint i[4] = {INT32_MAX, INT32_MIN, 0x20000000, 1};
        forms.iv(pname, i);
        floats_are(forms, pname, {1, kept(-1), fraction(0x20000000), fraction(1)});
        GLint back[4];
        forms.get_i(pname, back);
        EXPECT_EQ(back[0], INT32_MAX);
        EXPECT_EQ(back[1], clamps ? 0 : INT32_MIN);
        EXPECT_NEAR(back[2], 0x20000000, 64) << "a float has 24 bits";
        const GLfixed x[4] = {0x4000, -0x18000, 0x10000, 0x8000};
        forms.xv(pname, x);
        floats_are(forms, pname, {0.25, kept(-1.5), 1, 0.5});
        GLfixed fixed[4];
        forms.get_x(pname, fixed);
        EXPECT_EQ(fixed[1], clamps ? 0 : -0x18000);
        EXPECT_EQ(fixed[3], 0x8000);
    }

    /// Sets numbers that are not colours: integers are not scaled, and are rounded when they are read back.
    static void vector(const Forms& forms, GLenum pname, std::size_t count) {
        const GLfloat f[4] = {0.75f, -2.5f, 7.25f, 1};
        const GLint i[4] = {3, -2, 70000, 1};
        const GLfixed x[4] = {0xC000, -0x28000, 0x74000, 0x10000};
        const std::vector<double> reals = {0.75, -2.5, 7.25, 1}, whole = {3, -2, 70000, 1};
        const auto first = static_cast<std::ptrdiff_t>(count);
        forms.fv(pname, f);
        floats_are(forms, pname, {reals.begin(), reals.begin() + first});
        GLint back[4];
        forms.get_i(pname, back);
        EXPECT_EQ(back[0], 1) << "0.75";
        EXPECT_EQ(back[2], 7) << "7.25";
        forms.iv(pname, i);
        floats_are(forms, pname, {whole.begin(), whole.begin() + first});
        forms.xv(pname, x);
        floats_are(forms, pname, {reals.begin(), reals.begin() + first});
    }

    static void number(const Forms& forms, GLenum pname) {
        const GLfloat f = 2.25f;
        const GLint i = 5;
        const GLfixed x = 0x18000;
        forms.f(pname, 1.5f);
        floats_are(forms, pname, {1.5});
        forms.fv(pname, &f);
        floats_are(forms, pname, {2.25});
        forms.i(pname, 3);
        floats_are(forms, pname, {3});
        forms.iv(pname, &i);
        floats_are(forms, pname, {5});
        forms.x(pname, 0x28000);
        floats_are(forms, pname, {2.5});
        forms.xv(pname, &x);
        floats_are(forms, pname, {1.5});
        GLint back = 0;
        forms.f(pname, 2.75f);
        forms.get_i(pname, &back);
        EXPECT_EQ(back, 3);
        GLfixed fixed = 0;
        forms.get_x(pname, &fixed);
        EXPECT_EQ(fixed, 0x2C000);
    }

    static void token(const Forms& forms, GLenum pname, GLint a, GLint b) {
        const auto is = [&](GLint expected) {
            GLint back = 0;
            GLfixed fixed = 0;
            forms.get_i(pname, &back);
            forms.get_x(pname, &fixed);
            EXPECT_EQ(back, expected) << std::hex << pname;
            EXPECT_EQ(fixed, expected) << "a name is not a number: " << std::hex << pname;
        };
        const GLfloat f = static_cast<GLfloat>(b);
        forms.f(pname, static_cast<GLfloat>(a)), is(a);
        forms.fv(pname, &f), is(b);
        forms.i(pname, a), is(a);
        forms.iv(pname, &b), is(b);
        forms.x(pname, a), is(a);
        forms.xv(pname, &b), is(b);
    }

    /// A form for one number refuses a vector parameter with INVALID_ENUM, and changes nothing.
    static void not_a_number(const Forms& forms, GLenum pname) {
        GLfloat before[4] = {}, after[4] = {};
        forms.get_f(pname, before);
        forms.f(pname, 0.125f);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM)) << std::hex << pname;
        forms.i(pname, 1);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM)) << std::hex << pname;
        forms.x(pname, 0x100);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM)) << std::hex << pname;
        forms.get_f(pname, after);
        EXPECT_TRUE(std::equal(before, before + 4, after));
    }
};

TEST_F(Parameters, OfLights) {
    const Forms light = SPANGLE_FORMS(Light, GL_LIGHT3, );
    for (const GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) {
        color(light, pname, false);
        not_a_number(light, pname);
    }
    vector(light, GL_POSITION, 4);
    vector(light, GL_SPOT_DIRECTION, 3);
    not_a_number(light, GL_SPOT_DIRECTION);
    for (const GLenum pname : {GL_SPOT_EXPONENT, GL_SPOT_CUTOFF, GL_CONSTANT_ATTENUATION,
                               GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION})
        number(light, pname);
}

TEST_F(Parameters, OfMaterials) {
    const Forms front = SPANGLE_FORMS(Material, GL_FRONT, ), back = SPANGLE_FORMS(Material, GL_BACK, );
    for (const GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}) {
        GLfloat untouched[4], now[4];
        back.get_f(pname, untouched);
        color(front, pname, false);
        back.get_f(pname, now);
        EXPECT_TRUE(std::equal(now, now + 4, untouched)) << "the other side";
        color(back, pname, false);
        not_a_number(front, pname);
    }
    number(front, GL_SHININESS);
    number(back, GL_SHININESS);
}

TEST_F(Parameters, OfTheLightModel) {
    const Forms model = SPANGLE_SET_FORMS(LightModel);
    color(model, GL_LIGHT_MODEL_AMBIENT, false);
    not_a_number(model, GL_LIGHT_MODEL_AMBIENT);
    token(model, GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR, GL_SINGLE_COLOR);
    token(model, GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE, GL_FALSE);
    token(model, GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE, GL_FALSE);
}

TEST_F(Parameters, OfFog) {
    const Forms fog = SPANGLE_SET_FORMS(Fog);
    color(fog, GL_FOG_COLOR, true);
    not_a_number(fog, GL_FOG_COLOR);
    for (const GLenum pname : {GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END})
        number(fog, pname);
    number(fog, GL_FOG_INDEX);
    token(fog, GL_FOG_MODE, GL_LINEAR, GL_EXP2);
    token(fog, GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE, GL_FRAGMENT_DEPTH);
}

TEST_F(Parameters, OfTextures) {
    const Forms texture = SPANGLE_FORMS(TexParameter, GL_TEXTURE_2D, ),
                environment = SPANGLE_FORMS(TexEnv, GL_TEXTURE_ENV, );
    color(texture, GL_TEXTURE_BORDER_COLOR, true);
    not_a_number(texture, GL_TEXTURE_BORDER_COLOR);
    number(texture, GL_TEXTURE_MIN_LOD);
    number(texture, GL_TEXTURE_MAX_LOD);
    token(texture, GL_TEXTURE_BASE_LEVEL, 3, 4);
    token(texture, GL_TEXTURE_WRAP_S, GL_CLAMP, GL_CLAMP_TO_EDGE);
    token(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST);
    color(environment, GL_TEXTURE_ENV_COLOR, true);
    not_a_number(environment, GL_TEXTURE_ENV_COLOR);
    token(environment, GL_TEXTURE_ENV_MODE, GL_ADD, GL_DECAL);
}

} // namespace
} // namespace spangle::test

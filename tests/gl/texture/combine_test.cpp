// Compares COMBINE with the formulas of GL 1.3, 3.8.13 in double, and tests its state.
#include <cmath>
#include <map>

#include "tests/gl/texture/drawing.hpp"
#include "tests/support/random.hpp"

namespace {

using spangle::test::Drawing;

struct Rgba {
    double v[4];
};

double clamp(double v) {
    return v < 0 ? 0 : v > 1 ? 1 : v;
}

struct Combiner {
    GLenum func, source[3], operand[3];
    int scale;
};
struct Unit {
    Combiner rgb, alpha;
    Rgba constant;
};

struct Inputs {
    Rgba primary, previous, texture[2];
    int unit;
    const Unit& state;

    Rgba source(GLenum token) const {
        switch (token) {
        case GL_TEXTURE:
            return texture[unit];
        case GL_CONSTANT:
            return state.constant;
        case GL_PRIMARY_COLOR:
            return primary;
        case GL_PREVIOUS:
            return previous;
        default:
            return texture[token - GL_TEXTURE0];
        }
    }
    double argument(const Combiner& c, int i, int component) const {
        const Rgba from = source(c.source[i]);
        switch (c.operand[i]) {
        case GL_SRC_COLOR:
            return from.v[component];
        case GL_ONE_MINUS_SRC_COLOR:
            return 1 - from.v[component];
        case GL_SRC_ALPHA:
            return from.v[3];
        default:
            return 1 - from.v[3];
        }
    }
};

double combined(const Combiner& c, const Inputs& in, int component) {
    const double a = in.argument(c, 0, component), b = in.argument(c, 1, component),
                 k = in.argument(c, 2, component);
    switch (c.func) {
    case GL_REPLACE:
        return a;
    case GL_MODULATE:
        return a * b;
    case GL_ADD:
        return a + b;
    case GL_ADD_SIGNED:
        return a + b - 0.5;
    case GL_INTERPOLATE:
        return a * k + b * (1 - k);
    case GL_SUBTRACT:
        return a - b;
    default: {
        double sum = 0;
        for (int i = 0; i < 3; ++i)
            sum += (in.argument(c, 0, i) - 0.5) * (in.argument(c, 1, i) - 0.5);
        return 4 * sum;
    }
    }
}

Rgba result(const Inputs& in) {
    Rgba out;
    for (int i = 0; i < 4; ++i) {
        const bool rgb = i < 3 || in.state.rgb.func == GL_DOT3_RGBA;
        const double v = combined(rgb ? in.state.rgb : in.state.alpha, in, i);
        out.v[i] = clamp(v * (i < 3 ? in.state.rgb.scale : in.state.alpha.scale));
    }
    return out;
}

void apply(const Combiner& c, bool alpha) {
    const auto env = [](GLenum pname, GLenum value) {
        glTexEnvi(GL_TEXTURE_ENV, pname, static_cast<GLint>(value));
    };
    env(alpha ? GL_COMBINE_ALPHA : GL_COMBINE_RGB, c.func);
    for (unsigned i = 0; i < 3; ++i) {
        env((alpha ? GL_SOURCE0_ALPHA : GL_SOURCE0_RGB) + i, c.source[i]);
        env((alpha ? GL_OPERAND0_ALPHA : GL_OPERAND0_RGB) + i, c.operand[i]);
    }
    glTexEnvf(GL_TEXTURE_ENV, alpha ? GL_ALPHA_SCALE : GL_RGB_SCALE, static_cast<float>(c.scale));
}

struct Combine : Drawing {
    spangle::test::Random random{7};

    GLubyte byte() {
        return static_cast<GLubyte>(random.below(4) == 0 ? 255 * random.below(2) : random.below(256));
    }
    Combiner combiner(bool alpha) {
        const GLenum functions[] = {GL_REPLACE,     GL_MODULATE, GL_ADD,      GL_ADD_SIGNED,
                                    GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};
        const GLenum sources[] = {GL_TEXTURE,  GL_CONSTANT, GL_PRIMARY_COLOR,
                                  GL_PREVIOUS, GL_TEXTURE0, GL_TEXTURE1};
        const GLenum operands[] = {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_COLOR,
                                   GL_ONE_MINUS_SRC_COLOR};
        Combiner c;
        c.func = functions[random.below(alpha ? 6 : 8)];
        for (int i = 0; i < 3; ++i) {
            c.source[i] = sources[random.below(6)];
            c.operand[i] = operands[random.below(alpha ? 2 : 4)];
        }
        c.scale = 1 << random.below(3);
        return c;
    }
    Rgba texture() {
        GLubyte texel[4];
        Rgba out;
        for (int i = 0; i < 4; ++i)
            out.v[i] = (texel[i] = byte()) / 255.0;
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glEnable(GL_TEXTURE_2D);
        return out;
    }
    Rgba constant() {
        float c[4];
        Rgba out;
        for (int i = 0; i < 4; ++i)
            out.v[i] = c[i] = static_cast<float>(byte()) / 255;
        glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, c);
        return out;
    }
};

TEST_F(Combine, EveryFunctionSourceOperandAndScaleInBothUnits) {
    glBindTexture(GL_TEXTURE_2D, 1);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, 2);
    glMultiTexCoord2f(GL_TEXTURE1, 0.5f, 0.5f);
    for (int round = 0; round < 6000; ++round) {
        const bool exact = round % 2 == 0;
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, exact ? GL_NICEST : GL_FASTEST);
        Unit units[2];
        Inputs in{{}, {}, {}, 0, units[0]};
        for (int u = 0; u < 2; ++u) {
            glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(u));
            in.texture[u] = texture();
            units[u] = {combiner(false), combiner(true), constant()};
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
            apply(units[u].rgb, false);
            apply(units[u].alpha, true);
        }
        GLubyte color[4];
        for (int i = 0; i < 4; ++i)
            in.primary.v[i] = (color[i] = byte()) / 255.0;
        glColor4ubv(color);
        in.previous = in.primary;
        const Rgba first = result(in);
        const Rgba wanted = result({in.primary, first, {in.texture[0], in.texture[1]}, 1, units[1]});
        std::vector<GLubyte> pixel;
        draw(0.5f, 0.5f, pixel);
        // The other tiers compute in 256ths of a 255th. A chain of two units is rounded down up to 16 times,
        // and scaled by 4 in the product and by 4 behind it, in both units.
        for (std::size_t i = 0; i < 4; ++i)
            ASSERT_NEAR(pixel[i], wanted.v[i] * 255, exact ? 0.502 : 8)
                << "round " << round << " component " << i;
    }
}

TEST_F(Combine, AUnitAfterAnotherEnvironmentAndOneThatIsOff) {
    const GLubyte texel[4] = {51, 102, 153, 204};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glActiveTexture(GL_TEXTURE1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_ADD);
    // Behind a REPLACE the primary colour is still the vertex's.
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_PRIMARY_COLOR);
    glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB, GL_SRC_ALPHA); // reads alpha, which nothing else uses
    glColor4ub(9, 9, 9, 40);
    std::vector<GLubyte> pixel;
    draw(0.5f, 0.5f, pixel);
    EXPECT_EQ(pixel[0], 91);
    EXPECT_EQ(pixel[2], 193);
    // Unit 1 now asks for the texture of unit 0, which is disabled, so unit 1 has no effect.
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_RGB, GL_TEXTURE0);
    glActiveTexture(GL_TEXTURE0);
    glDisable(GL_TEXTURE_2D);
    draw(0.5f, 0.5f, pixel);
    EXPECT_EQ(pixel[0], 9);
    EXPECT_EQ(pixel[3], 40);
}

TEST_F(Combine, StateIsKeptAndBadValuesRefused) {
    const std::map<GLenum, GLint> initial = {{GL_COMBINE_RGB, GL_MODULATE},
                                             {GL_COMBINE_ALPHA, GL_MODULATE},
                                             {GL_SOURCE0_RGB, GL_TEXTURE},
                                             {GL_SOURCE1_RGB, GL_PREVIOUS},
                                             {GL_SOURCE2_RGB, GL_CONSTANT},
                                             {GL_SOURCE0_ALPHA, GL_TEXTURE},
                                             {GL_SOURCE1_ALPHA, GL_PREVIOUS},
                                             {GL_SOURCE2_ALPHA, GL_CONSTANT},
                                             {GL_OPERAND0_RGB, GL_SRC_COLOR},
                                             {GL_OPERAND1_RGB, GL_SRC_COLOR},
                                             {GL_OPERAND2_RGB, GL_SRC_ALPHA},
                                             {GL_OPERAND0_ALPHA, GL_SRC_ALPHA},
                                             {GL_OPERAND1_ALPHA, GL_SRC_ALPHA},
                                             {GL_OPERAND2_ALPHA, GL_SRC_ALPHA},
                                             {GL_RGB_SCALE, 1},
                                             {GL_ALPHA_SCALE, 1}};
    const auto get = [](GLenum pname) {
        GLint value = -1;
        glGetTexEnviv(GL_TEXTURE_ENV, pname, &value);
        return value;
    };
    const GLenum values[] = {GL_REPLACE,
                             GL_DOT3_RGB,
                             GL_TEXTURE,
                             GL_TEXTURE0,
                             GL_TEXTURE31,
                             GL_PRIMARY_COLOR,
                             GL_SRC_COLOR,
                             GL_SRC_ALPHA,
                             GL_DST_COLOR,
                             GL_ZERO,
                             2,
                             4,
                             3};
    for (const auto& [pname, value] : initial) {
        EXPECT_EQ(get(pname), value) << std::hex << pname;
        const bool rgb = pname == GL_COMBINE_RGB || (pname >= GL_SOURCE0_RGB && pname <= GL_SOURCE2_RGB) ||
                         (pname >= GL_OPERAND0_RGB && pname <= GL_OPERAND2_RGB);
        for (const GLenum v : values) {
            bool legal = false;
            GLenum code = GL_INVALID_ENUM;
            if (pname == GL_COMBINE_RGB || pname == GL_COMBINE_ALPHA)
                legal = v == GL_REPLACE || (rgb && v == GL_DOT3_RGB);
            else if (pname == GL_RGB_SCALE || pname == GL_ALPHA_SCALE)
                legal = v == 2 || v == 4, code = GL_INVALID_VALUE;
            else if (pname >= GL_OPERAND0_RGB)
                legal = v == GL_SRC_ALPHA || (rgb && v == GL_SRC_COLOR);
            else
                legal = v == GL_TEXTURE || v == GL_TEXTURE0 || v == GL_PRIMARY_COLOR;
            const GLint before = get(pname);
            glTexEnvi(GL_TEXTURE_ENV, pname, static_cast<GLint>(v));
            EXPECT_EQ(glGetError(), legal ? GLenum{GL_NO_ERROR} : code) << std::hex << pname << ' ' << v;
            EXPECT_EQ(get(pname), legal ? static_cast<GLint>(v) : before);
        }
    }
    // The state belongs to each unit, and the texture group saves it.
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_ALPHA, GL_TEXTURE1);
    glPushAttrib(GL_TEXTURE_BIT);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_ALPHA, GL_CONSTANT);
    glActiveTexture(GL_TEXTURE1);
    EXPECT_EQ(get(GL_SOURCE1_ALPHA), GL_PREVIOUS);
    glActiveTexture(GL_TEXTURE0);
    glPopAttrib();
    EXPECT_EQ(get(GL_SOURCE1_ALPHA), GL_TEXTURE1);
}

/// The biases of texture and unit choose a level of 4, 2 or 1 texels, although the texture is magnified.
TEST_F(Combine, TheBiasOfTextureAndUnitMovesTheLevel) {
    const GLubyte levels[3] = {10, 20, 30};
    for (GLint l = 0; l < 3; ++l) {
        const std::vector<GLubyte> texels(16, levels[l]);
        glTexImage2D(GL_TEXTURE_2D, l, GL_LUMINANCE, 4 >> l, 4 >> l, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE,
                     texels.data());
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, 0);
    const float bounds[] = {-100, 0, 0.5f, 1, 1.5f, 2, 100};
    for (const float texture : bounds)
        for (const float unit : bounds) {
            glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, texture);
            glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, unit);
            glColor3f(1, 1, 1);
            // From pixel to pixel there is half a texel: lambda is -1.
            glBegin(GL_TRIANGLE_STRIP);
            for (float y : {-1.0f, 1.0f})
                for (float x : {-1.0f, 1.0f}) {
                    glTexCoord2f(x / 4, y / 4);
                    glVertex2f(x, y);
                }
            glEnd();
            GLubyte pixel[4];
            glReadPixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
            const double lambda =
                std::fmax(0, std::fmin(2, std::fmax(-12, std::fmin(12, texture + unit)) - 1));
            EXPECT_NEAR(pixel[0], 10 + 10 * lambda, 0.51) << texture << ' ' << unit;
        }
}

} // namespace

// Tests textures in the framebuffer through public GL: wrap modes and filters by GL 1.3, 3.8.7 to 3.8.9 (F10,
// F11), and environments by the table of F18.
#include <cmath>

#include "tests/gl/texture/drawing.hpp"

namespace {

using spangle::test::Drawing;

enum Texel { T0, T1, T2, T3, Bc };
struct Sample {
    float s;
    GLenum wrap;
    Texel nearest;
    double a; ///< LINEAR gives a * first + b * second
    Texel first;
    double b;
    Texel second;
};
const Sample samples[] = {
    {-0.25f, GL_REPEAT, T3, 0.5, T2, 0.5, T3},       {-0.25f, GL_CLAMP, T0, 0.5, Bc, 0.5, T0},
    {-0.25f, GL_CLAMP_TO_EDGE, T0, 1, T0, 0, T0},    {-0.25f, GL_CLAMP_TO_BORDER, Bc, 1, Bc, 0, Bc},
    {0.0f, GL_REPEAT, T0, 0.5, T3, 0.5, T0},         {0.0f, GL_CLAMP, T0, 0.5, Bc, 0.5, T0},
    {0.0f, GL_CLAMP_TO_EDGE, T0, 1, T0, 0, T0},      {0.0f, GL_CLAMP_TO_BORDER, T0, 0.5, Bc, 0.5, T0},
    {0.125f, GL_REPEAT, T0, 1, T0, 0, T0},           {0.125f, GL_CLAMP, T0, 1, T0, 0, T0},
    {0.125f, GL_CLAMP_TO_EDGE, T0, 1, T0, 0, T0},    {0.125f, GL_CLAMP_TO_BORDER, T0, 1, T0, 0, T0},
    {0.25f, GL_REPEAT, T1, 0.5, T0, 0.5, T1},        {0.25f, GL_CLAMP, T1, 0.5, T0, 0.5, T1},
    {0.25f, GL_CLAMP_TO_EDGE, T1, 0.5, T0, 0.5, T1}, {0.25f, GL_CLAMP_TO_BORDER, T1, 0.5, T0, 0.5, T1},
    {0.9375f, GL_REPEAT, T3, 0.75, T3, 0.25, T0},    {0.9375f, GL_CLAMP, T3, 0.75, T3, 0.25, Bc},
    {0.9375f, GL_CLAMP_TO_EDGE, T3, 1, T3, 0, T3},   {0.9375f, GL_CLAMP_TO_BORDER, T3, 0.75, T3, 0.25, Bc},
    {1.0f, GL_REPEAT, T0, 0.5, T3, 0.5, T0},         {1.0f, GL_CLAMP, T3, 0.5, T3, 0.5, Bc},
    {1.0f, GL_CLAMP_TO_EDGE, T3, 1, T3, 0, T3},      {1.0f, GL_CLAMP_TO_BORDER, T3, 0.5, T3, 0.5, Bc},
    {1.25f, GL_REPEAT, T1, 0.5, T0, 0.5, T1},        {1.25f, GL_CLAMP, T3, 0.5, T3, 0.5, Bc},
    {1.25f, GL_CLAMP_TO_EDGE, T3, 1, T3, 0, T3},     {1.25f, GL_CLAMP_TO_BORDER, Bc, 1, Bc, 0, Bc},
};

const GLubyte colors[5][4] = {
    {10, 200, 30, 255}, {250, 20, 90, 128}, {0, 130, 255, 64}, {77, 3, 160, 0}, {51, 255, 102, 204}};

TEST_F(Drawing, WrapModesAndFiltersOfTheReferenceTable) {
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const float border[4] = {0.2f, 1, 0.4f, 0.8f}; // the border colour
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
    for (bool along_t : {false, true}) {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, along_t ? 1 : 4, along_t ? 4 : 1, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, colors);
        for (const Sample& sample : samples)
            for (GLenum filter : {GL_NEAREST, GL_LINEAR}) {
                glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
                glTexParameteri(GL_TEXTURE_2D, along_t ? GL_TEXTURE_WRAP_T : GL_TEXTURE_WRAP_S,
                                static_cast<GLint>(sample.wrap));
                glTexParameteri(GL_TEXTURE_2D, along_t ? GL_TEXTURE_WRAP_S : GL_TEXTURE_WRAP_T, GL_REPEAT);
                std::vector<GLubyte> pixel;
                draw(along_t ? 0.5f : sample.s, along_t ? sample.s : 0.5f, pixel);
                for (int c = 0; c < 4; ++c) {
                    const double wanted = filter == GL_NEAREST ? colors[sample.nearest][c]
                                                               : sample.a * colors[sample.first][c] +
                                                                     sample.b * colors[sample.second][c];
                    EXPECT_NEAR(pixel[static_cast<std::size_t>(c)], wanted, filter == GL_NEAREST ? 0 : 0.51)
                        << "s " << sample.s << std::hex << " wrap " << sample.wrap << " filter " << filter;
                }
            }
    }
}

TEST_F(Drawing, ABorderOfTexelsStandsInForTheBorderColour) {
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    std::vector<GLubyte> image(6 * 3); // 4 x 1 texels with a border of 1
    for (std::size_t x = 0; x < 6; ++x)
        for (std::size_t y = 0; y < 3; ++y)
            image[y * 6 + x] = static_cast<GLubyte>(20 + 40 * x);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 6, 3, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, image.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    const struct {
        GLenum wrap, filter;
        float s;
        double wanted;
    } cases[] = {{GL_CLAMP, GL_LINEAR, 0, (20 + 60) / 2.0},   {GL_CLAMP, GL_LINEAR, 1, (180 + 220) / 2.0},
                 {GL_CLAMP_TO_EDGE, GL_LINEAR, -3, 60},       {GL_CLAMP_TO_BORDER, GL_LINEAR, -3, 20},
                 {GL_CLAMP_TO_BORDER, GL_NEAREST, 1.2f, 220}, {GL_CLAMP, GL_NEAREST, -1, 60},
                 {GL_REPEAT, GL_LINEAR, 0, (60 + 180) / 2.0}};
    for (const auto& v : cases) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, static_cast<GLint>(v.wrap));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(v.filter));
        std::vector<GLubyte> pixel;
        draw(v.s, 0.5f, pixel);
        EXPECT_NEAR(pixel[0], v.wanted, 0.51) << std::hex << v.wrap << " " << v.filter << " " << v.s;
    }
}

struct Rgba {
    double v[4];
};

/// Computes the table of F18 with Cf, Af, Cs, As, Cc, Ac from 0 to 1. Returns false if the result is
/// undefined.
bool environment(GLenum mode, GLenum base, const Rgba& f, const Rgba& s, const Rgba& c, Rgba& out) {
    const bool color = base != GL_ALPHA;
    const bool alpha = base != GL_LUMINANCE && base != GL_RGB;
    out = f;
    for (int k = 0; k < 3; ++k) {
        const double cf = f.v[k], cs = s.v[k];
        switch (mode) {
        case GL_REPLACE:
            out.v[k] = color ? cs : cf;
            break;
        case GL_MODULATE:
            out.v[k] = color ? cf * cs : cf;
            break;
        case GL_DECAL:
            if (base != GL_RGB && base != GL_RGBA)
                return false;
            out.v[k] = base == GL_RGB ? cs : cf * (1 - s.v[3]) + cs * s.v[3];
            break;
        case GL_BLEND:
            out.v[k] = color ? cf * (1 - cs) + c.v[k] * cs : cf;
            break;
        default:
            out.v[k] = color ? std::fmin(1, cf + cs) : cf;
        }
    }
    if (!alpha || mode == GL_DECAL)
        return true;
    if (mode == GL_REPLACE)
        out.v[3] = s.v[3];
    else if (base != GL_INTENSITY || mode == GL_MODULATE)
        out.v[3] = f.v[3] * s.v[3];
    else if (mode == GL_BLEND)
        out.v[3] = f.v[3] * (1 - s.v[3]) + c.v[3] * s.v[3];
    else
        out.v[3] = std::fmin(1, f.v[3] + s.v[3]);
    return true;
}

TEST_F(Drawing, EnvironmentsOfEveryBaseFormat) {
    const Rgba constant{{0.25, 0.5, 0.75, 0.375}};
    float env[4];
    for (int k = 0; k < 4; ++k)
        env[k] = static_cast<float>(constant.v[k]);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, env);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    const GLubyte fragments[][4] = {
        {255, 255, 255, 255}, {200, 100, 50, 150}, {0, 0, 0, 0}, {17, 240, 128, 77}};
    for (const GLubyte* texel : colors)
        for (GLenum base : {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA}) {
            glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(base), 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         texel);
            Rgba source; // Cs and As of F04
            const bool grey = base == GL_LUMINANCE || base == GL_LUMINANCE_ALPHA || base == GL_INTENSITY;
            for (std::size_t k = 0; k < 3; ++k)
                source.v[k] = base == GL_ALPHA ? 0 : texel[grey ? 0 : k] / 255.0;
            source.v[3] = base == GL_INTENSITY ? texel[0] / 255.0 : texel[3] / 255.0;
            for (GLenum mode : {GL_REPLACE, GL_MODULATE, GL_DECAL, GL_BLEND, GL_ADD})
                for (const GLubyte* fragment : fragments) {
                    Rgba f, wanted;
                    for (int k = 0; k < 4; ++k)
                        f.v[k] = fragment[k] / 255.0;
                    if (!environment(mode, base, f, source, constant, wanted))
                        continue;
                    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(mode));
                    glColor4ub(fragment[0], fragment[1], fragment[2], fragment[3]);
                    std::vector<GLubyte> pixel;
                    draw(0.5f, 0.5f, pixel);
                    for (std::size_t k = 0; k < 4; ++k)
                        EXPECT_NEAR(pixel[k], wanted.v[k] * 255, 0.75)
                            << std::hex << "mode " << mode << " base " << base << " component " << k;
                }
        }
}

TEST_F(Drawing, AnIncompleteTextureDrawsAsIfThereWereNone) {
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, colors);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glColor4ub(1, 2, 3, 4);
    std::vector<GLubyte> pixel;
    draw(0.25f, 0.75f, pixel);
    EXPECT_EQ(pixel[1], colors[T2][1]);
    // This filter needs a second level.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_LINEAR);
    draw(0.25f, 0.75f, pixel);
    EXPECT_EQ(pixel[1], 2);
    glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, colors);
    draw(0.25f, 0.75f, pixel);
    EXPECT_EQ(pixel[1], colors[T2][1]);
}

} // namespace

// Compares textures of every target, wrap mode, filter, size, format and level with the oracle.
#include <cmath>

#include "tests/gl/texture/drawing.hpp"
#include "tests/gl/texture/sampling_oracle.hpp"
#include "tests/support/random.hpp"

namespace {

using spangle::test::oracle::Image;
using spangle::test::oracle::Rgba;
using spangle::test::oracle::Texture;

struct Format {
    GLint internal;
    GLenum base;
    int bits[4]; ///< bits of R (luminance, intensity), G, B, A
};
const Format formats[] = {{GL_ALPHA8, GL_ALPHA, {8, 8, 8, 8}},
                          {GL_LUMINANCE8, GL_LUMINANCE, {8, 8, 8, 8}},
                          {GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, {8, 8, 8, 8}},
                          {GL_INTENSITY8, GL_INTENSITY, {8, 8, 8, 8}},
                          {GL_RGB8, GL_RGB, {8, 8, 8, 8}},
                          {GL_RGB5, GL_RGB, {5, 6, 5, 8}},
                          {GL_R3_G3_B2, GL_RGB, {3, 3, 2, 8}},
                          {GL_RGBA8, GL_RGBA, {8, 8, 8, 8}},
                          {GL_RGBA4, GL_RGBA, {4, 4, 4, 4}},
                          {GL_RGB5_A1, GL_RGBA, {5, 5, 5, 1}}};

/// Returns the part of a colour that a unit takes from the base format (table 3.21).
Rgba as_base(GLenum base, const Rgba& c) {
    switch (base) {
    case GL_ALPHA:
        return {0, 0, 0, c[3]};
    case GL_LUMINANCE:
        return {c[0], c[0], c[0], 1};
    case GL_LUMINANCE_ALPHA:
        return {c[0], c[0], c[0], c[3]};
    case GL_INTENSITY:
        return {c[0], c[0], c[0], c[0]};
    case GL_RGB:
        return {c[0], c[1], c[2], 1};
    default:
        return c;
    }
}

struct Targets : spangle::test::Drawing {
    spangle::test::Random random{11};

    void SetUp() override {
        Drawing::SetUp();
        glDisable(GL_TEXTURE_2D);
        glColor4f(0, 0, 0, 0);
        // COMBINE does REPLACE, so that components that a base format lacks are visible, too.
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
        glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_REPLACE);
        glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_REPLACE);
    }

    template <std::size_t N> GLenum any(const GLenum (&of)[N]) { return of[random.below(N)]; }

    /// Loads random texels into GL and, as they are stored, into the oracle.
    void image(Texture& t, const Format& format, std::size_t face, int level, const int (&size)[3],
               int border) {
        Image image;
        std::size_t count = 1;
        for (int axis = 0; axis < 3; ++axis) {
            image.size[axis] = size[axis];
            image.border[axis] = axis < t.dimensions() ? border : 0;
            count *= static_cast<std::size_t>(image.whole(axis));
        }
        std::vector<GLubyte> bytes(4 * count);
        image.texels.resize(count);
        for (std::size_t n = 0; n < count; ++n) {
            Rgba kept;
            for (std::size_t c = 0; c < 4; ++c) {
                bytes[4 * n + c] = static_cast<GLubyte>(random.below(256));
                const double most = (1 << format.bits[c]) - 1;
                kept[c] = std::floor(bytes[4 * n + c] / 255.0 * most + 0.5) / most;
            }
            image.texels[n] = as_base(format.base, kept);
        }
        const int w = image.whole(0), h = image.whole(1), d = image.whole(2);
        if (t.target == GL_TEXTURE_1D)
            glTexImage1D(GL_TEXTURE_1D, level, format.internal, w, border, GL_RGBA, GL_UNSIGNED_BYTE,
                         bytes.data());
        else if (t.target == GL_TEXTURE_3D)
            glTexImage3D(GL_TEXTURE_3D, level, format.internal, w, h, d, border, GL_RGBA, GL_UNSIGNED_BYTE,
                         bytes.data());
        else
            glTexImage2D(t.target == GL_TEXTURE_2D
                             ? GLenum{GL_TEXTURE_2D}
                             : GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face),
                         level, format.internal, w, h, border, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        t.faces[face].push_back(std::move(image));
    }

    /// Makes a whole texture of random sizes, with one level or all.
    Texture texture(GLenum target, const Format& format, bool mipmaps) {
        Texture t;
        t.target = target;
        const bool cube = target == GL_TEXTURE_CUBE_MAP;
        t.faces.resize(cube ? 6 : 1);
        int base[3] = {1, 1, 1};
        for (int axis = 0; axis < t.dimensions(); ++axis)
            base[axis] = random.below(2) == 0 ? 1 << random.below(4) : 1 + static_cast<int>(random.below(9));
        if (cube)
            base[1] = base[0];
        const int border = static_cast<int>(random.below(3) == 0);
        for (std::size_t face = 0; face < t.faces.size(); ++face) {
            int size[3] = {base[0], base[1], base[2]};
            for (int level = 0;; ++level) {
                image(t, format, face, level, size, border);
                if (!mipmaps || (size[0] == 1 && size[1] == 1 && size[2] == 1))
                    break;
                for (int& side : size)
                    side = side > 1 ? side / 2 : 1;
            }
        }
        return t;
    }

    void parameters(Texture& t, const Format& format, bool mipmaps) {
        const GLenum wraps[] = {GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE,
                                GL_CLAMP_TO_BORDER};
        const GLenum mins[] = {GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR,
                               GL_LINEAR_MIPMAP_LINEAR};
        const GLenum filters[] = {GL_NEAREST, GL_LINEAR};
        const GLenum names[3] = {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};
        for (int axis = 0; axis < 3; ++axis) {
            t.wrap[axis] = any(wraps);
            glTexParameteri(t.target, names[axis], static_cast<GLint>(t.wrap[axis]));
        }
        t.min = mipmaps ? any(mins) : any(filters);
        t.mag = any(filters);
        glTexParameteri(t.target, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(t.min));
        glTexParameteri(t.target, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(t.mag));
        Rgba border;
        float given[4];
        for (std::size_t c = 0; c < 4; ++c)
            border[c] = given[c] = static_cast<float>(random.below(256)) / 255;
        glTexParameterfv(t.target, GL_TEXTURE_BORDER_COLOR, given);
        t.border_color = as_base(format.base, border);
    }

    /// Returns a coordinate at which the texels and weights of every level are certain.
    double coordinate(int size) {
        return (static_cast<double>(random.below(static_cast<std::uint32_t>(6 * 512 * size))) + 0.25) /
                   (512.0 * size) -
               2.5;
    }

    void check(const Texture& t, const Format& format, bool exact, int round) {
        double c[3];
        for (int axis = 0; axis < 3; ++axis)
            c[axis] = t.target == GL_TEXTURE_CUBE_MAP ? random.below(20001) / 10000.0 - 1
                                                      : coordinate(t.faces[0][0].size[axis]);
        const double lambda = (static_cast<int>(random.below(1536)) - 256) / 256.0;
        glTexParameterf(t.target, GL_TEXTURE_MIN_LOD, static_cast<float>(lambda));
        glTexParameterf(t.target, GL_TEXTURE_MAX_LOD, static_cast<float>(lambda));
        const float q = 0.5f + static_cast<float>(random.below(4));
        glTexCoord4d(c[0] * q, c[1] * q, c[2] * q, q);
        std::vector<GLubyte> pixel(4);
        glBegin(GL_TRIANGLE_STRIP);
        for (float y : {-1.0f, 1.0f})
            for (float x : {-1.0f, 1.0f})
                glVertex2f(x, y);
        glEnd();
        glReadPixels(2, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
        const Rgba wanted = spangle::test::oracle::sample(t, static_cast<float>(c[0] * q) / double{q},
                                                          static_cast<float>(c[1] * q) / double{q},
                                                          static_cast<float>(c[2] * q) / double{q}, lambda);
        for (std::size_t i = 0; i < 4; ++i)
            ASSERT_NEAR(pixel[i], wanted[i] * 255, exact ? 0.502 : 0.8)
                << "round " << round << " target " << std::hex << t.target << " format " << format.internal
                << " min " << t.min << " mag " << t.mag << " wraps " << t.wrap[0] << ' ' << t.wrap[1] << ' '
                << t.wrap[2] << std::dec << " size " << t.faces[0][0].size[0] << 'x' << t.faces[0][0].size[1]
                << 'x' << t.faces[0][0].size[2] << " border " << t.faces[0][0].border[0] << " at " << c[0]
                << ' ' << c[1] << ' ' << c[2] << " lambda " << lambda << " component " << i;
    }
};

TEST_F(Targets, EveryTargetFormatSizeWrapAndFilter) {
    const GLenum targets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP};
    for (int round = 0; round < 3000; ++round) {
        const GLenum target = targets[round % 4];
        const Format& format = formats[random.below(std::size(formats))];
        const bool mipmaps = random.below(2) == 0, exact = random.below(2) == 0;
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, exact ? GL_NICEST : GL_FASTEST);
        glBindTexture(target, static_cast<GLuint>(round) + 1);
        Texture t = texture(target, format, mipmaps);
        parameters(t, format, mipmaps);
        glEnable(target);
        for (int n = 0; n < 4; ++n)
            ASSERT_NO_FATAL_FAILURE(check(t, format, exact, round));
        glDisable(target);
        const GLuint name = static_cast<GLuint>(round) + 1;
        glDeleteTextures(1, &name);
        ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }
}

} // namespace

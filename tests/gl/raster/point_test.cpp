// Rows D03, D04: tests point sizes that follow the distance, their clamps and fading, and point sprites.
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_POINT_PARAMETERS

#include <cmath>

#include "tests/gl/raster/multisample.hpp"

namespace spangle::test::samples {
namespace {

class Points : public Multisample {
  protected:
    static int drawn() {
        int n = 0;
        for (const Rgba& pixel : picture())
            n += pixel[0] != 0 ? 1 : 0;
        return n;
    }
    static void point(GLfloat x, GLfloat y, GLfloat depth = 0) {
        glBegin(GL_POINTS);
        glVertex3f(x, y, -depth);
        glEnd();
    }
    /// Returns the size of the drawn square, rounded.
    static int width() { return static_cast<int>(std::lround(std::sqrt(drawn()))); }
    static void clear() { glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); }
};

/// Eye coordinates are pixels here, and the distance is that of (x, y, z) from the origin.
TEST_F(Points, SizesFollowTheDistance) {
    Target target(0);
    for (int n = 0; n < 200; ++n) {
        const GLfloat abc[3] = {static_cast<GLfloat>(lot(0, 2)), static_cast<GLfloat>(lot(0, 0.05)),
                                static_cast<GLfloat>(lot(0, 0.002))};
        const auto size_given = static_cast<GLfloat>(lot(1, 20));
        const GLfloat x = place(), y = place(), z = static_cast<GLfloat>(lot(0, 1));
        if (x < 12 || y < 12 || x > size - 12 || y > size - 12)
            continue;
        glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, abc);
        glPointSize(size_given);
        const double d = std::sqrt(x * x + y * y + z * z),
                     derived = size_given / std::sqrt(abc[0] + abc[1] * d + abc[2] * d * d);
        if (std::abs(derived - std::floor(derived) - 0.5) < 1e-3)
            continue; // such sizes may be rounded either way
        clear();
        point(x, y, z);
        ASSERT_EQ(drawn(), static_cast<int>(std::pow(std::clamp(std::round(derived), 1.0, 22.0), 2)))
            << n << ": " << derived;
    }
}

TEST_F(Points, SizesAreClamped) {
    Target target(0);
    glPointSize(10);
    glPointParameterf(GL_POINT_SIZE_MAX, 4);
    point(24, 24);
    EXPECT_EQ(width(), 4);
    glPointParameterf(GL_POINT_SIZE_MIN, 6); // GL applies the maximum last, so it wins
    glPointParameterf(GL_POINT_SIZE_MAX, 8);
    glPointSize(2);
    clear();
    point(24, 24);
    EXPECT_EQ(width(), 6);
    const GLfloat none[] = {0, 0, 0};
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, none);
    clear();
    point(24, 24);
    EXPECT_EQ(width(), 8);
}

/// Points of polygons, also at vertices that clipping makes, have sizes by distance.
TEST_F(Points, CornersOfPolygonsHaveTheirSizes) {
    Target target(0);
    const GLfloat by_distance[] = {0, 0.25f, 0}; // 16 / sqrt(d / 4)
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, by_distance);
    glPointSize(16);
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    const auto columns = [] {
        int n = 0;
        const Picture got = picture();
        for (std::size_t x = 0; x < size; ++x)
            n += got[24 * size + x][0] != 0 ? 1 : 0;
        return n;
    };
    glBegin(GL_TRIANGLES);
    glVertex2f(16, 24.5f), glVertex2f(200, 500), glVertex2f(200, 490);
    glEnd();
    EXPECT_EQ(columns(), static_cast<int>(std::lround(16 / std::sqrt(std::hypot(16, 24.5) / 4))));
    clear();
    glBegin(GL_TRIANGLES); // the window cuts the right side at (48, 24.5)
    glVertex2f(24, 400), glVertex2f(24, 24.5f), glVertex2f(148, 24.5f);
    glEnd();
    const int left = static_cast<int>(std::lround(16 / std::sqrt(std::hypot(24, 24.5) / 4))),
              right = static_cast<int>(std::lround(16 / std::sqrt(std::hypot(48, 24.5) / 4)));
    EXPECT_EQ(columns(), left + right / 2);
}

/// On a surface with samples, small points are drawn in the threshold size, and fainter.
TEST_F(Points, SmallOnesFadeWhereThereAreSamples) {
    Target target(4);
    glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 8);
    glPointSize(4);
    glColor4f(1, 1, 1, 1);
    point(24, 24);
    EXPECT_NEAR(picture()[24 * size + 24][3], 255.0 / 4, 0.5);
    EXPECT_EQ(drawn_counts(), counts([](double x, double y) { return std::hypot(x - 24, y - 24) <= 4; }));
    glPointSize(8);
    point(24, 24);
    EXPECT_EQ(picture()[24 * size + 24][3], 255);
    glDisable(GL_MULTISAMPLE);
    glPointSize(4);
    clear();
    point(24, 24);
    EXPECT_EQ(picture()[24 * size + 24][3], 255);
}

/// Makes a texture of 64 x 64 texels whose colours tell their places.
void texels_of_place() {
    std::vector<GLubyte> texels;
    for (int t = 0; t < 64; ++t)
        for (int s = 0; s < 64; ++s)
            texels.insert(texels.end(), {static_cast<GLubyte>(4 * s), static_cast<GLubyte>(4 * t), 255});
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
}

/// s = 1/2 + (x + 1/2 - xw) / size for centres inside of the square; t likewise, or turned over (GL 2.0,
/// 3.3).
TEST_F(Points, SpritesAreImages) {
    Target target(0);
    texels_of_place();
    glEnable(GL_POINT_SPRITE);
    glEnable(GL_POINT_SMOOTH); // has no effect on point sprites
    glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
    glMatrixMode(GL_TEXTURE);
    glScalef(3, 5, 1); // the texture matrix does not apply to replaced coordinates
    glMatrixMode(GL_MODELVIEW);
    for (int n = 0; n < 200; ++n) {
        const bool low = n % 2 != 0;
        glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, low ? GL_LOWER_LEFT : GL_UPPER_LEFT);
        const double cx = place(), cy = place(), width = 1 + below(8 * 20) / 8.0;
        glPointSize(static_cast<GLfloat>(width));
        clear();
        point(static_cast<GLfloat>(cx), static_cast<GLfloat>(cy));
        const Picture got = picture();
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const double s = 0.5 + (x + 0.5 - cx) / width, up = 0.5 + (y + 0.5 - cy) / width;
                const double t = low ? up : 1 - up;
                const Rgba& pixel = got[static_cast<std::size_t>(y * size + x)];
                const bool inside = s >= 0 && s < 1 && up >= 0 && up < 1;
                ASSERT_EQ(pixel[2], inside ? 255 : 0) << n << " at " << x << ',' << y;
                const auto texel = [](double v) { return static_cast<int>(std::floor(v * 64)); };
                const auto clear_of = [](double v) { return std::abs(v * 64 - std::round(v * 64)) > 1e-3; };
                if (!inside || !clear_of(s) || !clear_of(t))
                    continue;
                ASSERT_EQ(pixel[0], 4 * texel(s)) << n << " at " << x << ',' << y;
                ASSERT_EQ(pixel[1], 4 * texel(t)) << n << " at " << x << ',' << y;
            }
    }
}

TEST_F(Points, UnitsThatReplaceNothingHaveTheVertexsCoordinates) {
    Target target(0);
    texels_of_place();
    glEnable(GL_POINT_SPRITE);
    glPointSize(6);
    glTexCoord2f(0.5f + 1 / 128.0f, 0.25f + 1 / 128.0f);
    point(24, 24);
    for (std::size_t y = 21; y < 27; ++y)
        for (std::size_t x = 21; x < 27; ++x)
            ASSERT_EQ(picture()[y * size + x], (Rgba{128, 64, 255, 255}));
    GLint replaced = 7;
    glGetTexEnviv(GL_POINT_SPRITE, GL_COORD_REPLACE, &replaced);
    EXPECT_EQ(replaced, 0);
    glActiveTexture(GL_TEXTURE1);
    glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
    texels_of_place();
    point(24, 24);
    EXPECT_EQ(picture()[26 * size + 21][0], 4 * 5); // the texel of the second unit: (0.5 + (-2.5) / 6) 64
    glGetTexEnviv(GL_POINT_SPRITE, GL_COORD_REPLACE, &replaced);
    EXPECT_EQ(replaced, 1);
    glActiveTexture(GL_TEXTURE0);
    glGetTexEnviv(GL_POINT_SPRITE, GL_COORD_REPLACE, &replaced);
    EXPECT_EQ(replaced, 0);
}

TEST_F(Points, SpritesOfSamplesAreSquares) {
    Target target(4);
    glEnable(GL_POINT_SPRITE);
    for (int n = 0; n < 100; ++n) {
        const double cx = place(), cy = place(), half = (1 + below(80) / 8.0) / 2;
        glPointSize(static_cast<GLfloat>(2 * half));
        clear();
        point(static_cast<GLfloat>(cx), static_cast<GLfloat>(cy));
        ASSERT_EQ(drawn_counts(), counts([&](double x, double y) {
                      return x >= cx - half && x < cx + half && y >= cy - half && y < cy + half;
                  }))
            << n;
    }
}

TEST_F(Points, StateAndErrors) {
    Target target(0);
    const GLfloat abc[] = {1.5f, 0.25f, -3};
    glPushAttrib(GL_POINT_BIT);
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, abc);
    glPointParameteri(GL_POINT_SIZE_MIN, 3);
    glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 2.5f);
    glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT);
    glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
    glEnable(GL_POINT_SPRITE);
    for (const GLenum name : {GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX, GL_POINT_FADE_THRESHOLD_SIZE}) {
        glPointParameterf(name, -1);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_VALUE});
    }
    glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_NEAREST);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    glPointParameteri(GL_POINT_SIZE, 1);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    glTexEnvi(GL_TEXTURE_ENV, GL_COORD_REPLACE, GL_TRUE);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    glTexEnvi(GL_POINT_SPRITE, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    const auto value = [](GLenum name) {
        GLfloat v[3] = {-9, -9, -9};
        glGetFloatv(name, v);
        return std::vector<GLfloat>(v, v + (name == GL_POINT_DISTANCE_ATTENUATION ? 3 : 1));
    };
    EXPECT_EQ(value(GL_POINT_DISTANCE_ATTENUATION), std::vector<GLfloat>(abc, abc + 3));
    EXPECT_EQ(value(GL_POINT_SIZE_MIN)[0], 3);
    EXPECT_EQ(value(GL_POINT_SIZE_MAX)[0], 64);
    EXPECT_EQ(value(GL_POINT_FADE_THRESHOLD_SIZE)[0], 2.5f);
    EXPECT_EQ(value(GL_POINT_SPRITE_COORD_ORIGIN)[0], GL_LOWER_LEFT);
    glPopAttrib();
    EXPECT_EQ(value(GL_POINT_DISTANCE_ATTENUATION), (std::vector<GLfloat>{1, 0, 0}));
    EXPECT_EQ(value(GL_POINT_SIZE_MIN)[0], 0);
    EXPECT_EQ(value(GL_POINT_FADE_THRESHOLD_SIZE)[0], 1);
    EXPECT_EQ(value(GL_POINT_SPRITE_COORD_ORIGIN)[0], GL_UPPER_LEFT);
    EXPECT_EQ(glIsEnabled(GL_POINT_SPRITE), GL_FALSE);
    GLint replaced = 7;
    glGetTexEnviv(GL_POINT_SPRITE, GL_COORD_REPLACE, &replaced);
    EXPECT_EQ(replaced, 0);
}

} // namespace
} // namespace spangle::test::samples

#endif

// Row G16: tests the operations beside fragments that read and write the multisample buffer.
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_MULTISAMPLE

#include "tests/gl/raster/multisample.hpp"

namespace spangle::test::samples {
namespace {

/// Operations that read colours read the mean of the samples. Depths and stencil values are those of the
/// first sample.
TEST_F(Multisample, EveryoneReadsWhatWasResolved) {
    Target target(4);
    const auto half = [](GLint left) { // covers 0.4 of column `left + 1`, which are two samples
        glColor3ub(200, 100, 40);
        glRectf(static_cast<GLfloat>(left), 4, static_cast<GLfloat>(left) + 1.4f, 8);
    };
    half(4);
    const Rgba half_covered = {100, 50, 20, 128};
    EXPECT_EQ(picture()[6 * size + 5], half_covered);
    half(14);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 14, 5, 2, 2);
    std::array<Rgba, 4> texels{};
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    EXPECT_EQ(texels[0], (Rgba{200, 100, 40, 255}));
    EXPECT_EQ(texels[1], half_covered);
    half(24);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 24, 5, 2, 2, 0);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    EXPECT_EQ(texels[3], half_covered);
    half(34);
    glRasterPos2i(34, 20);
    glCopyPixels(34, 4, 2, 4, GL_COLOR);
    EXPECT_EQ(picture()[22 * size + 35], half_covered);
    EXPECT_EQ(picture()[22 * size + 34], (Rgba{200, 100, 40, 255}));
}

TEST_F(Multisample, PixelsOverlapTheirCopy) {
    Target target(4);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    for (int x = 0; x < 20; ++x) {
        glColor3ub(static_cast<GLubyte>(10 * x), 7, 9);
        glBegin(GL_QUADS);
        for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {1, 9}, {0, 9}})
            glVertex3f(static_cast<GLfloat>(x + i), static_cast<GLfloat>(j), -static_cast<GLfloat>(x) / 64);
        glEnd();
    }
    glRasterPos2i(3, 0);
    glDisable(GL_DEPTH_TEST);
    glCopyPixels(0, 0, 20, 9, GL_COLOR);
    glEnable(GL_DEPTH_TEST);
    GLubyte row[23][3];
    glReadPixels(0, 4, 23, 1, GL_RGB, GL_UNSIGNED_BYTE, row);
    for (int x = 3; x < 23; ++x)
        EXPECT_EQ(row[x][0], 10 * (x - 3)) << x;
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glCopyPixels(0, 0, 20, 9, GL_DEPTH);
    // Every sample got the copied depth: a primitive half a step nearer is visible in all of them.
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_LESS);
    for (int x = 3; x < 20; ++x) {
        glColor3ub(255, 255, 255);
        glBegin(GL_QUADS);
        for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {1, 9}, {0, 9}})
            glVertex3f(static_cast<GLfloat>(x + i), static_cast<GLfloat>(j),
                       -(static_cast<GLfloat>(x - 3) - 0.5f) / 64);
        glEnd();
    }
    const Picture got = picture();
    for (std::size_t x = 4; x < 20; ++x)
        EXPECT_EQ(got[4 * size + x][0], 255) << x;
}

TEST_F(Multisample, StencilImagesReachEverySample) {
    Target target(4);
    const GLubyte values[] = {1, 2, 3, 4};
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glRasterPos2i(8, 8);
    glPixelZoom(4, 4);
    glDrawPixels(2, 2, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, values);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 3, 0xFF);
    glRecti(0, 0, size, size);
    EXPECT_EQ(drawn_counts(),
              counts([](double x, double y) { return x >= 8 && x < 12 && y >= 12 && y < 16; }));
    GLubyte stencil = 0;
    glReadPixels(9, 13, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &stencil);
    EXPECT_EQ(stencil, 3);
}

TEST_F(Multisample, AccumulationReadsMeansAndWritesAllSamples) {
    HeadlessGl gl(size, size, {EGL_SAMPLES, 4}, {EGL_ACCUM_SIZE_SPANGLE, 16});
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, size, 0, size, 0, 1);
    glDisable(GL_DITHER);
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3ub(200, 100, 40);
    glRectf(4, 4, 5.4f, 8);
    glAccum(GL_LOAD, 0.5f);
    glAccum(GL_ACCUM, 0.25f);
    glClear(GL_COLOR_BUFFER_BIT);
    glAccum(GL_RETURN, 1);
    EXPECT_EQ(picture()[6 * size + 4], (Rgba{150, 75, 30, 191}));
    EXPECT_EQ(picture()[6 * size + 5], (Rgba{75, 37, 15, 96}));
    glColor3ub(0, 0, 0); // only one sample changes
    glEnable(GL_SAMPLE_COVERAGE);
    glSampleCoverage(0.25f, GL_FALSE);
    glRecti(0, 0, size, size);
    EXPECT_EQ(picture()[6 * size + 4][0], 113);
}

TEST_F(Multisample, StateSaysHowManySamplesThereAre) {
    for (const int samples : {0, 4}) {
        Target target(samples);
        GLint buffers = -1, n = -1;
        glGetIntegerv(GL_SAMPLE_BUFFERS, &buffers);
        glGetIntegerv(GL_SAMPLES, &n);
        EXPECT_EQ(buffers, samples / 4);
        EXPECT_EQ(n, samples);
    }
}

} // namespace
} // namespace spangle::test::samples

#endif

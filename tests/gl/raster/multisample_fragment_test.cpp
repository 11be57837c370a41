// Rows D15, G05, G16: compares samples with pictures of one sample each, for which the window is moved.
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_MULTISAMPLE

#include "tests/gl/raster/multisample.hpp"

namespace spangle::test::samples {
namespace {

TEST_F(Multisample, PolygonsAreTheMeanOfFourPictures) {
    for (std::uint32_t n = 0; n < 60; ++n) {
        const auto seeded = [n, this](const Draw& draw) {
            return [n, draw, this] {
                random_.seed(n);
                draw();
            };
        };
        const auto states = [this] {
            constexpr GLenum equal[] = {GL_LESS, GL_LEQUAL, GL_GREATER, GL_ALWAYS, GL_NOTEQUAL};
            constexpr GLenum ops[] = {GL_KEEP, GL_INCR, GL_INVERT, GL_DECR_WRAP, GL_REPLACE};
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(equal[below(5)]);
            if (below(2) != 0) {
                glEnable(GL_STENCIL_TEST);
                glStencilFunc(equal[below(5)], static_cast<GLint>(below(4)), 3);
                const GLenum fail = ops[below(5)], zfail = ops[below(5)], zpass = ops[below(5)];
                glStencilOp(fail, zfail, zpass);
            }
            if (below(2) != 0) {
                glEnable(GL_BLEND);
                glBlendFunc(GL_SRC_ALPHA, below(2) != 0 ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
            } else if (below(4) == 0) {
                glEnable(GL_COLOR_LOGIC_OP);
                glLogicOp(GL_CLEAR + below(16));
            }
            if (below(4) == 0) {
                glEnable(GL_ALPHA_TEST);
                glAlphaFunc(GL_GREATER, 0.4f);
            }
            if (below(4) == 0)
                glShadeModel(GL_FLAT);
            if (below(4) == 0) {
                glEnable(GL_SCISSOR_TEST);
                glScissor(7, 5, 30, 33);
            }
            if (below(4) == 0) {
                glEnable(GL_CULL_FACE);
                glFrontFace(below(2) != 0 ? GL_CW : GL_CCW);
            }
            if (below(4) == 0) {
                glEnable(GL_POLYGON_OFFSET_FILL);
                glPolygonOffset(1, 40);
            }
            if (below(3) == 0) {
                GLubyte texels[8 * 8 * 4];
                for (GLubyte& t : texels)
                    t = static_cast<GLubyte>(below(256));
                glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
                glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
                glEnable(GL_TEXTURE_2D);
            }
            if (below(4) == 0)
                glColorMask(below(2) != 0, below(2) != 0, true, true);
            triangles(6);
            if (below(2) != 0) { // masks some of the samples
                glEnable(GL_SCISSOR_TEST);
                glScissor(10, 12, 20, 9);
                glClearColor(0.3f, 0.6f, 0.9f, 0.5f);
                glClear(GL_COLOR_BUFFER_BIT | (below(2) != 0 ? GL_DEPTH_BUFFER_BIT : 0));
                glDisable(GL_SCISSOR_TEST);
                triangles(3);
            }
            glDisable(GL_ALPHA_TEST); // pixels of a rectangle of pixels are squares
            glDisable(GL_TEXTURE_2D);
            const GLubyte pixels[2 * 2 * 4] = {200, 10, 60, 255, 0, 255, 9, 80, 255, 255, 0, 0, 1, 2, 3, 255};
            glRasterPos3f(17.25f, 20.5f, -0.4f);
            glPixelZoom(3.3f, 5.1f);
            glDrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
        };
        expect_mean(seeded(states), ("states " + std::to_string(n)).c_str());
        if (HasFatalFailure())
            return;
    }
}

/// On dithered surfaces of 16 bits, each sample is stored as a pixel of the surface is.
TEST_F(Multisample, DitheredWordsAreMeans) {
    const Draw draw = [this] {
        random_.seed(5);
        glEnable(GL_DITHER);
        glEnable(GL_DEPTH_TEST);
        triangles(8);
    };
    std::vector<std::uint16_t> got(size * size), one(size * size);
    const auto read = [](std::vector<std::uint16_t>& to) {
        glReadPixels(0, 0, size, size, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, to.data());
    };
    const auto with = [&](int samples, const Draw& first) {
        Target target(samples,
                      {EGL_ALPHA_SIZE, 0, EGL_BUFFER_SIZE, 16, EGL_STENCIL_SIZE, 0, EGL_DEPTH_SIZE, 16});
        first();
        draw();
        GLint bits = 0;
        glGetIntegerv(GL_GREEN_BITS, &bits);
        EXPECT_EQ(bits, 6);
        read(samples != 0 ? got : one);
    };
    with(4, [] {});
    std::vector<std::array<int, 3>> sum(size * size);
    for (unsigned s = 0; s < raster::sample_count; ++s) {
        with(0, [s] {
            glMatrixMode(GL_PROJECTION);
            glTranslated(0.5 - offset(s, false), 0.5 - offset(s, true), 0);
        });
        for (std::size_t p = 0; p < one.size(); ++p) {
            sum[p][0] += one[p] >> 11;
            sum[p][1] += one[p] >> 5 & 63;
            sum[p][2] += one[p] & 31;
        }
    }
    for (std::size_t p = 0; p < got.size(); ++p)
        ASSERT_EQ(got[p], (sum[p][0] + 2) / 4 << 11 | (sum[p][1] + 2) / 4 << 5 | (sum[p][2] + 2) / 4) << p;
}

/// With MULTISAMPLE off, every primitive is drawn as on a surface without samples, antialiasing included.
TEST_F(Multisample, OffIsASingleSample) {
    const Draw scenes[] = {
        [this] {
            for (int i = 0; i < 20; ++i) {
                random_color();
                glPointSize(static_cast<GLfloat>(1 + below(7)));
                glLineWidth(static_cast<GLfloat>(1 + below(4)));
                const GLfloat x = place(), y = place();
                glBegin(i % 2 != 0 ? GL_POINTS : GL_LINES);
                glVertex2f(x, y);
                glVertex2f(place(), place());
                glEnd();
            }
        },
        [this] { triangles(9); },
        [this] {
            glEnable(GL_LINE_STIPPLE);
            glLineStipple(2, 0x5A3C);
            glPolygonMode(GL_FRONT, GL_LINE);
            glPolygonMode(GL_BACK, GL_POINT);
            triangles(5);
        },
        [this] {
            glEnable(GL_BLEND);
            glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
            for (const GLenum on : {GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH, GL_LINE_STIPPLE})
                glEnable(on);
            glLineStipple(1, 0x33F1);
            glLineWidth(2.5f);
            glPointSize(5.5f);
            triangles(3);
            glBegin(GL_LINE_STRIP);
            for (int i = 0; i < 5; ++i) {
                const GLfloat x = place(), y = place();
                glVertex2f(x, y);
            }
            glEnd();
            glBegin(GL_POINTS);
            const GLfloat x = place(), y = place();
            glVertex2f(x, y);
            glEnd();
        },
        [] { // alpha says nothing about the coverage
            for (const GLenum on : {GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE})
                glEnable(on);
            glSampleCoverage(0.25f, GL_TRUE);
            glColor4f(1, 0.5f, 0.25f, 0.3f);
            glRectf(4.3f, 5.4f, 40.2f, 30.7f);
        },
        [] {
            const GLubyte bits[] = {0xA5, 0xFF, 0x3C, 0x81};
            glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
            glRasterPos2f(11.8f, 13.3f);
            glBitmap(8, 4, 0.5f, 0.25f, 0, 0, bits);
        }};
    for (const Draw& scene : scenes) {
        const auto drawn = [&](int samples) {
            Target target(samples);
            glDisable(GL_MULTISAMPLE);
            random_.seed(3);
            scene();
            return picture();
        };
        ASSERT_EQ(drawn(4), drawn(0)) << &scene - scenes;
    }
}

/// Alpha covers 4 alpha samples of each pixel, rounded up or down so that sixteen pixels show alpha to 1/64.
TEST_F(Multisample, AlphaIsTurnedIntoCoverage) {
    Target target(4);
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    for (int alpha = 0; alpha <= 255; ++alpha) {
        glClear(GL_COLOR_BUFFER_BIT);
        glColor4ub(255, 255, 255, static_cast<GLubyte>(alpha));
        glRecti(0, 0, size, size);
        const std::vector<int> got = drawn_counts();
        for (const int n : got) {
            ASSERT_GE(n, alpha * 4 / 255);
            ASSERT_LE(n, (alpha * 4 + 254) / 255);
        }
        int block = 0;
        for (std::size_t p = 0; p < 16; ++p)
            block += got[size * (8 + p / 4) + 20 + p % 4];
        ASSERT_NEAR(block, 64.0 * alpha / 255, 0.5) << alpha;
    }
}

TEST_F(Multisample, AlphaToOneFollowsItsCoverage) {
    Target target(4);
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glEnable(GL_SAMPLE_ALPHA_TO_ONE);
    glColor4f(1, 1, 1, 0.5f);
    glRecti(0, 0, size, size);
    for (const Rgba& pixel : picture()) {
        ASSERT_EQ(pixel[0], 128); // two of four samples have the colour
        ASSERT_EQ(pixel[3], 128); // these two have alpha 1
    }
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glEnable(GL_ALPHA_TEST); // tests the new alpha
    glAlphaFunc(GL_EQUAL, 1);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ZERO);
    glRecti(0, 0, size, size);
    for (const Rgba& pixel : picture())
        ASSERT_EQ(pixel, (Rgba{255, 255, 255, 255}));
}

TEST_F(Multisample, AValueAndItsInverseCoverEverySampleOnce) {
    Target target(4);
    glEnable(GL_SAMPLE_COVERAGE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glColor3ub(100, 100, 100);
    for (int step = 0; step <= 16; ++step) {
        const GLfloat value = static_cast<GLfloat>(step) / 16;
        glClear(GL_COLOR_BUFFER_BIT);
        glSampleCoverage(value, GL_FALSE);
        glRecti(0, 0, size, size);
        double sum = 0;
        for (const Rgba& pixel : picture())
            sum += pixel[0];
        EXPECT_NEAR(sum / (size * size), 100 * value, 0.8) << value; // values are rounded to 255ths
        glSampleCoverage(value, GL_TRUE);
        glRecti(0, 0, size, size);
        for (const Rgba& pixel : picture())
            ASSERT_EQ(pixel[0], 100) << value;
    }
    // A sample must be in both coverages, and the alpha test applies to the remaining samples.
    glDisable(GL_BLEND);
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glClear(GL_COLOR_BUFFER_BIT);
    glSampleCoverage(0.5f, GL_TRUE);
    glColor4f(1, 1, 1, 0.5f);
    glRecti(0, 0, size, size);
    EXPECT_THAT(picture(), testing::Each(Rgba{0, 0, 0, 0}));
}

/// A sample that is not covered keeps its depth and stencil value.
TEST_F(Multisample, WhatIsNotCoveredIsNotTested) {
    Target target(4);
    glEnable(GL_SAMPLE_COVERAGE);
    glSampleCoverage(0.5f, GL_FALSE);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_INCR, GL_INCR, GL_INCR);
    glColor3f(1, 0, 0);
    const auto rectangle = [](GLfloat depth) {
        glBegin(GL_QUADS);
        for (const auto& [x, y] : {std::pair{0, 0}, {size, 0}, {size, size}, {0, size}})
            glVertex3f(static_cast<GLfloat>(x), static_cast<GLfloat>(y), -depth);
        glEnd();
    };
    rectangle(0.25f);
    glDisable(GL_SAMPLE_COVERAGE);
    glColor3f(0, 1, 0);
    glStencilFunc(GL_EQUAL, 0, 0xFF);
    rectangle(0.5f); // this one lies behind the first rectangle
    EXPECT_THAT(picture(), testing::Each(Rgba{128, 128, 0, 255}));
}

TEST_F(Multisample, QueriesCountSamples) {
    Target target(4);
    const auto count = [](auto draw) {
        glBeginQuery(GL_SAMPLES_PASSED, 1);
        draw();
        glEndQuery(GL_SAMPLES_PASSED);
        GLuint n = 0;
        glGetQueryObjectuiv(1, GL_QUERY_RESULT, &n);
        return n;
    };
    const auto triangle = [] {
        glBegin(GL_TRIANGLES);
        glVertex2f(3.5f, 4.25f), glVertex2f(40, 11), glVertex2f(14, 33.5f);
        glEnd();
    };
    GLuint inside = 0;
    for (const int n : counts([](double x, double y) { return holds({3.5, 4.25, 40, 11, 14, 33.5}, x, y); }))
        inside += static_cast<GLuint>(n);
    EXPECT_EQ(count(triangle), inside);
    EXPECT_EQ(count([] { glRecti(10, 10, 20, 20); }), 400u);
    glEnable(GL_SAMPLE_COVERAGE);
    glSampleCoverage(0.25f, GL_FALSE);
    EXPECT_EQ(count([] { glRecti(10, 10, 20, 20); }), 100u);
    glDisable(GL_MULTISAMPLE); // a fragment covers all of its samples
    EXPECT_EQ(count([] { glRecti(10, 10, 20, 20); }), 400u);
}

} // namespace
} // namespace spangle::test::samples

#endif

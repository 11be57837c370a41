// Rows D15, G05, G16: four samples of each pixel, against brute force at their positions and against pictures
// of one sample each, the window moved.
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "raster/surface/samples.hpp"
#include "tests/gl_raster/window.hpp"
#include "tests/primitive/clipped_area.hpp"

namespace spangle::test {
namespace {

constexpr int size = 48;
using Picture = std::vector<Rgba>;
using Draw = std::function<void()>;

/// A context with the samples given, object coordinates are pixels.
struct Target {
    HeadlessGl gl;
    explicit Target(int samples, std::initializer_list<EGLint> more = {})
        : gl(size, size, with(samples, more)) {
        glMatrixMode(GL_PROJECTION);
        glOrtho(0, size, 0, size, 0, 1); // z = -depth
        glMatrixMode(GL_MODELVIEW);
        glDisable(GL_DITHER);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    ~Target() { EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}); }

  private:
    static std::vector<EGLint> with(int samples, std::initializer_list<EGLint> more) {
        std::vector<EGLint> all = {EGL_STENCIL_SIZE, 8, EGL_SAMPLES, samples};
        all.insert(all.end(), more);
        return all;
    }
};

Picture picture() {
    Picture pixels(size * size);
    glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
}

double offset(unsigned sample, bool y) {
    const raster::SamplePosition& at = raster::sample_position[sample];
    return (y ? at.y : at.x) / 256.0;
}

/// What `inside` says of each sample, as a picture in white.
template <class Inside> std::vector<int> counts(Inside inside) {
    std::vector<int> all(size * size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            for (unsigned s = 0; s < raster::sample_count; ++s)
                all[static_cast<std::size_t>(y * size + x)] +=
                    inside(x + offset(s, false), y + offset(s, true)) ? 1 : 0;
    return all;
}
std::vector<int> drawn_counts() {
    std::vector<int> all;
    for (const Rgba& pixel : picture())
        all.push_back((pixel[0] * 4 + 127) / 255);
    return all;
}

class Multisample : public testing::Test {
  protected:
    std::mt19937 random_{11};
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
    double lot(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    GLfloat place() { return static_cast<GLfloat>(below(size * 256)) / 256; }

    /// The same in a surface with samples, and in four without, the window moved for each: their mean.
    void expect_mean(const Draw& draw, const char* what, std::initializer_list<EGLint> more = {}) {
        Picture got;
        {
            Target target(4, more);
            draw();
            got = picture();
        }
        std::vector<std::array<int, 4>> sum(size * size);
        for (unsigned s = 0; s < raster::sample_count; ++s) {
            Target target(0, more);
            glMatrixMode(GL_PROJECTION);
            glTranslated(0.5 - offset(s, false), 0.5 - offset(s, true), 0);
            glMatrixMode(GL_MODELVIEW);
            draw();
            const Picture one = picture();
            for (std::size_t p = 0; p < one.size(); ++p)
                for (unsigned c = 0; c < 4; ++c)
                    sum[p][c] += one[p][c];
        }
        for (std::size_t p = 0; p < got.size(); ++p)
            for (unsigned c = 0; c < 4; ++c)
                ASSERT_EQ(got[p][c], (sum[p][c] + 2) / 4)
                    << what << " at " << p % size << ',' << p / size << " channel " << c;
    }

    void random_color() {
        const auto c = [&] { return static_cast<GLubyte>(below(4) == 0 ? 255 * below(2) : below(256)); };
        const GLubyte r = c(), g = c(), b = c(), a = c();
        glColor4ub(r, g, b, a);
    }
    void triangles(int n) {
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < 3 * n; ++i) {
            random_color();
            const GLfloat x = place(), y = place();
            glTexCoord2f(x / 16, y / 16);
            glVertex3f(x, y, -static_cast<GLfloat>(below(257)) / 256);
        }
        glEnd();
    }
};

/// The rule of edges (GL 1.3, 3.5.1): those at the left and below are inside.
bool holds(const std::array<double, 6>& t, double x, double y) {
    const double area = (t[2] - t[0]) * (t[5] - t[1]) - (t[4] - t[0]) * (t[3] - t[1]);
    for (unsigned i = 0; i < 3; ++i) {
        const unsigned a = 2 * i, b = 2 * ((i + 1) % 3);
        const double dx = (t[b] - t[a]) * (area < 0 ? -1 : 1),
                     dy = (t[b + 1] - t[a + 1]) * (area < 0 ? -1 : 1);
        const double side = dx * (y - t[a + 1]) - dy * (x - t[a]);
        if (side < 0 || (side == 0 && !(dy < 0 || (dy == 0 && dx > 0))))
            return false;
    }
    return area != 0;
}

TEST_F(Multisample, TrianglesCoverTheSamplesInside) {
    Target target(4);
    for (int n = 0; n < 500; ++n) {
        std::array<double, 6> t;
        for (double& v : t) // every other on samples' rows and columns
            v = n % 2 != 0 ? place() : below(size * 8) / 8.0;
        glClear(GL_COLOR_BUFFER_BIT);
        glBegin(GL_TRIANGLES);
        for (unsigned i = 0; i < 3; ++i)
            glVertex2d(t[2 * i], t[2 * i + 1]);
        glEnd();
        ASSERT_EQ(drawn_counts(), counts([&](double x, double y) { return holds(t, x, y); })) << n;
    }
}

TEST_F(Multisample, PointsAreDiscs) {
    Target target(4);
    for (int n = 0; n < 300; ++n) {
        const double cx = place(), cy = place(), width = 1 + below(12 * 8) / 8.0;
        glClear(GL_COLOR_BUFFER_BIT);
        glPointSize(static_cast<GLfloat>(width));
        if (n % 2 != 0) // no matter
            glEnable(GL_POINT_SMOOTH);
        glBegin(GL_POINTS);
        glVertex2d(cx, cy);
        glEnd();
        ASSERT_EQ(drawn_counts(), counts([&](double x, double y) {
                      return (x - cx) * (x - cx) + (y - cy) * (y - cy) <= width * width / 4;
                  }))
            << n;
    }
}

/// A rectangle's corners are snapped: samples that close to its edge may be on either side.
void expect_rectangles(const std::vector<oracle::Polygon>& parts, const std::vector<int>& got, int trial) {
    constexpr double snap = 1.0 / 256;
    const auto count = [&](double margin) {
        return counts([&](double x, double y) {
            return std::any_of(parts.begin(), parts.end(), [&](const oracle::Polygon& part) {
                double least = 1e9;
                for (std::size_t i = 0; i < part.size(); ++i) {
                    const oracle::Point &a = part[i], &b = part[(i + 1) % part.size()];
                    const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
                    least = std::min(least, (dx * (y - a.y) - dy * (x - a.x)) / length);
                }
                return least >= margin;
            });
        });
    };
    const std::vector<int> inner = count(snap), outer = count(-snap);
    for (std::size_t p = 0; p < got.size(); ++p) {
        ASSERT_GE(got[p], inner[p]) << trial << " at " << p % size << ',' << p / size;
        ASSERT_LE(got[p], outer[p]) << trial << " at " << p % size << ',' << p / size;
    }
}

TEST_F(Multisample, LinesAreRectangles) {
    Target target(4);
    for (int n = 0; n < 300; ++n) {
        const double ax = place(), ay = place(), bx = place(), by = place(), width = 1 + below(9 * 8) / 8.0;
        glLineWidth(static_cast<GLfloat>(width));
        if (n % 2 != 0) // no matter
            glEnable(GL_LINE_SMOOTH);
        const unsigned pattern = below(0x10000), factor = 1 + below(4);
        const bool stippled = n % 3 == 0;
        stippled ? glEnable(GL_LINE_STIPPLE) : glDisable(GL_LINE_STIPPLE);
        glLineStipple(static_cast<GLint>(factor), static_cast<GLushort>(pattern));
        glClear(GL_COLOR_BUFFER_BIT);
        glBegin(GL_LINES);
        glVertex2d(ax, ay);
        glVertex2d(bx, by);
        glEnd();
        std::vector<oracle::Polygon> parts;
        const double length = std::hypot(bx - ax, by - ay);
        const auto at = [&](double t) { return oracle::Point{ax + t * (bx - ax), ay + t * (by - ay)}; };
        for (unsigned i = 0; i < length; i += stippled ? 1 : size * 2)
            if (!stippled || (pattern >> (i / factor % 16) & 1) != 0)
                parts.push_back(oracle::rectangle(at(i / length),
                                                  at(stippled ? std::min(1.0, (i + 1) / length) : 1), width));
        expect_rectangles(parts, drawn_counts(), n);
    }
}

/// Parts of a strip's pattern partition it: two complements draw every sample once.
TEST_F(Multisample, StippleRunsOnAlongAStrip) {
    Target target(4);
    glEnable(GL_LINE_STIPPLE);
    glLineWidth(3);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    for (int n = 0; n < 40; ++n) {
        GLfloat v[4];
        for (GLfloat& c : v)
            c = place();
        const unsigned pattern = below(0x10000);
        const auto strip = [&](unsigned bits) {
            glLineStipple(3, static_cast<GLushort>(bits));
            glBegin(GL_LINE_STRIP);
            glVertex2f(v[0], v[1]);
            glVertex2f((v[0] + v[2]) / 2, (v[1] + v[3]) / 2);
            glVertex2f(v[2], v[3]);
            glEnd();
        };
        const auto drawn = [&](auto draw) {
            glClear(GL_COLOR_BUFFER_BIT);
            glColor3f(0.25f, 0.25f, 0.25f);
            draw();
            return picture();
        };
        const Picture whole = drawn([&] { strip(0xFFFF); });
        ASSERT_EQ(drawn([&] { strip(pattern), strip(~pattern); }), whole) << n;
    }
}

TEST_F(Multisample, LinesHaveColoursAlongThemAndNotAcross) {
    Target target(4);
    glLineWidth(8);
    glBegin(GL_LINES);
    glColor3f(0, 0, 1);
    glVertex3f(4, 24, 0);
    glColor3f(1, 0, 1);
    glVertex3f(44, 24, -1);
    glEnd();
    const Picture got = picture();
    GLfloat depth = 0;
    for (int x = 4; x < 44; ++x) {
        for (int y = 20; y < 28; ++y) {
            const Rgba& pixel = got[static_cast<std::size_t>(y * size + x)];
            EXPECT_NEAR(pixel[0], 255 * (x + 0.5 - 4) / 40, 1.5) << x << ',' << y;
            EXPECT_EQ(pixel[2], 255);
        }
    }
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glBegin(GL_LINES);
    glVertex3f(4, 24, 0);
    glVertex3f(44, 24, -1);
    glEnd();
    glReadPixels(33, 24, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    EXPECT_NEAR(depth, (33 + offset(0, false) - 4) / 40, 1e-4); // that of the first sample
}

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
            if (below(2) != 0) { // masked, in a part
                glEnable(GL_SCISSOR_TEST);
                glScissor(10, 12, 20, 9);
                glClearColor(0.3f, 0.6f, 0.9f, 0.5f);
                glClear(GL_COLOR_BUFFER_BIT | (below(2) != 0 ? GL_DEPTH_BUFFER_BIT : 0));
                glDisable(GL_SCISSOR_TEST);
                triangles(3);
            }
            glDisable(GL_ALPHA_TEST); // a rectangle of pixels is one of squares
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

/// Sixteen bits, dithered: each sample is stored as a pixel of the surface is.
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

/// MULTISAMPLE off: every primitive is what it is on a surface without samples, antialiasing included.
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
        [] { // alpha says nothing of coverage
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

/// 4 alpha samples of each pixel, rounded up or down so that sixteen pixels show alpha to 1/64.
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
        ASSERT_EQ(pixel[0], 128); // two samples
        ASSERT_EQ(pixel[3], 128); // of alpha 1
    }
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glEnable(GL_ALPHA_TEST); // sees it
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
        EXPECT_NEAR(sum / (size * size), 100 * value, 0.8) << value; // rounded to 255ths
        glSampleCoverage(value, GL_TRUE);
        glRecti(0, 0, size, size);
        for (const Rgba& pixel : picture())
            ASSERT_EQ(pixel[0], 100) << value;
    }
    // Both coverages must agree, and the alpha test looks at what is left.
    glDisable(GL_BLEND);
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glClear(GL_COLOR_BUFFER_BIT);
    glSampleCoverage(0.5f, GL_TRUE);
    glColor4f(1, 1, 1, 0.5f);
    glRecti(0, 0, size, size);
    EXPECT_THAT(picture(), testing::Each(Rgba{0, 0, 0, 0}));
}

/// A sample that is not covered leaves depth and stencil alone.
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
    rectangle(0.5f); // behind, where the first one was
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

/// Bits are squares from the raster position on.
TEST_F(Multisample, BitmapsCoverTheSamplesInTheirSquares) {
    Target target(4);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int n = 0; n < 200; ++n) {
        GLubyte bits[11];
        for (GLubyte& b : bits)
            b = static_cast<GLubyte>(below(256));
        const double x0 = 1 + below(30 * 256) / 256.0, y0 = 1 + below(30 * 256) / 256.0, ox = below(16) / 8.0,
                     oy = below(16) / 8.0;
        glClear(GL_COLOR_BUFFER_BIT);
        glRasterPos2d(x0, y0);
        glBitmap(8, 11, static_cast<GLfloat>(ox), static_cast<GLfloat>(oy), 0, 0, bits);
        ASSERT_EQ(drawn_counts(), counts([&](double x, double y) {
                      const int i = static_cast<int>(std::floor(x - (x0 - ox))),
                                j = static_cast<int>(std::floor(y - (y0 - oy)));
                      return i >= 0 && i < 8 && j >= 0 && j < 11 && (bits[j] >> (7 - i) & 1) != 0;
                  }))
            << n;
    }
}

/// What reads colours reads the mean of the samples; depths and stencil values are those of the first.
TEST_F(Multisample, EveryoneReadsWhatWasResolved) {
    Target target(4);
    const auto half = [](GLint left) { // two samples of column `left + 1`, 0.4 of it are covered
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
    // Every sample got them, not the first alone: what lies nearer by half a step is seen everywhere.
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
    glColor3ub(0, 0, 0); // a sample apart: the others are still there
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

/// A surface of the reference policy has samples, too, and covers the same.
TEST_F(Multisample, PoliciesCoverTheSame) {
    std::optional<std::vector<int>> first;
    for (const EGLint precision : {EGL_PRECISION_EXACT_SPANGLE, EGL_PRECISION_FAST_SPANGLE}) {
        Target target(4, {EGL_PRECISION_SPANGLE, precision});
        random_.seed(9);
        glLineWidth(2.5f);
        glPointSize(6);
        for (int i = 0; i < 5; ++i) {
            glBegin(i % 2 != 0 ? GL_LINE_LOOP : GL_POINTS);
            for (int k = 0; k < 3; ++k)
                glVertex2f(place(), place());
            glEnd();
        }
        const std::vector<int> got = drawn_counts();
        if (first.has_value()) {
            EXPECT_EQ(got, *first);
        }
        first = got;
    }
}

} // namespace
} // namespace spangle::test

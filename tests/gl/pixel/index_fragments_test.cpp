// Rows G24, D14, G19: tests fragments on a surface of colour indices, by the rules of GL 1.3 (2.13.6, 3.2,
// 3.10, 3.11, 4.1, 4.2).
#include "tests/gl/pixel/index_canvas.hpp"
#include "tests/unit/primitive/clipped_area.hpp"

namespace spangle::test {
namespace {

#if SPANGLE_FEATURE_COLOR_INDEX

class IndexFragments : public IndexCanvas {};

TEST_F(IndexFragments, TheModeAndItsBits) {
    const auto get = [](GLenum name) {
        GLint v = -1;
        glGetIntegerv(name, &v);
        return v;
    };
    EXPECT_EQ(get(GL_INDEX_MODE), 1);
    EXPECT_EQ(get(GL_RGBA_MODE), 0);
    EXPECT_EQ(get(GL_INDEX_BITS), 8);
    for (const GLenum name : {GL_RED_BITS, GL_GREEN_BITS, GL_BLUE_BITS, GL_ALPHA_BITS})
        EXPECT_EQ(get(name), 0);
    EXPECT_EQ(get(GL_DEPTH_BITS), 24);
}

/// Without dithering the nearest index is stored. With dithering the place decides between the two nearest;
/// whole indices stay.
TEST_F(IndexFragments, AreMaskedAndRounded) {
    for (const float index : {0.0f, 1.0f, 7.25f, 7.5f, 7.75f, 100.0f, 254.5f, 255.0f, 255.75f, 255.9995f,
                              256.0f, 300.25f, -1.0f, -0.75f, 65537.0f}) {
        glDisable(GL_DITHER);
        EXPECT_EQ(covered(index), nearest(index)) << index;
        glEnable(GL_DITHER);
        glIndexf(index);
        cover();
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                ASSERT_EQ(at(x, y), dithered(index, x, y)) << index << " at " << x << ' ' << y;
    }
}

/// Indices are interpolated over the whole range, with a fraction above the last index, in every tier.
TEST_F(IndexFragments, AreInterpolated) {
    for (const GLenum hint : {GL_NICEST, GL_DONT_CARE, GL_FASTEST})
        for (const bool dither : {false, true}) {
            const double low = 3, high = 255.75;
            glHint(GL_PERSPECTIVE_CORRECTION_HINT, hint);
            dither ? glEnable(GL_DITHER) : glDisable(GL_DITHER);
            glBegin(GL_QUADS);
            for (int i = 0; i < 4; ++i) {
                const bool right = i == 1 || i == 2;
                glIndexd(right ? high : low);
                glVertex2i(right ? size : 0, i >= 2 ? size : 0);
            }
            glEnd();
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const double index = low + (high - low) * (x + 0.5) / size;
                    ASSERT_EQ(at(x, y), dither ? dithered(index, x, y) : nearest(index)) << x << ' ' << y;
                }
        }
}

TEST_F(IndexFragments, OfFlatPrimitivesHaveTheProvokingOne) {
    glShadeModel(GL_FLAT);
    glBegin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
        glIndexi(10 * (i + 1));
        glVertex2i(i == 1 || i == 2 ? size : 0, i >= 2 ? size : 0);
    }
    glEnd();
    EXPECT_EQ(pixels(), std::vector<int>(size * size, 40));
}

/// In perspective, index / w is linear in the window (GL 1.3, equation 3.6).
TEST_F(IndexFragments, AreCorrectInPerspective) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1, 1, -1, 1, 1, 10);
    glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_NICEST);
    glBegin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
        const bool right = i == 1 || i == 2;
        const float w = right ? 8 : 2;
        glIndexi(right ? 255 : 5);
        glVertex3f(right ? w : -w, i >= 2 ? w : -w, -w);
    }
    glEnd();
    for (int x = 0; x < size; ++x) {
        const double t = (x + 0.5) / size, over = (1 - t) / 2 + t / 8;
        EXPECT_EQ(at(x, 3), nearest(((1 - t) * 5 / 2 + t * 255 / 8) / over)) << x;
    }
}

/// State of colours does not apply to indices: textures, the alpha test, blending, COLOR_LOGIC_OP, ColorMask.
TEST_F(IndexFragments, AreNotTreatedAsColours) {
    const GLubyte texel[4] = {1, 2, 3, 4};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    EXPECT_EQ(covered(77), 77);
    glAlphaFunc(GL_NEVER, 0);
    glEnable(GL_ALPHA_TEST);
    EXPECT_EQ(covered(78), 78);
    glBlendFunc(GL_ZERO, GL_ONE);
    glEnable(GL_BLEND);
    EXPECT_EQ(covered(79), 79);
    glLogicOp(GL_CLEAR);
    glEnable(GL_COLOR_LOGIC_OP);
    EXPECT_EQ(covered(80), 80);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    EXPECT_EQ(covered(81), 81);
    glColor4f(0, 0, 0, 0);
    EXPECT_EQ(covered(82), 82);
}

TEST_F(IndexFragments, PassTheOtherTests) {
    glEnable(GL_DEPTH_TEST);
    EXPECT_EQ(covered(10, 0.5f), 10);
    EXPECT_EQ(covered(11, -0.5f), 10) << "behind";
    EXPECT_EQ(covered(12, 0.75f), 12);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NEVER, 0, 0xFF);
    EXPECT_EQ(covered(13), 12);
    glDisable(GL_STENCIL_TEST);
    glDrawBuffer(GL_NONE);
    EXPECT_EQ(covered(14), 12);
    glDrawBuffer(GL_FRONT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(3, 4, 2, 1);
    glIndexi(15);
    cover();
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            ASSERT_EQ(at(x, y), (x == 3 || x == 4) && y == 4 ? 15 : 12);
}

/// Tests all sixteen logical operations, bit by bit, under masks. Only INDEX_LOGIC_OP enables them.
TEST_F(IndexFragments, LogicalOperationsAndMasks) {
    using Op = unsigned (*)(unsigned s, unsigned d);
    const Op ops[16] = {
        [](unsigned, unsigned) { return 0u; },           [](unsigned s, unsigned d) { return s & d; },
        [](unsigned s, unsigned d) { return s & ~d; },   [](unsigned s, unsigned) { return s; },
        [](unsigned s, unsigned d) { return ~s & d; },   [](unsigned, unsigned d) { return d; },
        [](unsigned s, unsigned d) { return s ^ d; },    [](unsigned s, unsigned d) { return s | d; },
        [](unsigned s, unsigned d) { return ~(s | d); }, [](unsigned s, unsigned d) { return ~(s ^ d); },
        [](unsigned, unsigned d) { return ~d; },         [](unsigned s, unsigned d) { return s | ~d; },
        [](unsigned s, unsigned) { return ~s; },         [](unsigned s, unsigned d) { return ~s | d; },
        [](unsigned s, unsigned d) { return ~(s & d); }, [](unsigned, unsigned) { return 0xFFu; }};
    for (GLenum i = 0; i < 16; ++i)
        for (const unsigned mask : {0xFFu, 0x0Fu, 0x5Au, 0x100u, 0u})
            for (const bool on : {false, true}) {
                const unsigned s = 0xCA, d = 0x9C;
                fill(d);
                glLogicOp(GL_CLEAR + i);
                on ? glEnable(GL_INDEX_LOGIC_OP) : glDisable(GL_INDEX_LOGIC_OP);
                glIndexMask(mask);
                const unsigned result = on ? ops[i](s, d) : s;
                EXPECT_EQ(covered(s), static_cast<int>((result & mask & 0xFF) | (d & ~mask)))
                    << i << " mask " << mask;
            }
}

/// The logical operation takes the dithered index (GL 1.3, 4.1.9).
TEST_F(IndexFragments, AreDitheredBeforeLogic) {
    fill(0xF0);
    glEnable(GL_DITHER);
    glEnable(GL_INDEX_LOGIC_OP);
    glLogicOp(GL_XOR);
    glIndexf(15.5f);
    cover();
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            ASSERT_EQ(at(x, y), dithered(15.5, x, y) ^ 0xF0);
}

/// On surfaces of colours, INDEX_LOGIC_OP and IndexMask have no effect.
TEST(ColorFragments, HaveNoIndexMask) {
    const HeadlessGl context(4, 4);
    glIndexMask(0);
    glLogicOp(GL_CLEAR);
    glEnable(GL_INDEX_LOGIC_OP);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glRecti(-1, -1, 1, 1);
    GLubyte rgba[4] = {};
    glReadPixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    EXPECT_EQ(std::vector<int>(rgba, rgba + 4), (std::vector<int>{255, 255, 255, 255}));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

/// ClearIndex masks the index and keeps its fraction. Dither, scissor and mask apply to the clear, the
/// logical operation does not.
TEST_F(IndexFragments, Clear) {
    for (const float index : {0.0f, 9.0f, 9.5f, 255.75f, 300.25f, -1.0f, 1e30f})
        for (const bool dither : {false, true})
            for (const unsigned mask : {0xFFu, 0x3Cu, 0u})
                for (const bool scissor : {false, true}) {
                    fill(0x66);
                    glClearIndex(index);
                    dither ? glEnable(GL_DITHER) : glDisable(GL_DITHER);
                    scissor ? glEnable(GL_SCISSOR_TEST) : glDisable(GL_SCISSOR_TEST);
                    glScissor(2, 5, 9, 7);
                    glIndexMask(mask);
                    glEnable(GL_INDEX_LOGIC_OP);
                    glLogicOp(GL_INVERT);
                    glClear(GL_COLOR_BUFFER_BIT);
                    for (int y = 0; y < size; ++y)
                        for (int x = 0; x < size; ++x) {
                            const bool inside = !scissor || (x >= 2 && x < 11 && y >= 5 && y < 12);
                            const unsigned v =
                                static_cast<unsigned>(dither ? dithered(index, x, y) : nearest(index));
                            const unsigned want = inside ? (v & mask) | (0x66 & ~mask) : 0x66;
                            ASSERT_EQ(at(x, y), static_cast<int>(want)) << index << ' ' << x << ' ' << y;
                        }
                }
}

#if SPANGLE_FEATURE_FOG
/// Fog gives I = i_r + (1 - f) i_f, and indices beyond the last are masked (GL 1.3, 3.10).
TEST_F(IndexFragments, Fog) {
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 0);
    glFogf(GL_FOG_END, 1);
    const struct {
        float index, fog, distance;
        int result;
    } cases[] = {{10, 100, 0, 10},   {10, 100, 0.5f, 60}, {10, 100, 1, 110},   {10, 356, 1, 110},
                 {200, 200, 1, 144}, {10, 5, 0.25f, 11},  {0, 255.5f, 1, 255}, {250, 8, 0.75f, 0},
                 {10, -1, 1, 9},     {10.5f, 1, 0.5f, 11}};
    for (const auto& c : cases) {
        glFogf(GL_FOG_INDEX, c.fog);
        EXPECT_EQ(covered(c.index, -c.distance), c.result)
            << c.index << " fog " << c.fog << " at " << c.distance;
    }
    glFogi(GL_FOG_MODE, GL_EXP);
    glFogf(GL_FOG_DENSITY, 2);
    glFogf(GL_FOG_INDEX, 100);
    EXPECT_EQ(covered(20, -0.5f), nearest(20 + (1 - std::exp(-1.0)) * 100));
    glFogi(GL_FOG_MODE, GL_EXP2);
    EXPECT_EQ(covered(20, -0.25f), nearest(20 + (1 - std::exp(-0.25)) * 100));
    const GLfloat red[4] = {1, 0, 0, 0};
    glFogfv(GL_FOG_COLOR, red); // the fog of colours
    EXPECT_EQ(covered(20, -0.25f), nearest(20 + (1 - std::exp(-0.25)) * 100));
}
#endif

#if SPANGLE_FEATURE_ANTIALIASING
/// The low four bits are the coverage in fifteenths (GL 1.3, 3.2.1, 3.11). The rectangle covers parts of
/// pixels.
TEST_F(IndexFragments, CoverageIsTheLowBits) {
    glEnable(GL_POLYGON_SMOOTH);
    for (const float index : {64.0f, 71.0f, 79.75f, 255.75f}) {
        fill(1);
        glIndexf(index);
        glBegin(GL_QUADS);
        glVertex2f(2.25f, 3);
        glVertex2f(6.5f, 3);
        glVertex2f(6.5f, 5.75f);
        glVertex2f(2.25f, 5.75f);
        glEnd();
        const int base = nearest(index) & ~15;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const auto part = [](double begin, double end, int cell) {
                    return std::fmax(0, std::fmin(end, cell + 1) - std::fmax(begin, cell));
                };
                const double covered = part(2.25, 6.5, x) * part(3, 5.75, y);
                ASSERT_EQ(at(x, y), covered == 0 ? 1 : base + static_cast<int>(covered * 15 + 0.5))
                    << index << " at " << x << ' ' << y;
            }
    }
}

/// The coverage is that of the whole polygon: between the triangles of a fan no pixel has the coverage of one
/// triangle.
TEST_F(IndexFragments, CoverageIsOfTheWholePolygon) {
    glEnable(GL_POLYGON_SMOOTH);
    const oracle::Polygon corners = {{1.5, 4},   {4.25, 1.5}, {9, 1.25}, {13.5, 5.75},
                                     {12, 11.5}, {5, 13.75},  {2, 9}};
    fill(1);
    glIndexi(64);
    glBegin(GL_POLYGON);
    for (const oracle::Point& p : corners)
        glVertex2d(p.x, p.y);
    glEnd();
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double area = oracle::area_in(corners, x, y);
            const int got = at(x, y) - 64;
            ASSERT_TRUE(area == 0 ? got == 1 - 64 : std::fabs(got - 15 * area) < 0.5 + 15.0 / 256)
                << at(x, y) << " of " << area << " at " << x << ' ' << y;
        }
}

/// Points and lines have coverage, too. A primitive that is not antialiased keeps its index, also if others
/// are antialiased.
TEST_F(IndexFragments, OnlyWhatIsAntialiasedHasCoverage) {
    glEnable(GL_LINE_SMOOTH);
    fill(0);
    glIndexi(32);
    glLineWidth(3);
    glBegin(GL_LINES);
    glVertex2f(2, 4.5f);
    glVertex2f(12, 4.5f);
    glEnd();
    EXPECT_EQ(at(7, 4), 47);
    EXPECT_EQ(at(7, 3), 47);
    EXPECT_EQ(at(7, 6), 0);
    glEnable(GL_POINT_SMOOTH);
    glPointSize(4);
    glBegin(GL_POINTS);
    glVertex2f(8, 11);
    glEnd();
    EXPECT_EQ(at(7, 10), 47);
    EXPECT_TRUE(at(6, 9) > 32 && at(6, 9) < 47) << at(6, 9);
    EXPECT_EQ(covered(32), 32);
#if SPANGLE_FEATURE_POLYGON_MODE
    glPolygonMode(GL_BACK, GL_LINE); // front faces are filled: no lines, no coverage
    EXPECT_EQ(covered(33), 33);
#endif
}
#endif

#if SPANGLE_FEATURE_LIGHTING
/// Fragments have the index that lighting makes of the material's three indices (GL 1.3, 2.13.5).
TEST_F(IndexFragments, LitIndicesArrive) {
    const GLfloat indexes[3] = {20, 120, 240}, front[4] = {0, 0, 1, 0}, half[4] = {0.5f, 0.5f, 0.5f, 1},
                  black[4] = {0, 0, 0, 1};
    glEnable(GL_LIGHTING);
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, indexes);
    EXPECT_EQ(covered(5), 20) << "no light is on";
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, front);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, half);
    glLightfv(GL_LIGHT0, GL_SPECULAR, black);
    EXPECT_EQ(covered(5), 70);
}
#endif

#if SPANGLE_FEATURE_ACCUM
TEST_F(IndexFragments, AreNotAccumulated) {
    fill(9);
    glAccum(GL_LOAD, 1);
    EXPECT_EQ(error(), static_cast<GLenum>(GL_INVALID_OPERATION));
    glAccum(GL_RETURN, 1);
    EXPECT_EQ(error(), static_cast<GLenum>(GL_INVALID_OPERATION));
    EXPECT_EQ(pixels(), std::vector<int>(size * size, 9));
}
#endif

#endif

} // namespace
} // namespace spangle::test

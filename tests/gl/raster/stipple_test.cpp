// Rows D06 and D10: tests stipples of lines and polygons (GL 1.3, 3.4.2 and 3.5.2).
#include <algorithm>
#include <cmath>

#include "tests/gl/raster/window.hpp"

namespace spangle::test {
namespace {

class Stipple : public Window {
  protected:
    using Point = std::array<GLfloat, 2>;
    using Strip = std::vector<Point>;

    /// Returns the fragments of a line of width 1, in the order of the line.
    static std::vector<int> fragments(const Point& a, const Point& b) {
        const auto on = covered([&] {
            glBegin(GL_LINES);
            glVertex2fv(a.data());
            glVertex2fv(b.data());
            glEnd();
        });
        std::vector<int> found;
        for (int i = 0; i < size * size; ++i)
            if (on[static_cast<std::size_t>(i)])
                found.push_back(i);
        const bool along_x = std::fabs(b[0] - a[0]) >= std::fabs(b[1] - a[1]);
        const bool ascends = along_x ? b[0] >= a[0] : b[1] >= a[1];
        std::stable_sort(found.begin(), found.end(), [&](int p, int q) {
            const int m = along_x ? p % size : p / size, n = along_x ? q % size : q / size;
            return ascends ? m < n : m > n;
        });
        return found;
    }
    /// Returns bit floor(s / factor) mod 16 of the pattern for each fragment; s starts at 0 in each group of
    /// segments.
    static std::vector<bool> expected(const std::vector<std::pair<Point, Point>>& segments, bool restarts,
                                      unsigned factor, unsigned pattern) {
        glDisable(GL_LINE_STIPPLE);
        std::vector<bool> on(size * size);
        unsigned s = 0;
        for (const auto& [a, b] : segments) {
            if (restarts)
                s = 0;
            for (const int i : fragments(a, b)) {
                if ((pattern >> (s / factor % 16) & 1) != 0)
                    on[static_cast<std::size_t>(i)] = true;
                ++s;
            }
        }
        glEnable(GL_LINE_STIPPLE);
        return on;
    }
    static std::vector<std::pair<Point, Point>> segments(GLenum mode, const Strip& v) {
        std::vector<std::pair<Point, Point>> all;
        for (std::size_t i = 0; i + 1 < v.size(); i += mode == GL_LINES ? 2 : 1)
            all.emplace_back(v[i], v[i + 1]);
        if (mode == GL_LINE_LOOP)
            all.emplace_back(v.back(), v.front());
        return all;
    }
    static void give(GLenum mode, const Strip& v) {
        glBegin(mode);
        for (const Point& p : v)
            glVertex2fv(p.data());
        glEnd();
    }
};

TEST_F(Stipple, PhaseGoesAlongStripsAndRestarts) {
    constexpr GLenum modes[] = {GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP};
    for (int n = 0; n < 300; ++n) {
        const GLenum mode = modes[n % 3];
        Strip v(6);
        for (Point& p : v)
            p = {place(), place()};
        const unsigned pattern = random_() & 0xFFFF,
                       factor = n % 4 != 0 ? 1 + random_() % 5 : 1 + random_() % 256;
        glLineStipple(static_cast<GLint>(factor), static_cast<GLushort>(pattern));
        const auto wish = expected(segments(mode, v), mode == GL_LINES, factor, pattern);
        EXPECT_EQ(covered([&] { give(mode, v); }), wish) << n;
        // Draws the same from arrays.
        glEnableClientState(GL_VERTEX_ARRAY);
        glVertexPointer(2, GL_FLOAT, 0, v.data());
        EXPECT_EQ(covered([&] { glDrawArrays(mode, 0, 6); }), wish) << n;
        glDisableClientState(GL_VERTEX_ARRAY);
    }
}

/// Table 17.7 of the rule: pattern 0x00FF, factor 2. Factors are clamped, and a scissor does not change the
/// phase.
TEST_F(Stipple, FactorIsClampedAndScissorChangesNoPhase) {
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(2, 0x00FF);
    const auto row = [&](bool cut) {
        glDisable(GL_SCISSOR_TEST); // clears the whole surface
        const auto on = covered([cut] {
            (cut ? glEnable : glDisable)(GL_SCISSOR_TEST);
            glBegin(GL_LINES);
            glVertex2f(0.5f, 5.5f);
            glVertex2f(size, 5.5f);
            glEnd();
        });
        return std::vector<bool>(on.begin() + 5 * size, on.begin() + 6 * size);
    };
    const auto whole = row(false);
    for (int x = 0; x < size; ++x)
        EXPECT_EQ(whole[static_cast<std::size_t>(x)], x % 32 < 16) << x;
    glScissor(10, 0, 30, size);
    const auto cut = row(true);
    for (int x = 0; x < size; ++x)
        EXPECT_EQ(cut[static_cast<std::size_t>(x)], x >= 10 && x < 40 && x % 32 < 16) << x;
    GLint factor = 0;
    for (const auto& [given, kept] : {std::pair{0, 1}, {-5, 1}, {257, 256}, {256, 256}, {3, 3}}) {
        glLineStipple(given, 1);
        glGetIntegerv(GL_LINE_STIPPLE_REPEAT, &factor);
        EXPECT_EQ(factor, kept);
    }
}

/// In a wide line, all fragments of a column share the bit of the line's fragment.
TEST_F(Stipple, WideLines) {
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(3, 0x5555);
    glLineWidth(5);
    const auto on = covered([] {
        glBegin(GL_LINES);
        glVertex2f(0.5f, 20.5f);
        glVertex2f(size, 20.5f);
        glVertex2f(20.5f, 30.5f);
        glVertex2f(20.5f, size);
        glEnd();
    });
    for (int x = 0; x < size; ++x)
        for (int y = 15; y < 26; ++y)
            EXPECT_EQ(on[static_cast<std::size_t>(y * size + x)], y >= 18 && y < 23 && x / 3 % 2 == 0);
    for (int y = 30; y < size; ++y)
        for (int x = 15; x < 26; ++x)
            EXPECT_EQ(on[static_cast<std::size_t>(y * size + x)], x >= 18 && x < 23 && (y - 30) / 3 % 2 == 0);
}

/// The outline of a polygon is one line. Its stipple starts with the first edge, also if the polygon is drawn
/// in parts.
TEST_F(Stipple, OutlinesRestartWithEachPolygon) {
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glLineStipple(1, 0x3F1B);
    const Strip five = {{10.5f, 8.5f}, {40.5f, 4.5f}, {60.5f, 30.5f}, {38.5f, 58.5f}, {6.5f, 40.5f}};
    const auto wish = expected(segments(GL_LINE_LOOP, five), false, 1, 0x3F1B);
    EXPECT_EQ(covered([&] { give(GL_POLYGON, five); }), wish);
    EXPECT_EQ(covered([&] {
                  give(GL_POLYGON, five);
                  give(GL_POLYGON, five);
              }),
              wish);
    const Strip quads(five.begin(), five.begin() + 4);
    const auto one = expected(segments(GL_LINE_LOOP, quads), false, 1, 0x3F1B);
    Strip twice = quads;
    twice.insert(twice.end(), quads.begin(), quads.end());
    EXPECT_EQ(covered([&] { give(GL_QUADS, twice); }), one);
}

struct Layout {
    GLint row_length, skip_rows, skip_pixels, alignment;
    GLboolean lsb_first;
};

void set_layout(const Layout& l, bool pack) {
    glPixelStorei(pack ? GL_PACK_ROW_LENGTH : GL_UNPACK_ROW_LENGTH, l.row_length);
    glPixelStorei(pack ? GL_PACK_SKIP_ROWS : GL_UNPACK_SKIP_ROWS, l.skip_rows);
    glPixelStorei(pack ? GL_PACK_SKIP_PIXELS : GL_UNPACK_SKIP_PIXELS, l.skip_pixels);
    glPixelStorei(pack ? GL_PACK_ALIGNMENT : GL_UNPACK_ALIGNMENT, l.alignment);
    glPixelStorei(pack ? GL_PACK_LSB_FIRST : GL_UNPACK_LSB_FIRST, l.lsb_first);
}

/// The rule of GL 1.3, 3.6.4 and figure 3.11, word for word.
bool bit_of(const std::vector<GLubyte>& image, const Layout& l, int x, int y) {
    const int length = l.row_length > 0 ? l.row_length : 32;
    const int stride = l.alignment * ((length + 8 * l.alignment - 1) / (8 * l.alignment));
    const int bit = l.skip_pixels + x;
    const GLubyte byte = image[static_cast<std::size_t>((l.skip_rows + y) * stride + bit / 8)];
    return (l.lsb_first ? byte >> (bit % 8) & 1 : byte >> (7 - bit % 8) & 1) != 0;
}

class PolygonStipple : public Stipple {
  protected:
    std::vector<GLubyte> any_image() {
        std::vector<GLubyte> image(4096);
        for (GLubyte& byte : image)
            byte = static_cast<GLubyte>(random_());
        return image;
    }
    Layout any_layout() {
        return {random_() % 2 != 0 ? 0 : static_cast<GLint>(32 + random_() % 90),
                static_cast<GLint>(random_() % 9), static_cast<GLint>(random_() % 19), 1 << random_() % 4,
                static_cast<GLboolean>(random_() % 2)};
    }
    static void fill() { glRecti(0, 0, size, size); }
};

TEST_F(PolygonStipple, BitsOfWindowCoordinatesThroughEveryLayout) {
    glEnable(GL_POLYGON_STIPPLE);
    for (int n = 0; n < 60; ++n) {
        const auto image = any_image();
        const Layout in = any_layout(), out = any_layout();
        set_layout(in, false);
        glPolygonStipple(image.data());
        const auto on = covered(fill);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                ASSERT_EQ(on[static_cast<std::size_t>(y * size + x)], bit_of(image, in, x % 32, y % 32)) << n;
        set_layout(out, true);
        auto back = any_image();
        const auto before = back;
        glGetPolygonStipple(back.data());
        set_layout({0, 0, 0, 4, GL_FALSE}, true);
        std::size_t changed = 0;
        for (std::size_t i = 0; i < back.size(); ++i)
            changed += back[i] != before[i];
        EXPECT_LE(changed, 32U * 5);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                ASSERT_EQ(bit_of(back, out, x, y), bit_of(image, in, x, y)) << n;
    }
}

TEST_F(PolygonStipple, OnlyFilledPolygons) {
    const std::vector<GLubyte> none(128, 0);
    glPolygonStipple(none.data());
    const auto outlines = [] {
        for (const GLenum mode : {GL_LINE, GL_POINT}) {
            glPolygonMode(GL_FRONT_AND_BACK, mode);
            glRecti(8, 8, 50, 50);
        }
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        for (const GLenum mode : {GL_LINES, GL_POINTS}) {
            glBegin(mode);
            glVertex2f(1.5f, 2.5f);
            glVertex2f(60.5f, 2.5f);
            glEnd();
        }
    };
    const auto plain = covered(outlines);
    glEnable(GL_POLYGON_STIPPLE);
    EXPECT_EQ(covered(outlines), plain);
    EXPECT_EQ(covered(fill), std::vector<bool>(size * size, false));
}

/// A list unpacks the image when it is compiled, and sets the pattern when it is called.
TEST_F(PolygonStipple, ListsKeepTheImageOfTheirCompilation) {
    glEnable(GL_POLYGON_STIPPLE);
    auto image = any_image();
    const Layout layout{40, 1, 3, 2, GL_TRUE};
    set_layout(layout, false);
    glNewList(1, GL_COMPILE);
    glPolygonStipple(image.data());
    glEndList();
    EXPECT_EQ(covered(fill), std::vector<bool>(size * size, true));
    const auto kept = image;
    image.assign(image.size(), 0);
    set_layout({0, 0, 0, 4, GL_FALSE}, false);
    glCallList(1);
    const auto on = covered(fill);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            ASSERT_EQ(on[static_cast<std::size_t>(y * size + x)], bit_of(kept, layout, x % 32, y % 32));
}

TEST_F(PolygonStipple, GroupsOfAttributes) {
    const auto image = any_image(), other = any_image();
    std::vector<GLubyte> back(128);
    glPolygonStipple(image.data());
    glPushAttrib(GL_POLYGON_BIT); // saves the switch, and not the pattern
    glPolygonStipple(other.data());
    glEnable(GL_POLYGON_STIPPLE);
    glPopAttrib();
    EXPECT_FALSE(glIsEnabled(GL_POLYGON_STIPPLE));
    glGetPolygonStipple(back.data());
    EXPECT_TRUE(std::equal(back.begin(), back.end(), other.begin()));
    glPushAttrib(GL_POLYGON_STIPPLE_BIT); // saves the pattern, and not the switch
    glPolygonStipple(image.data());
    glEnable(GL_POLYGON_STIPPLE);
    glPopAttrib();
    EXPECT_TRUE(glIsEnabled(GL_POLYGON_STIPPLE));
    glGetPolygonStipple(back.data());
    EXPECT_TRUE(std::equal(back.begin(), back.end(), other.begin()));
}

} // namespace
} // namespace spangle::test

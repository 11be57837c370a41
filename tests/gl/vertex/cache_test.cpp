// Rows A05, B13: vertices of elements that come again are cached, and this must never show. Whatever has
// changed in between, glDrawElements draws what glArrayElement gives one by one.
#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "gl/context/context.hpp"
#include "gl/context/features.hpp"
#include "gl/context/limits.hpp"
#include "gl/vertex/engine.hpp"
#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

class VertexCache : public Canvas {
  protected:
    /// Blocks of neighbouring elements, so far apart that they share places in the cache.
    static constexpr int block = 200, apart = static_cast<int>(gl::vertex_cache), elements = 3 * block,
                         longest = 60;
    static constexpr std::size_t room = 2 * apart + block;
    static std::size_t index_of(int element) {
        return static_cast<std::size_t>(element / block * apart + element % block);
    }
    std::mt19937 random{11};
    std::array<std::array<GLfloat, 4>, room> position, normal, tex_coord;
    std::array<std::array<GLubyte, 4>, room> color;
    GLint size = 3, tex_coords = 4;
    int most_indices = longest; ///< most indices of one draw
    std::vector<GLushort> indices;

    int whole(int low, int high) { return std::uniform_int_distribution<>(low, high)(random); }
    GLfloat real(double low, double high) {
        return static_cast<GLfloat>(std::uniform_real_distribution<>(low, high)(random));
    }
    std::array<GLfloat, 4> any() { return {real(-1, 1), real(-1, 1), real(-1, 1), real(0.5, 2)}; }

    void SetUp() override {
        Canvas::SetUp();
        for (int i = 0; i < elements; ++i)
            change(index_of(i));
        glMatrixMode(GL_PROJECTION);
        glFrustum(-1, 1, -1, 1, 1, 9);
        glMatrixMode(GL_MODELVIEW);
        glTranslatef(0, 0, -3);
        glEnable(GL_LIGHT0);
        glEnableClientState(GL_VERTEX_ARRAY);
    }

    void change(std::size_t i) {
        position[i] = any();
        normal[i] = any();
        tex_coord[i] = any();
        for (GLubyte& c : color[i])
            c = static_cast<GLubyte>(whole(0, 255));
    }

    void toggle(GLenum what) { (glIsEnabled(what) ? glDisable : glEnable)(what); }
    void toggle_array(GLenum what) { (glIsEnabled(what) ? glDisableClientState : glEnableClientState)(what); }

    /// Changes memory of the arrays, of which GL is not told. One number of each attribute changes, so the
    /// cache must compare all of them.
    void change_memory() {
        for (int n = 0; n < 300; ++n) {
            const std::size_t i = index_of(whole(0, elements - 1));
            const auto c = static_cast<std::size_t>(whole(0, 3));
            (whole(0, 1) != 0 ? position : normal)[i][c] = c < 3 ? real(-1, 1) : real(0.5, 2);
            tex_coord[i][c] = real(-1, 1);
            color[i][c] = static_cast<GLubyte>(whole(0, 255));
        }
        // At seams the same position has another colour, texture coordinate, or both.
        for (int n = 0; n < 30; ++n) {
            const int element = whole(0, elements - block - 1);
            const std::size_t i = index_of(element), shares = index_of(element + block);
            position[shares] = position[i];
            normal[shares] = normal[i];
        }
    }

    /// Changes one thing on which a cached vertex depends.
    void change_something() {
        auto v = any();
        switch (whole(0, 30)) {
        case 0:
            return glRotatef(real(-30, 30), v[0], v[1], v[2]);
        case 1:
            return glViewport(whole(-9, 9), whole(-9, 9), whole(20, 90), whole(20, 90));
        case 2:
            return glDepthRange(real(0, 1), real(0, 1));
        case 3:
            return glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, v.data());
        case 4:
            return glLightfv(GL_LIGHT0, GL_POSITION, v.data());
        case 5:
            return toggle(GL_LIGHTING);
        case 6:
            return toggle(GL_FOG);
        case 7:
            return toggle(GL_TEXTURE_2D);
        case 8:
            return toggle(GL_COLOR_MATERIAL);
        case 9:
            return toggle(GL_NORMALIZE);
        case 10:
            return toggle_array(GL_NORMAL_ARRAY);
        case 11:
            return toggle_array(GL_COLOR_ARRAY);
        case 12:
            return toggle_array(GL_TEXTURE_COORD_ARRAY);
        case 13:
            glGetFloatv(GL_CURRENT_NORMAL, v.data());
            v[static_cast<std::size_t>(whole(0, 2))] = real(-1, 1);
            return glNormal3fv(v.data());
        case 14:
            glGetFloatv(GL_CURRENT_COLOR, v.data());
            v[static_cast<std::size_t>(whole(0, 3))] = real(0, 1);
            return glColor4fv(v.data());
        case 15:
            size = whole(2, 4);
            return;
        case 16:
            return glShadeModel(whole(0, 1) != 0 ? GL_FLAT : GL_SMOOTH);
        case 17: // sets the most frequent state
            size = 3;
            (whole(0, 1) != 0 ? glEnable : glDisable)(GL_LIGHTING);
            glDisable(GL_TEXTURE_2D);
            glDisable(GL_COLOR_MATERIAL);
            glEnableClientState(GL_NORMAL_ARRAY);
            glDisableClientState(GL_COLOR_ARRAY);
            return glDisableClientState(GL_TEXTURE_COORD_ARRAY);
        case 18: // sets the most frequent state that has a texture
            size = 3;
            tex_coords = 2;
            glEnable(GL_TEXTURE_2D);
            glDisable(GL_COLOR_MATERIAL);
            glEnableClientState(GL_NORMAL_ARRAY);
            glDisableClientState(GL_COLOR_ARRAY);
            return glEnableClientState(GL_TEXTURE_COORD_ARRAY);
        case 19:
            tex_coords = whole(1, 4);
            return;
        case 20:
            glMatrixMode(GL_TEXTURE);
            glLoadIdentity();
            if (whole(0, 1) != 0)
                glScalef(v[0], v[1], v[2]);
            return glMatrixMode(GL_MODELVIEW);
        case 21:
            return toggle(GL_TEXTURE_GEN_S);
        default:
            return change_memory();
        }
    }

    void arrays() {
        glVertexPointer(size, GL_FLOAT, sizeof position[0], position[0].data());
        glNormalPointer(GL_FLOAT, sizeof normal[0], normal[0].data());
        glTexCoordPointer(tex_coords, GL_FLOAT, sizeof tex_coord[0], tex_coord[0].data());
        glColorPointer(4, GL_UNSIGNED_BYTE, 0, color[0].data());
    }

    /// Makes indices: runs of neighbours, jumps, and indices that share a place in the cache.
    void some_indices() {
        indices.resize(static_cast<std::size_t>(whole(3, most_indices)));
        int at = whole(0, elements - 1);
        for (GLushort& index : indices) {
            index = static_cast<GLushort>(index_of(at));
            const int steps[] = {1, -1, 0, block, -block, whole(-300, 300)};
            at = (at + steps[whole(0, 5)] + elements) % elements;
        }
    }

    static bool same(const raster::FixedVertex& a, const raster::FixedVertex& b, bool fog, bool texture) {
        const auto& s = a.tex[0];
        const auto& t = b.tex[0];
        return a.x == b.x && a.y == b.y && a.z == b.z && a.w_mantissa == b.w_mantissa &&
               a.w_exponent == b.w_exponent &&
               (!fog || (a.fog_mantissa == b.fog_mantissa && a.fog_exponent == b.fog_exponent)) &&
               (!texture || (s.s == t.s && s.t == t.t && s.q == t.q && s.exponent == t.exponent &&
                             s.q_is_one == t.q_is_one));
    }
    static bool same_color(const raster::FixedVertex& a, const raster::FixedVertex& b) {
        return std::equal(a.color, a.color + 4, b.color) &&
               std::equal(a.secondary, a.secondary + 3, b.secondary);
    }

    using Primitives = decltype(WindowRecorder::primitives);

    void give(GLenum mode) {
        glBegin(mode);
        for (const GLushort i : indices)
            glArrayElement(i);
        glEnd();
    }
    Primitives given(GLenum mode) {
        WindowRecorder recorder;
        give(mode);
        return recorder.primitives;
    }
    Primitives drawn(GLenum mode) {
        WindowRecorder recorder;
        glDrawElements(mode, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_SHORT, indices.data());
        return recorder.primitives;
    }

    /// Compares the vertices in everything that the present state uses.
    void compare(const Primitives& drawn, const Primitives& given, int n) {
        ASSERT_EQ(drawn.size(), given.size()) << n;
        const bool fog = glIsEnabled(GL_FOG) != 0, texture = glIsEnabled(GL_TEXTURE_2D) != 0;
        GLint shading = 0;
        glGetIntegerv(GL_SHADE_MODEL, &shading);
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            const Primitive &a = drawn[i], &b = given[i];
            ASSERT_TRUE(same_color(a.provoking, b.provoking)) << n << ' ' << i;
            for (int c = 0; c < a.corners; ++c) {
                ASSERT_TRUE(same(a.corner[c], b.corner[c], fog, texture)) << n << ' ' << i;
                ASSERT_TRUE(shading == GL_FLAT || same_color(a.corner[c], b.corner[c])) << n << ' ' << i;
                ++compared;
            }
        }
    }
    std::size_t compared = 0; ///< number of vertices that were compared
};

TEST_F(VertexCache, TellsNothing) {
    for (int n = 0; n < 50000; ++n) {
        if (n == 45000)
            most_indices = 400; // makes a cache that begins small grow
        if (whole(0, 1) != 0)
            change_something();
        arrays();
        some_indices();
        const auto mode = static_cast<GLenum>(whole(GL_POINTS, GL_POLYGON));
        GLfloat color_before[4];
        glGetFloatv(GL_CURRENT_COLOR, color_before);
        const Primitives elements = drawn(mode);
        glColor4fv(color_before);
        ASSERT_NO_FATAL_FAILURE(compare(elements, given(mode), n));
    }
    std::printf("%zu corners\n", compared);
    EXPECT_GT(compared, 500000u);
}

/// The context of a host has no memory for many vertices before it draws them.
TEST_F(VertexCache, BeginsSmall) {
    EXPECT_LE(sizeof(gl::Context) + gl::fixed_engine.pipeline_bytes, std::size_t{64} * 1024);
}

/// With many vertices, single vertices are found by their positions, too. Then something changes.
TEST_F(VertexCache, TellsNothingOfPositions) {
    for (int n = 0; n < 2000; ++n) {
        arrays();
        some_indices();
        const auto mode = static_cast<GLenum>(whole(GL_POINTS, GL_POLYGON));
        for (std::size_t vertices = 0; vertices < 600; vertices += indices.size())
            give(mode);
        for (int changes = whole(0, 2); changes > 0; --changes)
            change_something();
        arrays();
        GLfloat color_before[4];
        glGetFloatv(GL_CURRENT_COLOR, color_before);
        const Primitives in_turn = given(mode);
        glColor4fv(color_before);
        ASSERT_NO_FATAL_FAILURE(compare(drawn(mode), in_turn, n));
    }
    EXPECT_GT(compared, 20000u);
}

/// Points differ only outside of x, y and z in range: in z, in w, or in the guard band.
TEST_F(VertexCache, PositionsThatAreNearlyTheSame) {
    for (int n = 0; n < 500; ++n) {
        size = whole(2, 4);
        for (std::size_t i = 1; i < position.size(); ++i) {
            position[i] = position[0];
            position[i][static_cast<std::size_t>(whole(0, 3))] =
                whole(0, 3) != 0 ? real(0.5, 2) : real(-90, 90);
        }
        indices.clear();
        for (int i = 0; i < 600; ++i)
            indices.push_back(static_cast<GLushort>(whole(0, longest)));
        arrays();
        give(GL_TRIANGLES);
        const Primitives in_turn = given(GL_TRIANGLES);
        ASSERT_NO_FATAL_FAILURE(compare(drawn(GL_TRIANGLES), in_turn, n));
    }
    EXPECT_GT(compared, 20000u);
}

/// The same s and t follow with another q; the cached coordinate must not be used.
TEST_F(VertexCache, CoordinatesOfTwoComponentsAreNotThoseOfFour) {
    glEnable(GL_TEXTURE_2D);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    indices = {0, 1, 2, 3};
    const auto draw = [&](GLint components) {
        tex_coords = components;
        arrays();
        WindowRecorder recorder;
        glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_SHORT, indices.data());
        return recorder.primitives;
    };
    const auto before = draw(2), between = draw(4), after = draw(2);
    ASSERT_EQ(before.size(), after.size());
    ASSERT_FALSE(before.empty());
    for (std::size_t i = 0; i < before.size(); ++i)
        for (int c = 0; c < before[i].corners; ++c) {
            EXPECT_TRUE(same(before[i].corner[c], after[i].corner[c], false, true)) << i << ' ' << c;
            EXPECT_FALSE(same(before[i].corner[c], between[i].corner[c], false, true)) << i << ' ' << c;
        }
}

} // namespace
} // namespace spangle::test

// The stage of vertices alone: where a vertex lies in the window, which planes it is outside of, and which
// texture coordinates it gets.
#include <array>
#include <cmath>
#include <memory>
#include <random>

#include "gl/vertex/vertex_stage.hpp"
#include "tests/gl/vertex/vertex_parts.hpp"

namespace spangle::test {
namespace {

using VertexStage = gl::VertexStage<gl::FixedMath>;

/// Begins draws as Shading does, with nothing of what the parts above derive.
struct Stage : VertexStage {
    using VertexStage::texgen_;
    using VertexStage::transforms_;

    /// Derives what has changed since the last time, or what `dirty` names.
    void begin(GLenum mode, unsigned dirty = gl::dirty_none) {
        gl::Context& context = *gl::current_context();
        context_ = &context;
        derive_transforms(context, dirty != gl::dirty_none ? dirty : context.dirty);
        context.dirty = static_cast<std::uint16_t>(context.dirty & ~gl::dirty_vertex);
        modes_.derive(context, mode, {false, false, planes_.any()});
    }
    static Vertex at(float x, float y, float z, float w = 1) {
        const float given[4] = {x, y, z, w};
        Vertex v;
        for (int c = 0; c < 4; ++c)
            v.position[c] = numeric::from_float(given[c]);
        return v;
    }
    Vertex placed(float x, float y, float z, float w = 1) const {
        Vertex v = at(x, y, z, w);
        transform_vertex(v);
        return v;
    }
};

/// The flags of a vertex outside of the planes of the view volume with the given bits.
constexpr unsigned outside_of(unsigned planes) {
    return planes;
}
constexpr unsigned left = 1, right = 2, bottom = 4, top = 8, near = 16, far = 32;
constexpr unsigned beyond(unsigned planes) {
    return planes << gl::beyond_shift;
}

class VertexStageAlone : public VertexParts {
  protected:
    const std::unique_ptr<Stage> stage_ = std::make_unique<Stage>();

    void begin() { stage_->begin(GL_TRIANGLES); }
    std::array<float, 4> texture_of(const Vertex& v, int unit) const {
        numeric::Real strq[4];
        gl::FixedMath::to_reals(stage_->texture_of(gl::current_context()->current, v, unit), strq);
        return {numeric::to_float(strq[0]), numeric::to_float(strq[1]), numeric::to_float(strq[2]),
                numeric::to_float(strq[3])};
    }
    static bool same_window(const Vertex& a, const Vertex& b) {
        return a.window.x == b.window.x && a.window.y == b.window.y && a.window.z == b.window.z &&
               a.window.w_mantissa == b.window.w_mantissa && a.window.w_exponent == b.window.w_exponent;
    }
};

TEST_F(VertexStageAlone, MapsTheViewVolumeToTheViewport) {
    glViewport(8, 16, 32, 20);
    glDepthRange(0.25, 0.75);
    begin();
    for (const int x : {-1, 0, 1})
        for (const int y : {-1, 0, 1})
            for (const int z : {-1, 0, 1})
                for (const float w : {1.0f, 0x1p-100f, 3.0f, 0x1p100f}) {
                    const Vertex v = stage_->placed(static_cast<float>(x) * w, static_cast<float>(y) * w,
                                                    static_cast<float>(z) * w, w);
                    EXPECT_EQ(v.flags, 0u) << x << ' ' << y << ' ' << z << ' ' << w;
                    EXPECT_EQ(pixels(v.window.x), 8 + 16 + 16 * x);
                    EXPECT_EQ(pixels(v.window.y), 16 + 10 + 10 * y);
                    EXPECT_EQ(v.window.z, (1u << 29) + (1u << 28) * static_cast<unsigned>(z));
                }
}

TEST_F(VertexStageAlone, FlagsEachPlaneThatAVertexIsOutsideOf) {
    begin();
    const struct {
        float x, y, z;
        unsigned flags;
    } cases[] = {
        {-1.001f, 0, 0, outside_of(left)},
        {1.001f, 0, 0, outside_of(right)},
        {0, -3.99f, 0, outside_of(bottom)},
        {0, 3.99f, 0, outside_of(top)},
        {-4.01f, 0, 0, outside_of(left) | beyond(left)},
        {4.01f, 0, 0, outside_of(right) | beyond(right)},
        {0, -1e30f, 0, outside_of(bottom) | beyond(bottom)},
        {0, 3e38f, 0, outside_of(top) | beyond(top)},
        // Near and far clip everything that is outside of them.
        {0, 0, -1.001f, outside_of(near) | beyond(near)},
        {0, 0, 1.001f, outside_of(far) | beyond(far)},
        {-2, 5, 3, outside_of(left | top | far) | beyond(top | far)},
        {-4, -4, 1, outside_of(left | bottom)}, // on the guard band
        {1, 1, 1, 0},
    };
    for (const auto& c : cases)
        EXPECT_EQ(stage_->placed(c.x, c.y, c.z).flags & ~gl::unprojected, c.flags)
            << c.x << ' ' << c.y << ' ' << c.z;
}

/// A vertex that is not in front of the eye has no window position.
TEST_F(VertexStageAlone, DividesNoVertexThatIsNotInFrontOfTheEye) {
    begin();
    const struct {
        std::array<float, 4> position;
        unsigned flags;
    } cases[] = {
        {{0, 0, 0, 0}, 0}, // 0 lies between -w and w
        {{1, 0, 0, 0}, outside_of(right) | beyond(right)},
        {{0, -1, 0, 0}, outside_of(bottom) | beyond(bottom)},
        {{0, 0, 0, -1}, outside_of(0x3F) | beyond(0x3F)},
        // x = -2 is below w = -1, and so inside of the right plane only.
        {{-2, 0, 0, -1}, outside_of(0x3F & ~right) | beyond(0x3F)},
        {{-2, 3, 0, -1}, outside_of(0x3F & ~(right | bottom)) | beyond(0x3F)},
        // Beside a coordinate of such a size, the others count as 0.
        {{-3e38f, 1e-38f, 0, -1e-38f}, outside_of(left) | beyond(left)},
    };
    for (const auto& c : cases) {
        const auto& [x, y, z, w] = c.position;
        EXPECT_EQ(stage_->placed(x, y, z, w).flags, c.flags | gl::unprojected)
            << x << ' ' << y << ' ' << z << ' ' << w;
    }
}

/// Whatever vertex was in the slot before, its flags are those of the new one.
TEST_F(VertexStageAlone, ForgetsTheFlagsOfAnEarlierVertex) {
    begin();
    for (const float w : {1.0f, 0.0f}) {
        Vertex v = Stage::at(0, 0, 0, w);
        v.flags = ~0u;
        stage_->transform_vertex(v);
        EXPECT_EQ(v.flags, w == 1 ? 0u : gl::unprojected);
    }
}

TEST_F(VertexStageAlone, LeavesTheColorOfALitVertexOpen) {
    for (const bool lit : {false, true}) {
        if (lit)
            glEnable(GL_LIGHTING);
        begin();
        EXPECT_EQ(stage_->placed(0, 0, 0).flags, lit ? gl::uncolored : 0u);
        EXPECT_EQ(stage_->placed(2, 0, 0).flags, outside_of(right) | (lit ? gl::uncolored : 0u));
        EXPECT_EQ(stage_->placed(0, 0, 0, 0).flags, gl::unprojected | (lit ? gl::uncolored : 0u));
    }
}

/// Coordinates of any size, and matrices with and without perspective.
TEST_F(VertexStageAlone, PlacesAnElementAsItPlacesAGivenVertex) {
    std::mt19937 random(7);
    glMatrixMode(GL_PROJECTION);
    for (int round = 0; round < 20; ++round) {
        glLoadIdentity();
        if (round % 2 != 0)
            glFrustum(-1, 1, -1, 1, 1, 50);
        glRotatef(static_cast<float>(10 * round), 1, 2, 3);
        begin();
        for (int i = 0; i < 2000; ++i) {
            alignas(4) float words[3];
            for (float& x : words)
                x = std::ldexp(static_cast<float>(static_cast<int>(random() >> 8) - (1 << 23)),
                               -23 + (round % 4 == 3 ? static_cast<int>(random() % 200) - 100 : 1));
            Vertex given = Stage::at(words[0], words[1], words[2]), element;
            given.flags = element.flags = gl::edge_flag;
            element.position[3] = numeric::zero;
            stage_->transform_vertex(given);
            stage_->process_common(element, reinterpret_cast<const std::uint8_t*>(words));
            ASSERT_EQ(given.flags, element.flags);
            ASSERT_TRUE(gl::equal_words<4>(given.position, element.position));
            const bool has_place = (given.flags & gl::unprojected) == 0;
            ASSERT_TRUE(!has_place || same_window(given, element))
                << words[0] << ' ' << words[1] << ' ' << words[2];
        }
    }
}

/// A vertex has the same place wherever the matrices that make it stand.
TEST_F(VertexStageAlone, DerivesOnlyWhatHasChanged) {
    begin();
    const Vertex before = stage_->placed(0.25f, 0.5f, 0);
    glTranslatef(0.5f, 0, 0);
    stage_->begin(GL_TRIANGLES, gl::dirty_viewport | gl::dirty_lights | gl::dirty_others);
    EXPECT_TRUE(same_window(stage_->placed(0.25f, 0.5f, 0), before));
    stage_->begin(GL_TRIANGLES, gl::dirty_modelview);
    EXPECT_EQ(stage_->placed(0.25f, 0.5f, 0).window.x, before.window.x + 16 * raster::subpixel_one);
    glViewport(0, 0, 32, 64);
    stage_->begin(GL_TRIANGLES, gl::dirty_viewport);
    EXPECT_EQ(pixels(stage_->placed(0.25f, 0.5f, 0).window.x), 16 + 16 * 0.75);
    EXPECT_EQ(stage_->placed(0.25f, 0.5f, 0).window.y, before.window.y);
}

/// Bit p stands for the enabled plane number p. A plane holds the points on it (GL 1.3, 2.11).
TEST_F(VertexStageAlone, TellsTheUserPlanesThatAVertexIsOutsideOf) {
    begin();
    EXPECT_EQ(stage_->outside(Stage::at(-1, -1, -1)), 0u);
    const GLdouble right_half[4] = {1, 0, 0, 0}, low[4] = {0, -1, 0, 0.5}, nothing[4] = {0, 0, 0, -1};
    glClipPlane(GL_CLIP_PLANE1, right_half);
    glClipPlane(GL_CLIP_PLANE5, low);
    glEnable(GL_CLIP_PLANE1);
    glEnable(GL_CLIP_PLANE5);
    begin();
    EXPECT_EQ(stage_->outside(Stage::at(0, 0.5f, 0)), 0u);
    EXPECT_EQ(stage_->outside(Stage::at(-1e-6f, 0.5f, 9)), 1u);
    EXPECT_EQ(stage_->outside(Stage::at(0, 0.501f, 9)), 2u);
    EXPECT_EQ(stage_->outside(Stage::at(-3e38f, 3e38f, 0)), 3u);
    EXPECT_EQ(stage_->outside(Stage::at(1, 1, 0, 2)), 0u); // the distance is that of (1, 1, 0, 2) as it is
    EXPECT_EQ(stage_->outside(Stage::at(1, 1.1f, 0, 2)), 2u);
    glClipPlane(GL_CLIP_PLANE0, nothing);
    glEnable(GL_CLIP_PLANE0);
    glDisable(GL_CLIP_PLANE1);
    begin();
    EXPECT_EQ(stage_->outside(Stage::at(-1, 1, 0)), 3u);
    EXPECT_EQ(stage_->outside(Stage::at(-1, 0, 0)), 1u);
}

TEST_F(VertexStageAlone, CopiesCoordinatesOfEnabledUnitsOnly) {
    GLuint texture[2];
    glGenTextures(2, texture);
    const GLubyte texel[4] = {};
    for (int u = 0; u < 2; ++u) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(u));
        glBindTexture(GL_TEXTURE_2D, texture[u]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    }
    glEnable(GL_TEXTURE_2D); // of unit 1
    glMultiTexCoord4f(GL_TEXTURE0, 3, 4, 0, 1);
    glMultiTexCoord4f(GL_TEXTURE1, 1, 2, 0, 0.5f);
    begin();
    Vertex v = stage_->placed(0, 0, 0);
    v.window.tex[0] = {1234, 5678, 9, 10, 11};
    v.flags = gl::edge_flag;
    stage_->set_texture_coords(gl::current_context()->current, v);
    EXPECT_EQ(v.flags, gl::edge_flag);
    EXPECT_EQ(v.window.tex[0].s, 1234);
    EXPECT_EQ(v.window.tex[0].exponent, 10);
    const auto& one = v.window.tex[1];
    EXPECT_EQ(one.q_is_one, 0);
    EXPECT_EQ(std::ldexp(one.s, one.exponent), 1);
    EXPECT_EQ(std::ldexp(one.t, one.exponent), 2);
    EXPECT_EQ(std::ldexp(one.q, one.exponent), 0.5);
}

TEST_F(VertexStageAlone, TakesCoordinatesThroughTheMatrixOfTheirUnit) {
    glMultiTexCoord4f(GL_TEXTURE0, 1, 2, 3, 4);
    glMultiTexCoord4f(GL_TEXTURE1, 5, 6, 7, 8);
    glMatrixMode(GL_TEXTURE);
    glActiveTexture(GL_TEXTURE1);
    glScalef(2, 3, 5);
    glTranslatef(1, 0, 0);
    begin();
    const Vertex v = stage_->placed(0, 0, 0);
    EXPECT_EQ(texture_of(v, 0), (std::array<float, 4>{1, 2, 3, 4}));
    EXPECT_EQ(texture_of(v, 1), (std::array<float, 4>{26, 18, 35, 8}));
}

/// Generated coordinates replace the given ones before the texture matrix (GL 1.3, 2.10.4).
TEST_F(VertexStageAlone, GeneratesCoordinatesFromThePosition) {
    const GLfloat of_x[4] = {2, 0, 0, 1}, of_eye_y[4] = {0, 1, 0, 0};
    glMultiTexCoord4f(GL_TEXTURE0, 9, 9, 3, 1);
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    glTexGenfv(GL_S, GL_OBJECT_PLANE, of_x);
    glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
    glTexGenfv(GL_T, GL_EYE_PLANE, of_eye_y);
    glEnable(GL_TEXTURE_GEN_S);
    glEnable(GL_TEXTURE_GEN_T);
    const GLubyte texel[4] = {};
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    glEnable(GL_TEXTURE_2D);
    glTranslatef(0, 8, 0);
    glMatrixMode(GL_TEXTURE);
    glScalef(1, 0.5f, 1);
    begin();
    Vertex v = stage_->placed(0.25f, 2, 0);
    EXPECT_EQ(texture_of(v, 0), (std::array<float, 4>{1.5f, 5, 3, 1}));
    stage_->set_texture_coords(gl::current_context()->current, v);
    const auto& at = v.window.tex[0];
    EXPECT_EQ(std::ldexp(at.s, at.exponent), 1.5);
    EXPECT_EQ(std::ldexp(at.t, at.exponent), 5);
}

} // namespace
} // namespace spangle::test

// Batches of elements alone: lines and strips of elements must be those that elements one by one give.
#include <cstdint>
#include <cstring>
#include <deque>
#include <memory>
#include <random>
#include <vector>

#include "gl/vertex/element_batches.hpp"
#include "tests/gl/vertex/vertex_parts.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

using ElementBatches = gl::ElementBatches<gl::FixedMath, gl::FixedLighting>;
using gl::line_batch;

struct BatchesPart : Alone<ElementBatches> {
    using ElementBatches::cache_;
    using ElementBatches::pending_vertices;
};

class ElementBatchesAlone : public VertexParts {
  protected:
    using Indices = std::vector<std::uint32_t>;
    struct Element {
        GLfloat position[3], normal[3], st[2];
    };
    static constexpr std::uint32_t pending = BatchesPart::pending_vertices, batch = line_batch,
                                   places = 128; ///< elements of a small cache
    static constexpr std::uint32_t counts[] = {
        0,           1,       2,           3,           4,           5,
        batch - 1,   batch,   batch + 1,   batch + 2,   2 * batch,   2 * batch + 1,
        pending - 1, pending, pending + 1, pending + 2, 2 * pending, 3 * pending + 7};

    const std::unique_ptr<BatchesPart> part_ = std::make_unique<BatchesPart>();
    std::vector<Element> array_ = std::vector<Element>(4 * places);
    std::mt19937 random_{5};

    static gl::Context& context() { return *gl::current_context(); }
    void SetUp() override {
        VertexParts::SetUp();
        scatter(0.9f);
        glEnableClientState(GL_VERTEX_ARRAY);
        glVertexPointer(3, GL_FLOAT, sizeof(Element), array_[0].position);
    }
    /// Places all elements at random, up to `far` from the middle.
    void scatter(float far) {
        std::uniform_real_distribution<float> number(-far, far);
        for (Element& e : array_)
            e = {{number(random_), number(random_), number(random_)},
                 {number(random_), number(random_), number(random_)},
                 {number(random_), number(random_)}};
    }
    void enable_lights() {
        glEnable(GL_LIGHTING);
        glEnable(GL_LIGHT0);
        glEnable(GL_NORMALIZE);
        glEnableClientState(GL_NORMAL_ARRAY);
        glNormalPointer(GL_FLOAT, sizeof(Element), array_[0].normal);
    }
    void enable_coordinates() {
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
        glTexCoordPointer(2, GL_FLOAT, sizeof(Element), array_[0].st);
        const GLubyte texel[4] = {};
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
        glEnable(GL_TEXTURE_2D);
    }
    static Indices consecutive(std::uint32_t n, std::uint32_t first = 0) {
        Indices all;
        for (std::uint32_t i = 0; i < n; ++i)
            all.push_back(first + i);
        return all;
    }
    void begin(GLenum mode) {
        if (part_->begin(mode) != gl::Stale::nothing)
            part_->cache_.invalidate();
        part_->begin_lines(context());
        part_->cache_.hold_elements(context(), places);
    }
    /// What a batch gives. The cache is small, so that indices that differ by `places` share a place.
    std::vector<Primitive> of_batch(GLenum mode, std::uint32_t count, const gl::Indices& indices) {
        begin(mode);
        const gl::ElementReader reader(context().arrays);
        const bool normals = part_->modes_.is_lit() && reader.normal.on(),
                   textured = part_->is_common_texture(reader);
        part_->arrays_begin(reader, context().current, textured);
        if (!part_->modes_.is_lit())
            part_->set_unlit_color(context().current);
        WindowRecorder recorder;
        if (mode == GL_TRIANGLE_STRIP)
            part_->draw_strip_elements(reader, count, indices, normals, textured);
        else
            part_->draw_line_elements(reader, count, indices, normals);
        gl::PrimitiveSink<gl::FixedMath, gl::FixedLighting>& sink = *part_;
        part_->assembler_.end(sink);
        return recorder.primitives;
    }
    std::vector<Primitive> of_batch(GLenum mode, const Indices& indices) {
        return of_batch(mode, static_cast<std::uint32_t>(indices.size()),
                        {GL_UNSIGNED_INT, 0, indices.data()});
    }
    /// What the elements give one by one, each in a vertex of its own that nothing keeps.
    std::vector<Primitive> one_by_one(GLenum mode, const Indices& indices) {
        begin(mode);
        const gl::CurrentState& current = context().current;
        std::deque<Vertex> vertices;
        gl::PrimitiveSink<gl::FixedMath, gl::FixedLighting>& sink = *part_;
        WindowRecorder recorder;
        for (const std::uint32_t index : indices) {
            const Element& e = array_[index];
            Vertex& v = vertices.emplace_back();
            for (int c = 0; c < 3; ++c) {
                v.position[c] = numeric::from_float(e.position[c]);
                v.normal[c] =
                    glIsEnabled(GL_NORMAL_ARRAY) != 0 ? numeric::from_float(e.normal[c]) : current.normal[c];
            }
            gl::CurrentState with = current;
            if (glIsEnabled(GL_TEXTURE_COORD_ARRAY) != 0)
                for (int c = 0; c < 2; ++c)
                    with.tex_coord[0].v[c] = numeric::from_float(e.st[c]);
            part_->transform_vertex(v);
            part_->set_attributes_of(with, v);
            part_->assembler_.set_next(v);
            if (part_->assembler_.take_next())
                part_->assembler_.complete(sink);
        }
        part_->assembler_.end(sink);
        return recorder.primitives;
    }
    static bool equal_colors(const raster::FixedVertex& a, const raster::FixedVertex& b) {
        return std::memcmp(a.color, b.color, sizeof a.color) == 0;
    }
    static bool equal(const raster::FixedVertex& a, const raster::FixedVertex& b, bool textured) {
        return a.x == b.x && a.y == b.y && a.z == b.z && a.w_mantissa == b.w_mantissa &&
               a.w_exponent == b.w_exponent && equal_colors(a, b) &&
               (!textured || (a.tex[0].s == b.tex[0].s && a.tex[0].t == b.tex[0].t &&
                              a.tex[0].exponent == b.tex[0].exponent));
    }
    void expect_equal(GLenum mode, const Indices& indices, const std::vector<Primitive>& given) {
        const std::vector<Primitive> expected = one_by_one(mode, indices);
        ASSERT_EQ(given.size(), expected.size()) << "mode " << mode << ", " << indices.size() << " elements";
        const bool textured = glIsEnabled(GL_TEXTURE_2D) != 0, flat = part_->modes_.is_flat_shaded();
        for (std::size_t i = 0; i < given.size(); ++i) {
            ASSERT_EQ(given[i].corners, expected[i].corners);
            ASSERT_EQ(given[i].size, expected[i].size);
            ASSERT_EQ(given[i].area2, expected[i].area2);
            for (int c = 0; c < given[i].corners && !flat; ++c)
                ASSERT_TRUE(equal(given[i].corner[c], expected[i].corner[c], textured))
                    << "mode " << mode << ", " << indices.size() << " elements, primitive " << i
                    << ", corner " << c;
            // A provoking vertex gives its colour, even where it has no window position.
            ASSERT_TRUE(equal_colors(given[i].provoking, expected[i].provoking)) << i;
        }
    }
    /// Both ways, and the batch again, since the first one left its vertices in the cache.
    void expect_equal(GLenum mode, const Indices& indices) {
        for (int time = 0; time < 2; ++time)
            expect_equal(mode, indices, of_batch(mode, indices));
    }
    static constexpr GLenum modes[] = {GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLE_STRIP};
};

TEST_F(ElementBatchesAlone, DrawAnyNumberOfElements) {
    for (const GLenum mode : modes)
        for (const std::uint32_t count : counts)
            expect_equal(mode, consecutive(count, 3));
}

TEST_F(ElementBatchesAlone, DrawRepeatedAndBackwardElements) {
    for (const GLenum mode : modes)
        for (const std::uint32_t count : {2u, 3u, 7u, batch + 1, pending, pending + 1, 3 * pending}) {
            Indices backward = consecutive(count), same(count, 5), pairs, swing;
            for (std::uint32_t i = 0; i < count; ++i) {
                backward[i] = count - 1 - i;
                pairs.push_back(i / 2);
                swing.push_back(i % 2 == 0 ? 9 : i % 3);
            }
            expect_equal(mode, backward);
            expect_equal(mode, same);
            expect_equal(mode, pairs);
            expect_equal(mode, swing);
        }
}

/// Elements that share a place in the cache come while the others of that place wait to be drawn.
TEST_F(ElementBatchesAlone, DrawElementsOfOnePlace) {
    for (const GLenum mode : modes) {
        Indices round, apart;
        for (std::uint32_t i = 0; i < 4 * pending; ++i) {
            round.push_back(i % 4 * places);
            apart.push_back(i % 3 * places + i / 5 % places);
        }
        expect_equal(mode, round);
        expect_equal(mode, apart);
        for (int time = 0; time < 40; ++time) {
            Indices some;
            for (std::uint32_t i = 0; i < pending + 20; ++i)
                some.push_back(random_() % 4 * places + random_() % 6);
            expect_equal(mode, some);
        }
    }
}

/// Elements outside of the view volume, beyond the guard band and behind the eye.
TEST_F(ElementBatchesAlone, DrawElementsThatAreNotVisible) {
    scatter(6);
    for (const bool perspective : {false, true}) {
        if (perspective) {
            glMatrixMode(GL_PROJECTION);
            glFrustum(-1, 1, -1, 1, 1, 50);
        }
        for (const GLenum mode : modes) {
            expect_equal(mode, consecutive(4 * places));
            expect_equal(mode, consecutive(pending + 1, 40));
        }
    }
    array_[20].position[0] = 3e38f;
    array_[21].position[1] = -1e-45f;
    array_[22].position[2] = -3e38f;
    for (const GLenum mode : modes)
        expect_equal(mode, consecutive(60));
}

TEST_F(ElementBatchesAlone, LightElementsAsOneByOne) {
    enable_lights();
    for (const GLenum model : {GL_SMOOTH, GL_FLAT}) {
        glShadeModel(model);
        for (const GLenum mode : modes) {
            expect_equal(mode, consecutive(pending + 2));
            Indices some;
            for (std::uint32_t i = 0; i < 3 * pending; ++i)
                some.push_back(random_() % 3 * places + random_() % 5);
            expect_equal(mode, some);
        }
    }
}

TEST_F(ElementBatchesAlone, CullTrianglesOfEachParity) {
    glEnable(GL_CULL_FACE);
    for (std::uint32_t count = 3; count < pending + 20; ++count)
        expect_equal(GL_TRIANGLE_STRIP, consecutive(count, count % 7));
}

TEST_F(ElementBatchesAlone, TextureTheElementsOfAStrip) {
    enable_coordinates();
    for (const std::uint32_t count : {3u, batch + 1, pending + 3, 3 * pending})
        expect_equal(GL_TRIANGLE_STRIP, consecutive(count));
}

TEST_F(ElementBatchesAlone, DrawLinesWithTheWidthAndColorOfTheDraw) {
    glLineWidth(7);
    for (const float color : {0.25f, 0.5f}) {
        glColor4f(color, 0, 0, 1);
        for (const GLenum mode : {GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP}) {
            expect_equal(mode, consecutive(pending + 1));
            for (const Primitive& line : of_batch(mode, consecutive(10))) {
                EXPECT_EQ(line.size, 7);
                EXPECT_NEAR(red(line.corner[0]), color, 1e-6);
            }
        }
    }
}

/// Indices of each type, from any address, up to the last one of the type.
TEST_F(ElementBatchesAlone, ReadIndicesOfEachType) {
    const std::uint32_t count = pending + 9;
    Indices indices;
    for (std::uint32_t i = 0; i < count; ++i)
        indices.push_back(i % 5 == 4 ? 255 : random_() % 256);
    std::vector<std::uint8_t> bytes(indices.begin(), indices.end());
    const std::vector<std::uint16_t> shorts(indices.begin(), indices.end());
    std::vector<std::uint8_t> unaligned(2 * count + 1);
    std::memcpy(unaligned.data() + 1, shorts.data(), std::size_t{2} * count);
    for (const GLenum mode : modes) {
        expect_equal(mode, indices, of_batch(mode, count, {GL_UNSIGNED_BYTE, 0, bytes.data()}));
        expect_equal(mode, indices, of_batch(mode, count, {GL_UNSIGNED_SHORT, 0, shorts.data()}));
        expect_equal(mode, indices, of_batch(mode, count, {GL_UNSIGNED_SHORT, 0, unaligned.data() + 1}));
        expect_equal(mode, consecutive(count, 17), of_batch(mode, count, {GL_NONE, 17, nullptr}));
    }
}

/// The line that closes a loop needs the first vertex, whose place another element may have taken.
TEST_F(ElementBatchesAlone, CloseALoopWithItsFirstElement) {
    Indices loop = consecutive(2 * places);
    loop.push_back(places); // the place of element 0, once more
    const std::vector<Primitive> lines = of_batch(GL_LINE_LOOP, loop);
    ASSERT_EQ(lines.size(), loop.size());
    EXPECT_EQ(lines.back().corner[1].x, lines.front().corner[0].x);
    EXPECT_EQ(lines.back().corner[1].y, lines.front().corner[0].y);
    expect_equal(GL_LINE_LOOP, loop);
}

/// A draw leaves no vertex waiting: one that did would be drawn, or left out, with the next draw.
TEST_F(ElementBatchesAlone, LeaveNoElementWaiting) {
    for (const GLenum mode : modes)
        for (const std::uint32_t count : counts) {
            of_batch(mode, consecutive(count));
            for (std::uint32_t i = 0; i < places; ++i)
                ASSERT_EQ(part_->cache_.element(i).flags & gl::is_pending, 0u)
                    << mode << ' ' << count << ' ' << i;
        }
}

/// The memory of elements changes between two draws.
TEST_F(ElementBatchesAlone, ReadTheMemoryOfTheirTime) {
    for (const GLenum mode : modes)
        for (int time = 0; time < 3; ++time) {
            scatter(0.8f);
            expect_equal(mode, consecutive(pending + 5));
        }
}

} // namespace
} // namespace spangle::test

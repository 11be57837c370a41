// The part with the cache alone: which elements it processes anew, and which memory a vertex gets.
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "gl/vertex/cached_vertices.hpp"
#include "tests/gl/vertex/vertex_parts.hpp"

namespace spangle::test {
namespace {

using CachedVertices = gl::CachedVertices<gl::FixedMath, gl::FixedLighting>;

struct CachedPart : Alone<CachedVertices> {
    using CachedVertices::cache_;
    using CachedVertices::color;
    using CachedVertices::unlit_;
};

/// Number of elements that a small cache holds. Indices that differ by this share a place.
constexpr std::uint32_t places = 128;

class CachedVerticesAlone : public VertexParts {
  protected:
    struct Element {
        GLfloat position[3], normal[3], st[2];
    };

    const std::unique_ptr<CachedPart> part_ = std::make_unique<CachedPart>();
    std::vector<Element> array_ = std::vector<Element>(3 * places);
    bool normals_ = false, textured_ = false;

    static gl::Context& context() { return *gl::current_context(); }
    void SetUp() override {
        VertexParts::SetUp();
        for (std::size_t i = 0; i < array_.size(); ++i) {
            const auto x = static_cast<float>(i) / 512;
            array_[i] = {{x, -x, x / 2}, {0, 0, 1}, {x, 1 - x}};
        }
        glEnableClientState(GL_VERTEX_ARRAY);
        glVertexPointer(3, GL_FLOAT, sizeof(Element), array_[0].position);
    }
    void enable_normals() {
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
    static gl::ElementReader reader() { return gl::ElementReader(context().arrays); }
    /// Begins a draw of a few elements, as Pipeline does.
    void begin(GLenum mode = GL_TRIANGLES) {
        const gl::Stale stale = part_->begin(mode);
        if (stale == gl::Stale::all)
            part_->cache_.invalidate();
        else if (stale == gl::Stale::colors)
            part_->cache_.invalidate_colors();
        part_->cache_.hold_elements(context(), places);
        normals_ = part_->modes_.is_lit() && reader().normal.on();
        textured_ = part_->is_common_texture(reader());
        part_->arrays_begin(reader(), context().current, textured_);
        if (!part_->modes_.is_lit())
            part_->set_unlit_color(context().current);
    }
    Vertex& common(std::uint32_t index) {
        return part_->common_element(
            reader(), index, normals_, textured_,
            [this](Vertex& cached) -> Vertex& { return part_->slot_for_vertex(cached); },
            [this](Vertex& v, const std::uint8_t* words) { part_->process_common(v, words); });
    }
    /// The vertex of an element that nothing keeps.
    Vertex fresh(std::uint32_t index) const {
        const GLfloat* const p = array_[index].position;
        Vertex v;
        for (int c = 0; c < 3; ++c)
            v.position[c] = numeric::from_float(p[c]);
        v.set_normal(context().current.normal);
        part_->transform_vertex(v);
        part_->set_attributes_of(context().current, v);
        return v;
    }
    /// True if a function gives the element of an array without processing it. Its x is changed before and
    /// restored, so that a vertex that is processed anew shows.
    template <class Give> bool is_kept(const Give& give, std::uint32_t index) {
        Vertex& before = give(index);
        const std::int32_t x = before.window.x;
        before.window.x = x + 1;
        Vertex& after = give(index);
        const bool kept = &after == &before && after.window.x == x + 1;
        after.window.x = x;
        return kept;
    }
    bool keeps(std::uint32_t index) {
        return is_kept([this](std::uint32_t i) -> Vertex& { return common(i); }, index);
    }
    /// A marked vertex shows that it was not processed again.
    static void mark(Vertex& v) { v.window.x += 1; }
    bool is_marked(std::uint32_t index) { return common(index).window.x == fresh(index).window.x + 1; }
};

TEST_F(CachedVerticesAlone, ProcessesAnElementAsAnyVertex) {
    begin();
    for (const std::uint32_t index : {0u, 1u, 127u, 128u, 383u, 0u, 255u}) {
        const Vertex expected = fresh(index);
        for (const Vertex* v : {&common(index), &part_->general_element(context(), reader(), index)}) {
            EXPECT_TRUE(is_at(v->window, expected)) << index;
            EXPECT_EQ(v->window.z, expected.window.z);
            EXPECT_EQ(v->flags, expected.flags);
            EXPECT_EQ(red(v->window), 1);
        }
    }
}

TEST_F(CachedVerticesAlone, ProcessesAnElementOnceWhileItsMemoryIsTheSame) {
    begin();
    EXPECT_TRUE(keeps(5));
    EXPECT_TRUE(keeps(383)); // the last element
    EXPECT_TRUE(is_kept([this](std::uint32_t i) -> Vertex& { return part_->element(reader(), i); }, 7));
}

TEST_F(CachedVerticesAlone, ComparesEachCoordinateWithTheMemory) {
    glEnable(GL_LIGHTING);
    enable_normals();
    enable_coordinates();
    begin();
    ASSERT_TRUE(normals_ && textured_);
    Element& element = array_[9];
    GLfloat* const values[] = {&element.position[0], &element.position[1], &element.position[2],
                               &element.normal[0],   &element.normal[1],   &element.normal[2],
                               &element.st[0],       &element.st[1]};
    for (GLfloat* const value : values) {
        mark(common(9));
        ASSERT_TRUE(is_marked(9));
        *value += 0.125f;
        EXPECT_FALSE(is_marked(9)) << value - &element.position[0];
    }
}

/// -0 and 0 are different words, and so are numbers that differ in the last bit.
TEST_F(CachedVerticesAlone, ComparesWordsNotNumbers) {
    begin();
    const GLfloat values[] = {0.0f, -0.0f, 1e-45f, 0.5f, 0.50000006f};
    for (const GLfloat value : values) {
        array_[3].position[1] = value;
        const Vertex& v = common(3);
        EXPECT_EQ(v.position[1].bits, numeric::from_float(value).bits);
        EXPECT_TRUE(is_at(v.window, fresh(3)));
        EXPECT_TRUE(keeps(3));
    }
}

TEST_F(CachedVerticesAlone, ProcessesAnElementAnewAfterAnotherOfItsPlace) {
    begin();
    mark(common(1));
    EXPECT_TRUE(is_marked(1));
    common(1 + places);
    EXPECT_FALSE(is_marked(1));
    array_[1 + 2 * places] = array_[1]; // equal memory is an equal vertex, whichever index brings it
    mark(common(1));
    EXPECT_TRUE(is_marked(1 + 2 * places));
}

/// A corner of the current primitive stays, although other elements come to its place.
TEST_F(CachedVerticesAlone, ChangesNoCornerOfTheCurrentPrimitive) {
    for (const bool is_common : {true, false}) {
        begin(GL_QUADS);
        std::vector<Vertex*> corners;
        for (const std::uint32_t index : {4u, 4 + places, 4 + 2 * places, 4u}) {
            Vertex& v = is_common ? common(index) : part_->general_element(context(), reader(), index);
            EXPECT_TRUE(is_at(v.window, fresh(index))) << index;
            part_->assembler_.set_next(v);
            part_->assembler_.take_next();
            corners.push_back(&v);
        }
        EXPECT_TRUE(is_at(corners[0]->window, fresh(4)));
        EXPECT_TRUE(is_at(corners[1]->window, fresh(4 + places)));
        EXPECT_TRUE(is_at(corners[2]->window, fresh(4 + 2 * places)));
        EXPECT_TRUE(is_at(corners[3]->window, fresh(4)));
    }
}

/// An element that comes twice in a primitive may have another colour the second time.
TEST_F(CachedVerticesAlone, CopiesACornerThatGetsAnotherColor) {
    GLfloat color[4] = {0.25f, 0, 0, 1};
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(4, GL_FLOAT, 0, color);
    begin();
    EXPECT_FALSE(part_->is_common(reader()));
    Vertex& first = part_->general_element(context(), reader(), 0);
    part_->assembler_.set_next(first);
    part_->assembler_.take_next();
    color[0] = 0.75f;
    Vertex& second = part_->general_element(context(), reader(), 0);
    EXPECT_NE(&first, &second);
    EXPECT_NEAR(red(first.window), 0.25f, 1e-6);
    EXPECT_NEAR(red(second.window), 0.75f, 1e-6);
    EXPECT_TRUE(is_at(second.window, first));
}

TEST_F(CachedVerticesAlone, ForgetsPlacesWhenMatricesChange) {
    begin();
    mark(common(1));
    begin();
    EXPECT_TRUE(is_marked(1));
    glTranslatef(0.25f, 0, 0);
    begin();
    EXPECT_FALSE(is_marked(1));
    EXPECT_TRUE(is_at(common(1).window, fresh(1)));
}

TEST_F(CachedVerticesAlone, ColorsAKeptVertexWithTheCurrentColor) {
    for (const float color : {0.25f, 0.75f, 0.75f, 0.5f}) {
        glColor4f(color, 0, 0, 1);
        begin();
        EXPECT_NEAR(red(common(1).window), color, 1e-6);
        EXPECT_NEAR(red(common(2).window), color, 1e-6);
        EXPECT_TRUE(is_at(common(1).window, fresh(1)));
    }
}

/// A vertex that was lit with another material is to be lit again. Its place stays.
TEST_F(CachedVerticesAlone, LightsAKeptVertexAgainAfterTheMaterialChanged) {
    glEnable(GL_LIGHTING);
    enable_normals();
    begin();
    Vertex& v = common(1);
    part_->color(v);
    EXPECT_EQ(common(1).flags & gl::uncolored, 0u);
    const GLfloat emission[4] = {1, 0, 0, 1};
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, emission);
    mark(v);
    begin();
    EXPECT_EQ(is_marked(1), gl::VertexCache<gl::FixedMath>::keeps_positions);
    EXPECT_NE(common(1).flags & gl::uncolored, 0u);
}

/// Elements take the current normal if no array has normals. A kept vertex does not record whence it was.
TEST_F(CachedVerticesAlone, ForgetsPlacesWhenTheCurrentNormalChanges) {
    glEnable(GL_LIGHTING);
    glNormal3f(0, 0, 1);
    begin();
    mark(common(1));
    begin();
    EXPECT_TRUE(is_marked(1));
    glNormal3f(1, 0, 0);
    begin();
    EXPECT_FALSE(is_marked(1));
    EXPECT_EQ(common(1).normal[0].bits, numeric::one.bits);
    enable_normals(); // another layout: the same words mean something else
    begin();
    EXPECT_EQ(common(1).normal[0].bits, numeric::zero.bits);
    EXPECT_EQ(common(1).normal[2].bits, numeric::one.bits);
}

TEST_F(CachedVerticesAlone, KnowsTheArraysThatAreCommon) {
    const auto is_common = [this] {
        begin();
        return part_->is_common(reader());
    };
    EXPECT_TRUE(is_common());
    GLdouble doubles[12] = {};
    glVertexPointer(3, GL_DOUBLE, 0, doubles);
    EXPECT_FALSE(is_common());
    for (const GLint components : {2, 4}) {
        glVertexPointer(components, GL_FLOAT, sizeof(Element), array_[0].position);
        EXPECT_FALSE(is_common()) << components;
    }
    glVertexPointer(3, GL_FLOAT, sizeof(Element) + 1, array_[0].position); // elements that are not aligned
    EXPECT_FALSE(is_common());
    glVertexPointer(3, GL_FLOAT, sizeof(Element), array_[0].position);
    GLbyte bytes[12] = {};
    glEnableClientState(GL_NORMAL_ARRAY);
    glNormalPointer(GL_BYTE, 0, bytes);
    EXPECT_TRUE(is_common()); // nobody reads the normals of unlit vertices
    glEnable(GL_LIGHTING);
    EXPECT_FALSE(is_common());
    enable_normals();
    EXPECT_TRUE(is_common());
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, bytes);
    EXPECT_FALSE(is_common());
}

TEST_F(CachedVerticesAlone, KnowsTheTexturesThatAreCommon) {
    const auto is_common = [this](GLenum mode = GL_TRIANGLES) {
        begin(mode);
        return part_->is_common_texture(reader());
    };
    EXPECT_FALSE(is_common()); // no unit is enabled
    enable_coordinates();
    EXPECT_TRUE(is_common());
    EXPECT_TRUE(is_common(GL_POINTS));
    EXPECT_TRUE(is_common(GL_POLYGON));
    for (const GLenum mode : {GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP})
        EXPECT_FALSE(is_common(mode));
    glEnable(GL_TEXTURE_GEN_S);
    EXPECT_FALSE(is_common());
    glDisable(GL_TEXTURE_GEN_S);
    glTexCoordPointer(3, GL_FLOAT, sizeof(Element), array_[0].position);
    EXPECT_FALSE(is_common());
    enable_coordinates();
    glClientActiveTexture(GL_TEXTURE1);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glTexCoordPointer(2, GL_FLOAT, sizeof(Element), array_[0].st);
    EXPECT_FALSE(is_common());
}

TEST_F(CachedVerticesAlone, GivesAnElementItsTextureCoordinates) {
    enable_coordinates();
    begin();
    ASSERT_TRUE(textured_);
    for (int time = 0; time < 2; ++time) {
        const auto& tex = common(64).window.tex[0];
        EXPECT_EQ(std::ldexp(tex.s, tex.exponent), array_[64].st[0]);
        EXPECT_EQ(std::ldexp(tex.t, tex.exponent), array_[64].st[1]);
        array_[64].st[1] = 0.25f;
    }
}

/// Positions of any size, many of them twice. What the cache gives is what a vertex gets without it.
TEST_F(CachedVerticesAlone, PlacesGivenVerticesAsWithoutTheCache) {
    std::mt19937 random(11);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 50);
    for (const bool lit : {false, true}) {
        if (lit)
            glEnable(GL_LIGHTING);
        begin();
        for (int i = 0; i < 20000; ++i) {
            Vertex v;
            for (int c = 0; c < 4; ++c) {
                const int word = static_cast<int>(random() % 9) - 4;
                v.position[c] = numeric::from_float(c == 3 ? (word == 0 ? 2.0f : 1.0f)
                                                           : std::ldexp(static_cast<float>(word), i % 7 - 3));
            }
            v.flags = gl::edge_flag;
            v.window = {};
            Vertex expected = v;
            part_->transform_vertex(expected);
            part_->transform_with_cache(v);
            ASSERT_EQ(v.flags, expected.flags);
            if ((v.flags & gl::unprojected) != 0)
                continue;
            ASSERT_TRUE(is_at(v.window, expected));
            ASSERT_EQ(v.window.z, expected.window.z);
            ASSERT_EQ(v.window.w_mantissa, expected.window.w_mantissa);
            ASSERT_EQ(v.window.w_exponent, expected.window.w_exponent);
        }
    }
}

/// An arena without room for a large cache: the small cache stays, and all elements are right.
TEST_F(CachedVerticesAlone, DrawsManyElementsWithoutMemoryForThem) {
    const auto poor = std::make_unique<gl::Context>();
    std::uint64_t memory[64];
    gl::Arena arena;
    arena.give(memory, sizeof memory);
    poor->arena = &arena;
    begin();
    part_->cache_.hold_elements(*poor, 100000);
    EXPECT_EQ(poor->render.kept_vertices, nullptr);
    EXPECT_EQ(arena.used(), 0u);
    for (std::uint32_t i = 0; i < array_.size(); ++i)
        ASSERT_TRUE(is_at(common(i).window, fresh(i))) << i;
    for (std::uint32_t i = static_cast<std::uint32_t>(array_.size()); i-- > 0;)
        ASSERT_TRUE(is_at(common(i).window, fresh(i))) << i;
}

} // namespace
} // namespace spangle::test

// Row A05: a vertex has the same window x, y, z and 1/w, texture coordinates and fog distance, however it is
// given. It may come alone, in a batch of any mode, from arrays, from a list, or through every entry point
// that can hold it.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/vertex_forms.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {

class Invariance : public Canvas {
  protected:
    /// Draws `count` vertices, 250 to a set of random matrices, and reports how many of them were in the view
    /// volume.
    void run(int count, std::uint32_t seed) {
        random_.seed(seed);
        colors();
        for (int done = 0; done < count; done += static_cast<int>(group_size)) {
            matrices();
            vertices();
            SCOPED_TRACE("group at " + std::to_string(done));
            group();
            if (HasFailure())
                return;
        }
        const double share = static_cast<double>(visible_) / count;
        std::printf("%d vertices, %.1f %% in the volume, seen %llu times", count, 100 * share,
                    static_cast<unsigned long long>(compared_));
        std::printf(", in %zu ways\n", ways_.size());
        EXPECT_GT(share, 0.4);
        for (const auto& [way, seen] : ways_)
            EXPECT_GT(seen, 0u) << way;
        EXPECT_EQ(ways_.size(), way_count);
    }

  private:
    static constexpr std::size_t group_size = 250;
    /// The ways to give a vertex. Alone: first, in 30 forms, after other state. Then 2 lists, 10 modes,
    /// DrawArrays and ArrayElement of 5 types and 3 sizes, interleaved arrays, 3 kinds of indices, a list of
    /// indices, and strips of them.
    static constexpr std::size_t way_count = 1 + 30 + 1 + 2 + 10 + 5 * 3 * 2 + 1 + 3 + 1 + 1;

    std::mt19937 random_;
    std::vector<Position> position_;
    struct Seen {
        bool known = false;
        raster::FixedVertex vertex;
    };
    std::array<Seen, group_size> seen_;
    std::array<bool, group_size> alone_; ///< whether the vertex is drawn as a point
    std::array<std::array<GLubyte, 4>, group_size> color_;
    std::array<raster::FixedVertex, group_size> colored_; ///< the same colours as the rasterizer gets them
    std::array<std::array<GLfloat, 4>, group_size> tex_coord_;
    std::uint64_t compared_ = 0;
    int visible_ = 0;
    std::map<std::string, std::uint64_t> ways_;

    double uniform(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }
    int whole(int low, int high) { return std::uniform_int_distribution<>(low, high)(random_); }
    std::size_t any() { return static_cast<std::size_t>(whole(0, group_size - 1)); }

    // --- Random vertices and state

    enum Kind { wide, shorts, ints, fixed };
    Kind kind_ = wide;
    int object_exponent_ = 0; ///< objects have a size of about 2^this

    void matrices() {
        kind_ = static_cast<Kind>(whole(0, 3));
        object_exponent_ = kind_ == wide ? whole(-60, 60) : kind_ == shorts ? 11 : kind_ == ints ? 21 : 7;
        const int eye_exponent = whole(-20, 20);
        const double unit = std::ldexp(uniform(0.5, 1), eye_exponent);
        glViewport(whole(-40, 40), whole(-40, 40), whole(1, 700), whole(1, 700));
        glDepthRange(uniform(-0.2, 1.2), uniform(-0.2, 1.2));
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        const bool perspective = whole(0, 1) != 0;
        if (perspective)
            glFrustum(-unit * uniform(0.5, 1.5), unit, -unit, unit * uniform(0.5, 1.5), unit, 40 * unit);
        else
            glOrtho(-16 * unit, 17 * unit, -15 * unit, 16 * unit, -18 * unit, 16 * unit);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        glTranslated(unit * uniform(-3, 3), unit * uniform(-3, 3), perspective ? -20 * unit : 0);
        glRotated(uniform(-400, 400), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
        const double scale = std::ldexp(unit, 4 - object_exponent_);
        glScaled(scale * uniform(0.5, 1.5), scale * uniform(0.5, 1.5), scale * uniform(0.5, 1.5));
        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        if (whole(0, 1) != 0) {
            glRotated(uniform(0, 360), 0, 0, 1);
            glScaled(uniform(-8, 8), uniform(-8, 8), 1);
        }
        glMatrixMode(GL_MODELVIEW);
    }

    double coordinate() {
        const double v = std::ldexp(uniform(-1, 1), object_exponent_);
        if (kind_ == wide)
            return static_cast<float>(v);
        return kind_ == fixed ? std::floor(v * 65536) / 65536 : std::floor(v);
    }

    /// Red is the number of the vertex. Green and blue are random, so a colour that clipping mixes is none of
    /// the colours.
    void colors() {
        for (std::size_t i = 0; i < group_size; ++i) {
            color_[i] = {static_cast<GLubyte>(i), static_cast<GLubyte>(whole(0, 255)),
                         static_cast<GLubyte>(whole(0, 255)), 255};
            WindowRecorder recorder;
            glColor4ubv(color_[i].data());
            glBegin(GL_POINTS);
            glVertex2f(0, 0);
            glEnd();
            ASSERT_EQ(recorder.primitives.size(), 1u);
            colored_[i] = recorder.primitives[0].corner[0];
        }
    }

    void vertices() {
        glEnable(GL_TEXTURE_2D);
        glEnable(GL_FOG);
        position_.resize(group_size);
        const int dimensions = whole(2, 4); // the same for all vertices, so that arrays can hold them
        // The w of vertices are similar: a cut at 2^-30 of an edge keeps the colour and yet moves a small w.
        const int w_exponent = whole(-30, 30);
        for (std::size_t i = 0; i < group_size; ++i) {
            const double w = dimensions < 4  ? 1
                             : kind_ == wide ? std::ldexp(uniform(1, 9), w_exponent)
                                             : whole(1, 3);
            position_[i] = {coordinate() * w, coordinate() * w, dimensions > 2 ? coordinate() * w : 0, w};
            if (kind_ == wide)
                for (double& v : position_[i])
                    v = static_cast<float>(v);
            for (GLfloat& c : tex_coord_[i])
                c = static_cast<float>(std::ldexp(uniform(-1, 1), whole(-5, 5)));
            seen_[i].known = alone_[i] = false;
        }
    }

    void attributes(std::size_t i) {
        glColor4ubv(color_[i].data());
        glTexCoord4fv(tex_coord_[i].data());
    }

    /// Returns a form that can hold the vertex.
    const VertexForm& any_form(const Position& p) {
        for (;;) {
            const VertexForm& form = vertex_forms[whole(0, 29)];
            if (holds(form.type, form.size, p))
                return form;
        }
    }

    // --- Comparison

    static bool same(const raster::FixedVertex& a, const raster::FixedVertex& b) {
        return a.x == b.x && a.y == b.y && a.z == b.z && a.w_mantissa == b.w_mantissa &&
               a.w_exponent == b.w_exponent && a.fog_mantissa == b.fog_mantissa &&
               a.fog_exponent == b.fog_exponent && a.tex[0].s == b.tex[0].s && a.tex[0].t == b.tex[0].t &&
               a.tex[0].q == b.tex[0].q && a.tex[0].exponent == b.tex[0].exponent &&
               a.tex[0].q_is_one == b.tex[0].q_is_one;
    }

    /// Red as a number: in 255ths with 20 fraction bits, rounded because k / 255 is not a float.
    static std::size_t index(const raster::FixedVertex& v) { return (v.color[0] + (1u << 19)) >> 20; }

    void compare(const std::string& way, std::size_t i, const raster::FixedVertex& v) {
        ASSERT_LT(i, group_size);
        ++compared_;
        ++ways_[way];
        Seen& seen = seen_[i];
        if (!seen.known) {
            seen = {true, v};
            return;
        }
        const raster::FixedVertex& first = seen.vertex;
        ASSERT_TRUE(same(first, v)) << way << ", vertex " << i << ": x " << v.x << " not " << first.x
                                    << ", y " << v.y << " not " << first.y << ", z " << v.z << " not "
                                    << first.z << ", 1/w " << v.w_mantissa << " 2^" << v.w_exponent << " not "
                                    << first.w_mantissa << " 2^" << first.w_exponent;
    }

    bool as_given(const raster::FixedVertex& v) const {
        const std::size_t i = index(v);
        return i < group_size && std::equal(v.color, v.color + 3, colored_[i].color);
    }

    /// Compares the vertices that clipping did not make.
    void compare(const std::string& way, const WindowRecorder& recorder) {
        for (const Primitive& p : recorder.primitives)
            for (int c = 0; c < p.corners && !HasFailure(); ++c)
                if (as_given(p.corner[c]))
                    compare(way, index(p.corner[c]), p.corner[c]);
    }

    /// `draw` gives points in this order. Exactly those that are drawn alone must come out.
    template <class Draw>
    void points(const std::string& way, const std::vector<std::size_t>& order, Draw draw) {
        if (HasFailure())
            return; // one failure is enough to read
        ways_[way] += 0;
        WindowRecorder recorder;
        draw();
        std::vector<std::size_t> expected;
        for (const std::size_t i : order)
            if (alone_[i])
                expected.push_back(i);
        ASSERT_EQ(recorder.primitives.size(), expected.size()) << way;
        for (std::size_t k = 0; k < expected.size(); ++k) {
            ASSERT_EQ(index(recorder.primitives[k].corner[0]), expected[k]) << way;
            compare(way, expected[k], recorder.primitives[k].corner[0]);
        }
    }

    std::vector<std::size_t> in_order() {
        std::vector<std::size_t> order(group_size);
        for (std::size_t i = 0; i < group_size; ++i)
            order[i] = i;
        return order;
    }
    std::vector<std::size_t> at_random() {
        std::vector<std::size_t> order(group_size);
        std::generate(order.begin(), order.end(), [this] { return any(); });
        return order;
    }

    // --- The ways to give vertices

    void group() {
        first_alone();
        for (const VertexForm& form : vertex_forms)
            each_alone(form);
        listed_alone();
        listed_together();
        for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode)
            batch(mode);
        arrays();
        interleaved();
        after_other_state();
    }

    void first_alone() {
        for (std::size_t i = 0; i < group_size; ++i) {
            WindowRecorder recorder;
            attributes(i);
            glBegin(GL_POINTS);
            glVertex4d(position_[i][0], position_[i][1], position_[i][2], position_[i][3]);
            glEnd();
            alone_[i] = !recorder.primitives.empty();
            visible_ += alone_[i] ? 1 : 0;
            compare("alone, first", recorder);
        }
    }

    void each_alone(const VertexForm& form) {
        for (std::size_t i = 0; i < group_size; ++i)
            if (holds(form.type, form.size, position_[i]))
                points(form.name, {i}, [&] {
                    attributes(i);
                    glBegin(GL_POINTS);
                    form.give(position_[i]);
                    glEnd();
                });
    }

    void listed_alone() {
        const GLuint list = glGenLists(1);
        for (std::size_t i = 0; i < group_size; ++i) {
            glNewList(list, GL_COMPILE);
            glBegin(GL_POINTS);
            attributes(i);
            any_form(position_[i]).give(position_[i]);
            glEnd();
            glEndList();
            points("list of one", {i}, [list] { glCallList(list); });
        }
        glDeleteLists(list, 1);
    }

    /// Puts all vertices in all their forms into one list.
    void listed_together() {
        const GLuint list = glGenLists(1);
        std::vector<std::size_t> order;
        glNewList(list, GL_COMPILE);
        glBegin(GL_POINTS);
        for (const std::size_t i : at_random()) {
            attributes(i);
            for (const VertexForm& form : vertex_forms)
                if (holds(form.type, form.size, position_[i])) {
                    form.give(position_[i]);
                    order.push_back(i);
                }
        }
        glEnd();
        glEndList();
        points("list of all", order, [list] { glCallList(list); });
        glDeleteLists(list, 1);
    }

    /// Draws random vertices in random order, between some that lie far outside.
    void batch(GLenum mode) {
        const std::string way = "batch of mode " + std::to_string(mode);
        ways_[way] += 0;
        WindowRecorder recorder;
        const bool short_ones = mode == GL_TRIANGLE_FAN || mode == GL_POLYGON || mode == GL_LINE_LOOP;
        glBegin(mode);
        for (std::size_t n = 0; n < group_size; ++n) {
            if (short_ones && n % 7 == 0) {
                glEnd();
                glBegin(mode);
            }
            const std::size_t i = any();
            attributes(i);
            Position p = position_[i];
            if (whole(0, 9) == 0) {
                glColor4ub(255, 255, 0, 255); // the colour of no vertex
                for (int c = 0; c < 2; ++c)
                    p[static_cast<std::size_t>(c)] *= 1024;
            }
            any_form(p).give(p);
        }
        glEnd();
        compare(way, recorder);
    }

    template <class T> static void put(std::vector<GLubyte>& bytes, std::size_t at, T v) {
        __builtin_memcpy(bytes.data() + at, &v, sizeof v);
    }
    static void put(std::vector<GLubyte>& bytes, std::size_t at, Scalar type, double v) {
        switch (type) {
        case Scalar::s16:
            return put(bytes, at, typed<GLshort>(type, v));
        case Scalar::f32:
            return put(bytes, at, typed<GLfloat>(type, v));
        case Scalar::f64:
            return put(bytes, at, v);
        default:
            return put(bytes, at, typed<GLint>(type, v));
        }
    }

    void arrays() {
        glEnableClientState(GL_COLOR_ARRAY);
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
        glEnableClientState(GL_VERTEX_ARRAY);
        glColorPointer(4, GL_UNSIGNED_BYTE, 0, color_.data());
        glTexCoordPointer(4, GL_FLOAT, 0, tex_coord_.data());
        const struct {
            Scalar type;
            GLenum token;
            std::size_t bytes;
            const char* name;
        } types[] = {{Scalar::s16, GL_SHORT, 2, "short"},
                     {Scalar::i32, GL_INT, 4, "int"},
                     {Scalar::f32, GL_FLOAT, 4, "float"},
                     {Scalar::f64, GL_DOUBLE, 8, "double"},
                     {Scalar::fixed, GL_FIXED, 4, "fixed"}};
        for (const auto& type : types)
            for (int size = 2; size <= 4; ++size) {
                if (!std::all_of(position_.begin(), position_.end(),
                                 [&](const Position& p) { return holds(type.type, size, p); }))
                    continue;
                const std::size_t stride = type.bytes * static_cast<std::size_t>(size) +
                                           static_cast<std::size_t>(whole(0, 1) * whole(0, 9));
                std::vector<GLubyte> bytes(stride * group_size);
                for (std::size_t i = 0; i < group_size; ++i)
                    for (int c = 0; c < size; ++c)
                        put(bytes, i * stride + static_cast<std::size_t>(c) * type.bytes, type.type,
                            position_[i][static_cast<std::size_t>(c)]);
                const bool packed = stride == type.bytes * static_cast<std::size_t>(size);
                glVertexPointer(size, type.token, packed ? 0 : static_cast<GLsizei>(stride), bytes.data());
                draw_arrays(std::string("array of ") + type.name + std::to_string(size));
            }
        glDisableClientState(GL_COLOR_ARRAY);
        glDisableClientState(GL_TEXTURE_COORD_ARRAY);
        glDisableClientState(GL_VERTEX_ARRAY);
    }

    template <class T> static std::vector<T> indices(const std::vector<std::size_t>& order) {
        return {order.begin(), order.end()};
    }

    void draw_arrays(const std::string& way) {
        points(way, in_order(), [] { glDrawArrays(GL_POINTS, 0, group_size); });
        const std::vector<std::size_t> order = at_random();
        constexpr auto n = static_cast<GLsizei>(group_size);
        points("DrawElements, ubyte", order,
               [&] { glDrawElements(GL_POINTS, n, GL_UNSIGNED_BYTE, indices<GLubyte>(order).data()); });
        points("DrawElements, ushort", order,
               [&] { glDrawElements(GL_POINTS, n, GL_UNSIGNED_SHORT, indices<GLushort>(order).data()); });
        points("DrawRangeElements, uint", order, [&] {
            glDrawRangeElements(GL_POINTS, 0, n - 1, n, GL_UNSIGNED_INT, indices<GLuint>(order).data());
        });
        points(way + ", ArrayElement", order, [&] {
            glBegin(GL_POINTS);
            for (const std::size_t i : order)
                glArrayElement(static_cast<GLint>(i));
            glEnd();
        });
        const GLuint list = glGenLists(1);
        glNewList(list, GL_COMPILE);
        glDrawElements(GL_POINTS, n, GL_UNSIGNED_BYTE, indices<GLubyte>(order).data());
        glEndList();
        points("list of DrawElements", order, [list] { glCallList(list); });
        glDeleteLists(list, 1);
        WindowRecorder recorder;
        glDrawElements(GL_TRIANGLE_STRIP, n, GL_UNSIGNED_BYTE, indices<GLubyte>(order).data());
        compare("strips by DrawElements", recorder);
    }

    void interleaved() {
        std::vector<std::array<GLfloat, 15>> elements(group_size);
        for (std::size_t i = 0; i < group_size; ++i) {
            elements[i] = {};
            for (std::size_t c = 0; c < 4; ++c) {
                elements[i][4 + c] = static_cast<float>(color_[i][c]) / 255;
                elements[i][c] = tex_coord_[i][c];
                elements[i][11 + c] = static_cast<float>(position_[i][c]);
            }
        }
        glInterleavedArrays(GL_T4F_C4F_N3F_V4F, 0, elements.data());
        ways_["interleaved"] += 0;
        {
            WindowRecorder recorder;
            glDrawArrays(GL_POINTS, 0, group_size);
            compare("interleaved", recorder);
        }
        for (const GLenum array : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY})
            glDisableClientState(array);
    }

    /// Changes state that must not matter (GL 1.3, appendix A.3, rule 2), and matrices that are restored.
    void after_other_state() {
        glPushMatrix();
        glLoadIdentity();
        glBegin(GL_POINTS);
        glVertex2f(0.25f, 0.25f);
        glEnd();
        glPopMatrix();
        glScissor(whole(0, 9), whole(0, 9), whole(0, 9), whole(0, 9));
        glClearColor(0.5f, 0, 0, 0);
        glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
        glNormal3f(0, 1, 0);
        glShadeModel(whole(0, 1) != 0 ? GL_FLAT : GL_SMOOTH);
        const GLfloat material[4] = {0.5f, 0.5f, 0.5f, 1};
        glMaterialfv(GL_FRONT, GL_DIFFUSE, material);
        for (std::size_t i = 0; i < group_size; ++i)
            points("alone, after other state", {i}, [&] {
                attributes(i);
                glBegin(GL_POINTS);
                any_form(position_[i]).give(position_[i]);
                glEnd();
            });
    }
};

} // namespace spangle::test

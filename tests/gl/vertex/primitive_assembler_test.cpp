// The assembler of primitives, with vertices that are numbers and a sink that writes down what it is told.
// What it must tell is taken from GL 1.3, 2.6.1, and from the provoking vertices of GL 1.3, 2.13.7.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gl/vertex/primitive_assembler.hpp"

namespace spangle::test {
namespace {

struct Numbered {
    int number = -1;
};
using Assembler = gl::PrimitiveAssembler<Numbered>;

/// Writes "kind corners". The provoking vertex of a line is its second one. Of a triangle or quad it is
/// corner 2, and of a fan corner 0.
struct Listing {
    std::vector<std::string> told;

    void write(const char* kind, std::initializer_list<const Numbered*> corners) {
        std::string line = kind;
        for (const Numbered* v : corners)
            line += " " + std::to_string(v->number);
        told.push_back(line);
    }
    void point(const Numbered& v) { write("point", {&v}); }
    void line(const Numbered& a, const Numbered& b) { write("line", {&a, &b}); }
    void triangle(Numbered* const* c) { write("triangle", {c[0], c[1], c[2]}); }
    void quad(Numbered* const* c) { write("quad", {c[0], c[1], c[2], c[3]}); }
    void fan(Numbered* const* c) { write("fan", {c[0], c[1], c[2]}); }
    void outlined_fan(Numbered* const* c, bool first, bool last) {
        write(first ? last ? "only" : "first" : last ? "last" : "middle", {c[0], c[1], c[2]});
    }
    void gather(const Numbered& v) { write("corner", {&v}); }
    void gathered() { write("end", {}); }
};

/// What an assembler tells of vertices 0 to n - 1. Vertices are placed as Vertex commands place them, or lie
/// in an array.
std::vector<std::string> assembled(GLenum mode, int n, bool in_array,
                                   gl::PolygonForm form = gl::PolygonForm::filled) {
    Numbered slots[Assembler::slot_count];
    std::vector<Numbered> array(static_cast<std::size_t>(n));
    Assembler assembler;
    Listing sink;
    assembler.begin(mode, slots);
    if (mode == GL_POLYGON)
        assembler.set_form(form);
    for (int i = 0; i < n; ++i) {
        if (in_array)
            assembler.set_next(array[static_cast<std::size_t>(i)]);
        assembler.next().number = i;
        if (assembler.take_next())
            assembler.complete(sink);
    }
    assembler.end(sink);
    return sink.told;
}

using Told = std::vector<std::string>;

struct Expected {
    GLenum mode;
    int n;
    Told told;
};

TEST(PrimitiveAssemblerAlone, TellsThePrimitivesOfEachMode) {
    const Expected expected[] = {
        {GL_POINTS, 3, {"point 0", "point 1", "point 2"}},
        {GL_LINES, 5, {"line 0 1", "line 2 3"}},
        {GL_LINE_STRIP, 4, {"line 0 1", "line 1 2", "line 2 3"}},
        {GL_LINE_LOOP, 4, {"line 0 1", "line 1 2", "line 2 3", "line 3 0"}},
        {GL_LINE_LOOP, 2, {"line 0 1", "line 1 0"}},
        {GL_LINE_LOOP, 1, {}},
        {GL_TRIANGLES, 7, {"triangle 0 1 2", "triangle 3 4 5"}},
        // Odd triangles begin with the second vertex, so that all have the same winding.
        {GL_TRIANGLE_STRIP, 6, {"triangle 0 1 2", "triangle 2 1 3", "triangle 2 3 4", "triangle 4 3 5"}},
        {GL_TRIANGLE_FAN, 5, {"triangle 0 1 2", "triangle 0 2 3", "triangle 0 3 4"}},
        // A quad of QUADS is provoked by its last vertex, and one of a strip by the last that is given.
        {GL_QUADS, 9, {"quad 1 2 3 0", "quad 5 6 7 4"}},
        {GL_QUAD_STRIP, 7, {"quad 0 1 3 2", "quad 2 3 5 4"}},
        {GL_POLYGON, 5, {"fan 0 1 2", "fan 0 2 3", "fan 0 3 4"}},
    };
    for (const Expected& e : expected)
        for (const bool in_array : {false, true})
            EXPECT_EQ(assembled(e.mode, e.n, in_array), e.told)
                << "mode " << e.mode << ", " << e.n << " vertices, " << (in_array ? "in an array" : "given");
}

TEST(PrimitiveAssemblerAlone, TellsWhichTrianglesOfAnOutlineAreFirstAndLast) {
    using gl::PolygonForm;
    EXPECT_EQ(assembled(GL_POLYGON, 2, false, PolygonForm::outlined), Told{});
    EXPECT_EQ(assembled(GL_POLYGON, 3, false, PolygonForm::outlined), Told{"only 0 1 2"});
    EXPECT_EQ(assembled(GL_POLYGON, 5, false, PolygonForm::outlined),
              (Told{"first 0 1 2", "middle 0 2 3", "last 0 3 4"}));
    EXPECT_EQ(assembled(GL_POLYGON, 3, false, PolygonForm::gathered),
              (Told{"corner 0", "corner 1", "corner 2", "end"}));
}

/// A piece of a strip begins as the strip did, whatever came before.
TEST(PrimitiveAssemblerAlone, RestartsAStrip) {
    Numbered slots[Assembler::slot_count];
    Assembler assembler;
    Listing sink;
    assembler.begin(GL_TRIANGLE_STRIP, slots);
    for (const int number : {0, 1, 2, -1, 5, 6, 7, 8}) {
        if (number < 0) {
            assembler.restart();
            continue;
        }
        assembler.next().number = number;
        if (assembler.take_next())
            assembler.complete(sink);
    }
    EXPECT_EQ(sink.told, (Told{"triangle 0 1 2", "triangle 5 6 7", "triangle 7 6 8"}));
}

/// Pieces of a draw begin anew in each mode that is divided into pieces, after any number of vertices.
TEST(PrimitiveAssemblerAlone, RestartsInEachMode) {
    for (const GLenum mode : {GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_TRIANGLES, GL_TRIANGLE_STRIP,
                              GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON})
        for (int before = 0; before < 9; ++before) {
            Numbered slots[Assembler::slot_count];
            Assembler assembler;
            Listing sink;
            assembler.begin(mode, slots);
            const auto give = [&](int n) {
                sink.told.clear();
                for (int i = 0; i < n; ++i) {
                    assembler.next().number = i;
                    if (assembler.take_next())
                        assembler.complete(sink);
                }
            };
            give(before);
            assembler.restart();
            give(8);
            EXPECT_EQ(sink.told, assembled(mode, 8, false)) << "mode " << mode << ", after " << before;
        }
}

TEST(PrimitiveAssemblerAlone, PlacesAVertexBesideTheCorners) {
    Numbered slots[Assembler::slot_count], cached, other;
    Assembler assembler;
    assembler.begin(GL_QUADS, slots);
    EXPECT_EQ(&assembler.place_beside_corners(cached, slots), &cached);
    assembler.set_next(cached);
    EXPECT_FALSE(assembler.take_next());
    EXPECT_EQ(&assembler.place_beside_corners(other, slots), &other);
    for (int held = 1; held < 4; ++held) {
        Numbered& place = assembler.place_beside_corners(cached, slots);
        EXPECT_NE(&place, &cached);
        for (int i = 0; i < assembler.count(); ++i)
            EXPECT_NE(&place, &assembler.corner(i));
        assembler.set_next(place);
        EXPECT_EQ(assembler.take_next(), held == 3);
    }
}

} // namespace
} // namespace spangle::test

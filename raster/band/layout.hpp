// How a record lies in memory: blocks one behind the other, each skipped where it has no row of a band.
#pragma once

#include "raster/band/record.hpp"
#include "raster/primitive/line_stipple.hpp"

namespace spangle::raster {

/// What a block holds, behind its header.
enum class Record::Content : std::uint8_t {
    data,       ///< states and what they point at
    primitives, ///< items
    polygon,    ///< one of more corners than an item may have
    pixels,     ///< a vertex, then runs
    clear,
    accum,
    stencil, ///< a run of values
};

struct Record::Block {
    std::uint32_t bytes = 0;         ///< with this header
    std::uint32_t state = 0;         ///< of primitives and pixels
    std::int16_t first = 0, end = 0; ///< rows of the window
    Content content{};
    std::uint8_t items = 0;
    std::uint8_t sample = every_sample; ///< of pixels and stencil
    std::uint8_t unused = 0;
};

/// A compiled state, its pointers into the record.
struct Record::State {
    std::uint32_t next = nowhere;
    Rect scissor;                 ///< that of `draw` is the band's part of it while the band is drawn
    Counters* counters = nullptr; ///< likewise
    DrawState draw;
};

/// A primitive. Behind it, where it has them: size, stipple, depth offset; then the corners and the provoking
/// vertex, 16 bits each; then those vertices that were not there before. A corner below `fresh_corners` is
/// one of these, one above lies as many words before the item.
struct Record::Item {
    static constexpr int most_corners = 20; ///< as many as clipping makes of a quad
    static constexpr std::uint32_t fresh_corners = 32, farthest = 0xFFFF - fresh_corners;
    static_assert(most_corners < fresh_corners);

    Primitive::Shape shape{};
    std::uint8_t corners = 0, fresh = 0;
    bool line_stippled : 1 = false, polygon_stippled : 1 = false, has_offset : 1 = false;
    bool moved : 1 = false;          ///< so that each sample of the surface comes to lie in the centre
    std::int16_t first = 0, end = 0; ///< rows of the window

    bool has_size() const {
        return shape != Primitive::Shape::triangle && shape != Primitive::Shape::smooth_polygon;
    }
    std::uint32_t words() const { ///< without vertices
        constexpr std::uint32_t header = sizeof(Item) / 4, stipple = sizeof(LineStipple) / 4;
        return header + (has_size() ? 1u : 0u) + (line_stippled ? stipple : 0u) + (has_offset ? 2u : 0u) +
               (corners + 2u) / 2;
    }
};

/// An antialiased polygon of any number of corners; behind it pointers to them and to the provoking vertex,
/// then all of these.
struct Record::Polygon {
    std::int64_t depth_offset = 0;
    std::int32_t corners = 0;
    bool stippled = false;

    const FixedVertex** pointers() { return reinterpret_cast<const FixedVertex**>(this + 1); }
    FixedVertex* vertices() { return reinterpret_cast<FixedVertex*>(pointers() + (corners + 2) / 2 * 2); }
    static std::size_t bytes(int corners) {
        const auto n = static_cast<std::size_t>(corners);
        return sizeof(Polygon) + (n + 2) / 2 * 2 * sizeof(FixedVertex*) + (n + 1) * sizeof(FixedVertex);
    }
};

/// Fragments side by side, with what they bring along.
struct Record::Run {
    enum class Form : std::uint8_t {
        plain,
        words, ///< R5 G6 B5
        bytes, ///< four components, whole 255ths
        units, ///< four components in colour units
        depth, ///< no fragments: those that follow have this depth
    };
    static constexpr std::int32_t longest = 64;

    std::int16_t y = 0, x = 0;
    std::uint16_t count = 0;
    Form form{};
    std::uint8_t mask = 0; ///< of stencil

    std::uint32_t payload() const {
        return form == Form::plain   ? 0
               : form == Form::words ? (count + 1u) / 2 * 4
               : form == Form::bytes ? count * 4u
               : form == Form::units ? count * 16u
                                     : 4;
    }
};

} // namespace spangle::raster

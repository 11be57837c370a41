// The layout of a record in memory: blocks one behind the other. A block that has no row of a band is
// skipped.
#pragma once

#include "raster/band/record.hpp"
#include "raster/primitive/line_stipple.hpp"

namespace spangle::raster {

/// The content of a block, behind its header.
enum class Record::Content : std::uint8_t {
    data,       ///< states, and the data that they point to
    primitives, ///< a sequence of Item
    polygon,    ///< one Polygon, with more corners than an item may have
    pixels,     ///< the vertex of a raster position, followed by runs of pixels
    clear,
    accum,
    stencil, ///< a run of stencil values
};

struct Record::Block {
    std::uint32_t bytes = 0;         ///< size of the block, including this header
    std::uint32_t state = 0;         ///< place of the state of primitives and pixels
    std::int16_t first = 0, end = 0; ///< rows of the window
    Content content{};
    std::uint8_t items = 0;
    std::uint8_t sample = every_sample; ///< the sample that pixels and stencil values are written to
    std::uint8_t unused = 0;
};

/// A compiled state whose pointers lead into the record.
struct Record::State {
    std::uint32_t next = nowhere;
    Rect scissor; ///< the recorded rectangle; while a band is drawn, draw.scissor is its part in the band
    Counters* counters = nullptr; ///< the recorded pointer; draw.counters may differ while a band is drawn
    DrawState draw;
};

/// A primitive. Where it has them, size, stipple and depth offset follow. Then come references of 16 bits to
/// the corners and the provoking vertex, and then the vertices that were not stored before. A reference below
/// `fresh_corners` is the index of one of these vertices. Any other vertex lies (reference - fresh_corners)
/// words before the item.
struct Record::Item {
    static constexpr int most_corners = 20; ///< a clipped quad has no more corners
    static constexpr std::uint32_t fresh_corners = 32, farthest = 0xFFFF - fresh_corners;
    static_assert(most_corners < fresh_corners);

    Primitive::Shape shape{};
    std::uint8_t corners = 0, fresh = 0;
    bool line_stippled : 1 = false, polygon_stippled : 1 = false, has_offset : 1 = false;
    /// The primitive is drawn for each sample, moved until the sample lies in the pixel's centre.
    bool moved : 1 = false;
    std::int16_t first = 0, end = 0; ///< rows of the window

    bool has_size() const {
        return shape != Primitive::Shape::triangle && shape != Primitive::Shape::smooth_polygon;
    }
    std::uint32_t words() const { ///< words of the item, without vertices
        constexpr std::uint32_t header = sizeof(Item) / 4, stipple = sizeof(LineStipple) / 4;
        return header + (has_size() ? 1u : 0u) + (line_stippled ? stipple : 0u) + (has_offset ? 2u : 0u) +
               (corners + 2u) / 2;
    }
};

/// An antialiased polygon with any number of corners. Pointers to its corners and to the provoking vertex
/// follow, and then all of these vertices.
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

/// Adjacent fragments of a row, followed by their payload.
struct Record::Run {
    enum class Form : std::uint8_t {
        plain,
        words, ///< R5 G6 B5
        bytes, ///< four components, whole 255ths
        units, ///< four components in colour units
        depth, ///< no fragments: sets the depth of the next runs
    };
    static constexpr std::int32_t longest = 64;

    std::int16_t y = 0, x = 0;
    std::uint16_t count = 0;
    Form form{};
    std::uint8_t mask = 0; ///< bits of stencil values that are written

    std::uint32_t payload() const {
        return form == Form::plain   ? 0
               : form == Form::words ? (count + 1u) / 2 * 4
               : form == Form::bytes ? count * 4u
               : form == Form::units ? count * 16u
                                     : 4;
    }
};

} // namespace spangle::raster

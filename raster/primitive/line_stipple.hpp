// The stipple of lines (GL 1.3, 3.4.2): which fragments of a line are drawn, and where the next line goes on.
#pragma once

#include <cstdint>

#include "raster/primitive/diamond.hpp"

namespace spangle::raster {

struct LineStipple {
    std::uint32_t pattern = 0xFFFF, factor = 1; ///< pattern has 16 bits, factor is 1 .. 256
    std::uint32_t position = 0; ///< s of the specification for the next fragment, modulo 16 * factor

    bool at(std::uint32_t s) const { return (pattern >> (s / factor & 15) & 1) != 0; }
    void advance(std::uint32_t fragments) { position = (position + fragments) % (16 * factor); }
};

/// Takes the place of a stipple on a solid line: all fragments are drawn.
struct SolidLine {
    struct Mask {
        constexpr bool operator()(std::int32_t) const { return true; }
    };
    Mask along(const DiamondWalk&) { return {}; }
    static const LineStipple* of(const Mask&) { return nullptr; }
};

/// Pattern of a stippled line: the fragments that the stipple leaves, counted from the first end point.
struct StippledLine {
    LineStipple& stipple;
    struct Mask {
        LineStipple stipple;
        std::int32_t from; ///< major coordinate of the line's first fragment
        bool ascends;
        bool operator()(std::int32_t major) const {
            return stipple.at(stipple.position +
                              static_cast<std::uint32_t>(ascends ? major - from : from - major));
        }
    };
    /// Takes a line before it is clipped. The stipple moves on to the line's end.
    Mask along(const DiamondWalk& walk) {
        const Mask kept{stipple, walk.ascends ? walk.major : walk.major + walk.count - 1, walk.ascends};
        stipple.advance(static_cast<std::uint32_t>(walk.count));
        return kept;
    }
    static const LineStipple* of(const Mask& kept) { return &kept.stipple; }
};

} // namespace spangle::raster

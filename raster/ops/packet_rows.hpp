// Packets that short rows of a primitive share. Each fragment of such a packet has a place of its own.
#pragma once

#include "raster/ops/lane_planes.hpp"
#include "raster/ops/lanes.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/rows.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Fragments of a packet, a power of two. Where a build has lanes, a packet is eight groups of lanes.
inline constexpr std::int32_t packet_length = host_lanes > 1 ? 8 * host_lanes : packet;

/// One bit for each fragment of a packet, or for each piece of a row in it.
using PacketBits = std::conditional_t<(packet_length > 32), std::uint64_t, std::uint32_t>;
static_assert(packet_length <= 64);
/// The bits of the first n fragments, n > 0.
SPANGLE_INLINE constexpr PacketBits first_bits(std::int32_t n) {
    return static_cast<PacketBits>(~PacketBits{0}) >> (static_cast<int>(8 * sizeof(PacketBits)) - n);
}

/// The lengths of the runs of texture coordinates in rows that are drawn together (run_lengths.hpp). Packets
/// of these rows look the lengths up here.
struct RowRuns {
    const Row* rows;
    std::int32_t count;
    struct Group {
        std::int32_t number;               ///< number of the group of eight rows; -1 where the entry is empty
        alignas(32) std::uint32_t log2[8]; ///< log2 of the length of the runs in each row
    };
    /// The last two groups of each unit that were asked for. Two are kept, because packets of one group may
    /// alternate with packets of the next.
    Group known[max_texture_units][2];

    RowRuns(const Row* of, std::int32_t n) : rows(of), count(n) {
        for (auto& unit : known)
            unit[0].number = unit[1].number = -1;
    }
};

/// Takes the place of RowRuns in number systems whose packets never ask for run lengths.
struct NoRowRuns {
    NoRowRuns(const Row*, std::int32_t) {}
};

/// A part of one row that lies in a shared packet.
struct Piece {
    Row row;             ///< the row, with columns [first, last) reduced to those of the part
    std::int32_t number; ///< number of the row in RowRuns
    std::int32_t at;     ///< index in the packet of the first fragment of the part
    std::uint8_t *color, *depth;
};

/// The places of the fragments in a packet that rows share.
struct PacketRows {
    Span<Fixed>& span;
    std::int32_t pieces = 0;
    Piece piece[packet_length];
    /// Columns to the right of the anchor, and rows above the anchor, of each fragment. Lanes beyond the last
    /// fragment repeat the last fragment's place.
    alignas(32) std::uint32_t x[packet_length + host_lanes], y[packet_length + host_lanes];
    explicit PacketRows(Span<Fixed>& of) : span(of) {}
};

/// Columns or rows of window coordinates, one per lane.
template <class L> struct LanePlaces {
    typename L::U32 of;
    SPANGLE_INLINE friend LanePlaces operator+(const LanePlaces& at, std::int32_t) { return at; }
};

/// A group of lanes of a shared packet. Stages take it in place of a span. Where a stage asks for the value
/// of a plane at a column, it gets the value at the place of each lane.
template <class L> struct PlaneLanes {
    static constexpr int lanes = L::count;
    const Span<Fixed>& planes;
    typename L::U32 columns, lines; ///< places of the lanes, counted from the anchor
    LanePlaces<L> x = {columns + L::splat32(static_cast<std::uint32_t>(planes.anchor_x))},
                  y = {lines + L::splat32(static_cast<std::uint32_t>(planes.anchor_y))};
    const DrawState* state = planes.state;
    std::uint32_t flat_word = planes.flat_word;
    const Span<Fixed>::Affine& z = planes.z;
    const Span<Fixed>::Affine (&color_value)[4] = planes.color_value;
    const Span<Fixed>::Affine (&secondary)[Span<Fixed>::secondaries] = planes.secondary;
    const Span<Fixed>::Affine& fog = planes.fog;
    const Span<Fixed>::Affine (&s)[max_texture_units] = planes.s;
    const Span<Fixed>::Affine (&t)[max_texture_units] = planes.t;

    SPANGLE_INLINE PlaneLanes(const PacketRows& rows, std::int32_t first)
        : planes(rows.span), columns(L::gather(rows.x + first)), lines(L::gather(rows.y + first)) {}

    SPANGLE_INLINE typename L::U32 at(std::int32_t, const Span<Fixed>::Affine& plane) const {
        return L::splat32(plane.value) + columns * plane.dx + lines * plane.dy;
    }
    /// The high words of the values of a plane of 64 bits.
    SPANGLE_INLINE typename L::U32 tops(const Interpolant<std::uint64_t>& plane) const {
        return PlaneInRows(plane).tops(columns, lines);
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster

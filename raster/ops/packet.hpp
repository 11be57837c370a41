// A packet holds fragments that pass one op after the other, and what the ops know of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "raster/ops/packet_rows.hpp"
#include "raster/ops/stage.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// 1/w of the fragments of a packet (inverse.hpp), where there are lanes (stage_divided_packet.hpp).
template <int Count> struct PacketInverse {
    std::uint32_t q[Count], mantissa[Count], power[Count]; ///< as in Inverse; power is 2^zeros
};
template <> struct PacketInverse<0> {};

/// Says which of the rows that are drawn together (RowRuns) a packet of one row belongs to.
template <bool Kept> struct RowOfPacket {
    RowRuns* runs = nullptr;
    std::int32_t number = 0;
};
template <> struct RowOfPacket<false> {
    RowOfPacket() = default;
    SPANGLE_INLINE RowOfPacket(const NoRowRuns*, std::int32_t) {}
};
template <int Lanes> using RowIn = RowOfPacket<(Lanes > 1 && divides_in_lanes)>;

/// The fragments of a packet, in groups of lanes, without their colours: the part that number systems have in
/// common. Packets of one lane start at multiples of their length from the anchor.
template <class Lanes, class Coord, class Fog> struct PacketPlaces {
    using L = Lanes;
    static constexpr int lanes = L::count, groups = packet_length / lanes;
    std::uint8_t *color_plane,
        *depth_plane; ///< addresses of fragment 0, or of a copy of a packet that is not full
    std::int32_t x;   ///< first pixel, counted from the anchor of the span
    std::int32_t n;   ///< fragments, 1 .. packet_length; lanes beyond them are dead
    bool alive;       ///< some fragment is alive
    bool some_dead;   ///< some fragment of the n is dead
    typename L::Mask live[groups];
    Coord coord[max_texture_units][groups];
    std::int32_t lod[max_texture_units][packet_length];
    Fog fog[groups];
    [[no_unique_address]] PacketInverse<(lanes > 1 ? packet_length : 0)> inverse;
    /// Null where all fragments of the packet lie in one row.
    [[no_unique_address]] std::conditional_t<(lanes > 1), const PacketRows*, std::nullptr_t> rows;
    [[no_unique_address]] RowIn<lanes> row;
};
template <class N> using PlacesOf = PacketPlaces<typename N::L, typename N::Coord, typename N::Fog>;

template <class N> struct Packet : PlacesOf<N> { typename N::Color color[PlacesOf<N>::groups]; };

template <class N> using ChainStage = void (*)(PlacesOf<N>&, const Span<typename N::Policy>&);

/// Names one of the number systems whose packets have the same places. Stages that touch no colour are
/// compiled for that system alone.
template <class N> struct WithoutColor { using Type = N; };
template <> struct WithoutColor<Exact> { using Type = Raw565<1>; };
template <> struct WithoutColor<ExactLanes> { using Type = Raw565<8>; };
template <int Count> struct WithoutColor<Balanced<Count>> { using Type = Raw565<Count>; };
template <class N> using Colorless = typename WithoutColor<N>::Type;

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster

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

/// 1/w of each fragment of a packet, in the parts of Inverse (inverse.hpp). Only packets with several lanes
/// hold it; stage_divided_packet.hpp fills it in.
template <int Count> struct PacketInverse {
    std::uint32_t q[Count], mantissa[Count], power[Count]; ///< members of Inverse; `power` is 2^zeros
};
template <> struct PacketInverse<0> {};

/// Says to which of the rows in RowRuns a packet of one row belongs.
template <bool Kept> struct RowOfPacket {
    RowRuns* runs = nullptr;
    std::int32_t number = 0;
};
template <> struct RowOfPacket<false> {
    RowOfPacket() = default;
    SPANGLE_INLINE RowOfPacket(const NoRowRuns*, std::int32_t) {}
};
template <int Lanes> using RowIn = RowOfPacket<(Lanes > 1 && divides_in_lanes)>;

/// The fragments of a packet, in groups of lanes, without their colours. Several number systems share this
/// type. A packet with one lane starts at a multiple of packet_length from the anchor of the span.
template <class Lanes, class Coord, class Fog> struct PacketPlaces {
    using L = Lanes;
    static constexpr int lanes = L::count, groups = packet_length / lanes;
    std::uint8_t *color_plane,
        *depth_plane; ///< addresses of fragment 0: in the planes, or in the copy of a packet that is not full
                      ///< (PacketCopy)
    std::int32_t x;   ///< column of fragment 0, counted from the anchor of the span
    std::int32_t n;   ///< number of fragments, 1 .. packet_length; lanes beyond the last fragment are dead
    bool alive;       ///< at least one fragment is alive
    bool some_dead;   ///< at least one of the n fragments is dead
    typename L::Mask live[groups];
    Coord coord[max_texture_units][groups];
    std::int32_t lod[max_texture_units][packet_length];
    Fog fog[groups];
    [[no_unique_address]] PacketInverse<(lanes > 1 ? packet_length : 0)> inverse;
    /// The rows that share the packet; null where all its fragments lie in one row.
    [[no_unique_address]] std::conditional_t<(lanes > 1), const PacketRows*, std::nullptr_t> rows;
    [[no_unique_address]] RowIn<lanes> row;
};
template <class N> using PlacesOf = PacketPlaces<typename N::L, typename N::Coord, typename N::Fog>;

template <class N> struct Packet : PlacesOf<N> { typename N::Color color[PlacesOf<N>::groups]; };

template <class N> using ChainStage = void (*)(PlacesOf<N>&, const Span<typename N::Policy>&);

/// Names one number system for each type of PacketPlaces. Stages that touch no colour are compiled for this
/// number system alone.
template <class N> struct WithoutColor { using Type = N; };
template <> struct WithoutColor<Exact> { using Type = Raw565<1>; };
template <> struct WithoutColor<ExactLanes> { using Type = Raw565<8>; };
template <int Count> struct WithoutColor<Balanced<Count>> { using Type = Raw565<Count>; };
template <class N> using Colorless = typename WithoutColor<N>::Type;

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster

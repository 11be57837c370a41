// A chain is any list of stages, run over packets of fragments through one function pointer per stage. A
// state that has no fused span is drawn by its chain. Tests compare the bytes of every fused span with those
// of the chain.
#pragma once

#include "raster/chain/run_asking.hpp"
#include "raster/ops/packet.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace inner {

/// Holds copies, in both planes, of the pixels of a packet whose last group of lanes is not full. Stages load
/// and store whole groups of pixels. They work on the copy, so no pixel beyond the packet is touched.
class PacketCopy {
  public:
    /// `color` and `depth` are bytes of a pixel. A value of 0 means that no stage finds a pixel by its
    /// number, so nothing is copied.
    template <class N> SPANGLE_INLINE void enter(Packet<N>& k, std::int32_t color, std::int32_t depth) {
        color_.enter(k.color_plane, color * k.n);
        depth_.enter(k.depth_plane, depth * k.n);
    }
    SPANGLE_INLINE void write_back() const {
        color_.write_back();
        depth_.write_back();
    }

  private:
    struct Plane {
        alignas(16) std::uint8_t words[4 * packet_length];
        std::uint8_t* at;
        std::int32_t bytes;
        SPANGLE_INLINE void enter(std::uint8_t*& plane, std::int32_t n) {
            at = plane;
            bytes = n;
            if (bytes == 0)
                return;
            copy(words, at, bytes);
            plane = words;
        }
        SPANGLE_INLINE void write_back() const {
            if (bytes != 0)
                copy(at, words, bytes);
        }
    } color_, depth_;

  public:
    /// Copies 1 to 256 bytes between regions that do not overlap, without a call of memcpy().
    SPANGLE_INLINE static void copy(std::uint8_t* to, const std::uint8_t* from, std::int32_t bytes) {
        static_assert(4 * packet_length <= 256);
        if (bytes < 2)
            *to = *from;
        else if (bytes < 4)
            both_ends<2>(to, from, bytes);
        else if (bytes < 8)
            both_ends<4>(to, from, bytes);
        else if (bytes < 16)
            both_ends<8>(to, from, bytes);
        else if (bytes < 32)
            both_ends<16>(to, from, bytes);
        else if (bytes < 64)
            both_ends<32>(to, from, bytes);
        else if (bytes < 128)
            both_ends<64>(to, from, bytes);
        else
            both_ends<128>(to, from, bytes);
    }

  private:
    /// Copies Size to 2 Size bytes as two blocks: the first Size bytes and the last Size bytes. The blocks
    /// may overlap.
    template <int Size>
    SPANGLE_INLINE static void both_ends(std::uint8_t* to, const std::uint8_t* from, std::int32_t bytes) {
        const std::int32_t last = bytes - Size;
        __builtin_memcpy(to, from, Size);
        __builtin_memcpy(to + last, from + last, Size);
    }
};

/// True where a stage can draw packets that several rows share. Such a stage ignores places, has one lane, or
/// can be constructed from the place of each lane.
template <class S>
inline constexpr bool is_shared =
    S::anywhere || decltype(system_of(&S::operator()))::lanes == 1 ||
    std::is_constructible_v<S, const PlaneLanes<Lanes<host_lanes>>&, std::int32_t>;

/// Runs a stage on a packet that several rows share. A stage with several lanes is constructed from the place
/// of each lane. A stage with one lane runs along each piece of a row.
template <class M, class S, class K> [[gnu::noinline]] void run_in_rows(K& k) {
    Outcome outcome;
    if constexpr (M::lanes > 1) {
        if constexpr (std::is_constructible_v<S, const PlaneLanes<typename K::L>&, std::int32_t>) {
            for (std::int32_t i = 0; i < k.n; i += M::lanes) {
                const PlaneLanes<typename K::L> places(*k.rows, i);
                S s(places, 0);
                run_group<M>(k, s, i, outcome);
            }
        }
    } else {
        Span<Fixed>& span = k.rows->span;
        for (std::int32_t n = 0; n < k.rows->pieces; ++n) {
            const Piece& piece = k.rows->piece[n];
            enter(span, piece.row);
            const std::int32_t x0 = span.begin - piece.at;
            S s(span, span.begin);
            run_asking<M>(k, s, piece.at, piece.at + piece.row.last - piece.row.first, x0, outcome);
        }
    }
    outcome.tell<S>(k);
}

} // namespace inner

template <class S> inline constexpr bool uses_color = ((S::in | S::out) & field_color) != 0;

/// Runs one stage, or one Seq of stages, on a packet.
template <class N, class S> void chain_stage(PlacesOf<N>& places, const Span<typename N::Policy>& span) {
    using M = decltype(inner::system_of(&S::operator()));
    static_assert(M::lanes == N::lanes || M::lanes == 1);
    auto& k = static_cast<std::conditional_t<uses_color<S>, Packet<N>&, PlacesOf<N>&>>(places);
    if constexpr (N::lanes > 1 && !S::anywhere)
        if (k.rows != nullptr)
            return inner::run_in_rows<M, S>(k);
    S s(span, k.x);
    inner::Outcome outcome;
    inner::run_asking<M>(k, s, 0, k.n, k.x, outcome);
    outcome.tell<S>(k);
}

/// Draws one row of the span with the chain of the span's kind.
template <class N>
SPANGLE_INLINE void chain_row(const Span<typename N::Policy>& span, const RowIn<N::lanes>& row) {
    const AnyFunction* const stages = span.state->variant[static_cast<unsigned>(span.kind)].chain;
    const std::int32_t color_bytes = span.state->color_bytes, depth_bytes = span.state->depth_bytes;
    Packet<N> k;
    k.row = row;
    [[maybe_unused]] inner::PacketCopy copy;
    if constexpr (N::lanes > 1)
        k.rows = nullptr;
    for (k.x = span.begin; k.x < span.end; k.x += k.n) {
        // With lanes, a packet that is not full costs as much as a full one, so packets start at the first
        // pixel of the span.
        const std::int32_t start = N::lanes > 1 ? k.x : k.x & -packet_length;
        const std::int32_t boundary = start + packet_length, i = k.x - span.begin;
        k.n = (boundary < span.end ? boundary : span.end) - k.x;
        k.color_plane = span.color + i * color_bytes;
        k.depth_plane = span.depth + i * depth_bytes;
        k.alive = true;
        k.some_dead = false;
        for (auto& live : k.live)
            live = N::L::all;
        const bool copied = k.n % N::lanes != 0; // the last group has lanes beyond the packet
        if (copied) {
            for (std::int32_t g = k.n / N::lanes; g < Packet<N>::groups; ++g)
                k.live[g] = N::L::first(k.n - g * N::lanes);
            copy.enter(k, color_bytes, depth_bytes);
        }
        for (const AnyFunction* f = stages; *f != nullptr && k.alive; ++f)
            reinterpret_cast<ChainStage<N>> (*f)(k, span);
        if (copied)
            copy.write_back();
    }
}
template <class N> SPANGLE_INLINE void chain_span(const Span<typename N::Policy>& span) {
    chain_row<N>(span, {});
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster

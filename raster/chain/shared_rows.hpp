// Runs the chain along the rows of a primitive. In lanes, short rows share packets: a stage is called once
// for all of them. Only the last packet has lanes without a fragment.
#pragma once

#include "raster/chain/chain.hpp"
#include "raster/ops/packet_rows.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/rows.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Draws rows of one primitive with the chain of the span's kind. No two rows share a pixel.
template <class N> class SharedRows {
  public:
    SharedRows(Span<Fixed>& span, const Row* row, const Row* end)
        : rows_(span), runs_(row, static_cast<std::int32_t>(end - row)) {
        for (std::int32_t number = 0; row != end; ++row, ++number)
            add(*row, number);
        draw();
    }

  private:
    PacketRows rows_;
    [[no_unique_address]] std::conditional_t<divides_in_lanes, RowRuns, NoRowRuns> runs_;
    /// Whole multiples of this number of fragments of a row are drawn without sharing; the fragments that
    /// remain share packets. Planes are stepped along a row, but multiplied in a shared packet, which takes
    /// longer.
    static constexpr std::int32_t separate_length = 4 * N::lanes;
    std::int32_t fragment_count_ = 0; ///< number of fragments in all pieces
    alignas(32) std::uint8_t color_[4 * packet_length], depth_[4 * packet_length];

    void add(const Row& row, std::int32_t number) {
        Row rest = row;
        if (const std::int32_t whole = (row.last - row.first) & -separate_length; whole != 0) {
            rest.first = row.first + whole;
            draw_separately({row.y, row.left, row.right, row.first, rest.first}, number);
        }
        while (rest.first != rest.last) {
            Piece& piece = rows_.piece[rows_.pieces++];
            const std::int32_t room = packet_length - fragment_count_, length = rest.last - rest.first;
            piece.row = rest;
            piece.row.last = rest.first = length < room ? rest.last : rest.first + room;
            if (divides_in_lanes)
                piece.number = number;
            piece.at = fragment_count_;
            fragment_count_ += piece.row.last - piece.row.first;
            if (fragment_count_ == packet_length)
                draw();
        }
    }
    /// Draws the pieces that have been collected.
    void draw() {
        if (rows_.pieces == 1)
            draw_separately(rows_.piece[0].row, rows_.piece[0].number);
        else if (rows_.pieces != 0)
            draw_shared();
        rows_.pieces = fragment_count_ = 0;
    }
    void draw_separately(const Row& row, std::int32_t number) {
        enter(rows_.span, row);
        chain_row<N>(rows_.span, {&runs_, number});
    }
    void draw_shared() {
        const Span<Fixed>& span = rows_.span;
        const DrawState& state = *span.state;
        // Some stages read the span's row before they ask for places, so the span must hold a valid row.
        enter(rows_.span, rows_.piece[0].row);
        Packet<N> k;
        k.rows = &rows_;
        k.row = {&runs_, 0};
        k.x = 0;
        k.n = fragment_count_;
        k.alive = true;
        k.some_dead = false;
        for (std::int32_t g = 0; g < Packet<N>::groups; ++g)
            k.live[g] = N::L::first(fragment_count_ - g * N::lanes);
        k.color_plane = color_;
        k.depth_plane = depth_;
        for (std::int32_t n = 0; n < rows_.pieces; ++n) {
            Piece& piece = rows_.piece[n];
            const Row& row = piece.row;
            point_at(piece.color, piece.depth, *span.target, row.first, row.y, state.color_bytes,
                     state.depth_bytes >> 1);
            place(piece);
            move(
                piece, [](std::uint8_t * packet, std::uint8_t * plane, std::int32_t bytes)
                           __attribute__((always_inline)) { inner::PacketCopy::copy(packet, plane, bytes); });
        }
        for (std::int32_t i = fragment_count_; i % N::lanes != 0; ++i) {
            rows_.x[i] = rows_.x[fragment_count_ - 1];
            rows_.y[i] = rows_.y[fragment_count_ - 1];
        }
        const AnyFunction* const stages = state.variant[static_cast<unsigned>(span.kind)].chain;
        for (const AnyFunction* f = stages; *f != nullptr && k.alive; ++f)
            reinterpret_cast<ChainStage<N>> (*f)(k, span);
        for (std::int32_t n = 0; n < rows_.pieces; ++n)
            move(
                rows_.piece[n],
                [](std::uint8_t * packet, std::uint8_t * plane, std::int32_t bytes)
                    __attribute__((always_inline)) { inner::PacketCopy::copy(plane, packet, bytes); });
    }
    /// Writes the places of the piece's fragments, in whole groups of lanes. The places written behind the
    /// piece are overwritten by the next piece.
    SPANGLE_INLINE void place(const Piece& piece) {
        using L = typename N::L;
        const Span<Fixed>& span = rows_.span;
        auto x = static_cast<std::uint32_t>(piece.row.first - span.anchor_x);
        const auto y = L::splat32(static_cast<std::uint32_t>(piece.row.y - span.anchor_y));
        const std::int32_t end = piece.at + piece.row.last - piece.row.first;
        for (std::int32_t i = piece.at; i < end; i += N::lanes, x += N::lanes) {
            L::store32(reinterpret_cast<std::uint8_t*>(rows_.x + i), L::ramp(x, 1));
            L::store32(reinterpret_cast<std::uint8_t*>(rows_.y + i), y);
        }
    }
    /// Copies the piece's pixels between the planes and the packet's copy of them, in the direction of
    /// `move`.
    template <class Move> SPANGLE_INLINE void move(const Piece& piece, Move move) {
        const DrawState& state = *rows_.span.state;
        const std::int32_t n = piece.row.last - piece.row.first;
        if (const std::int32_t bytes = state.color_bytes; bytes != 0)
            move(color_ + bytes * piece.at, piece.color, bytes * n);
        if (const std::int32_t bytes = state.depth_bytes; bytes != 0)
            move(depth_ + bytes * piece.at, piece.depth, bytes * n);
    }
};

/// Whether rows of this span may share packets. Coverage is counted from the first pixel of a row, so rows
/// with coverage stay whole.
template <class P> SPANGLE_INLINE bool may_share(const Span<P>& span) {
    const PrimitiveState* const primitive = span.state->primitive;
    return span.state->variant[static_cast<unsigned>(span.kind)].shares &&
           (primitive == nullptr || primitive->coverage == nullptr);
}

/// The RowsFunction that draws with the chain.
template <class N> void chain_rows(Span<typename N::Policy>& span, const Row* row, const Row* end) {
    if constexpr (N::lanes > 1) {
        if (may_share(span)) {
            SharedRows<N>(span, row, end);
            return;
        }
    }
    by_row<typename N::Policy, &chain_span<N>>(span, row, end);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster

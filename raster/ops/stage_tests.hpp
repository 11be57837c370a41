// Tests of a fragment: the alpha test (GL 1.3, 4.1.4), and the stencil test with the depth test (4.1.5,
// 4.1.6).
#pragma once

#include "raster/ops/stage_depth.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The alpha test. Alpha is rounded to 8 bits, as GL's reference value was when it was set.
template <class N> struct AlphaTest : StageBase {
    static constexpr unsigned in = field_color;
    static constexpr bool kill = true, anywhere = true;
    using L = typename N::L;
    Compare func;
    std::uint32_t ref;
    SPANGLE_INLINE AlphaTest(const Span<typename N::Policy>& s, std::int32_t)
        : func(s.state->fragment.alpha_func), ref(s.state->fragment.alpha_ref) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if constexpr (N::lanes > 1) {
            p.live &= compare_depths<L>(func, N::to8(p.color.a), L::splat(ref));
            return L::any(p.live);
        } else {
            return compare<std::uint32_t>(func, static_cast<std::uint32_t>(N::to8(p.color.a)), ref);
        }
    }
};

/// The value that a stencil operation makes of a stored value. All values have 8 bits.
constexpr std::uint32_t stencil_result(StencilOp op, std::uint32_t stored, std::uint32_t ref) {
    switch (op) {
    case StencilOp::keep:
        return stored;
    case StencilOp::zero:
        return 0;
    case StencilOp::replace:
        return ref;
    case StencilOp::incr:
        return stored == 0xFF ? stored : stored + 1;
    case StencilOp::decr:
        return stored == 0 ? stored : stored - 1;
    case StencilOp::invert:
        return stored ^ 0xFF;
    case StencilOp::incr_wrap:
        return (stored + 1) & 0xFF;
    case StencilOp::decr_wrap:
        return (stored - 1) & 0xFF;
    }
    return stored;
}

/// Does what stencil_result() does, for eight values at once.
template <class L>
SPANGLE_INLINE typename L::U16 stencil_results(StencilOp op, const typename L::U16& stored,
                                               std::uint32_t ref) {
    switch (op) {
    case StencilOp::keep:
        return stored;
    case StencilOp::zero:
        return L::splat(0);
    case StencilOp::replace:
        return L::splat(ref);
    case StencilOp::incr:
        return L::minimum(stored + 1, L::splat(0xFF));
    case StencilOp::decr:
        return stored - L::minimum(stored, L::splat(1));
    case StencilOp::invert:
        return stored ^ 0xFF;
    case StencilOp::incr_wrap:
        return (stored + 1) & 0xFF;
    case StencilOp::decr_wrap:
        return (stored - 1) & 0xFF;
    }
    return stored;
}

/// The stencil test and, where it is on, the depth test after it. A word of the buffer holds 24 bits of depth
/// above 8 bits of stencil.
template <class N, class Value = DepthValueOf<N, DepthFormat::z24s8>> struct StencilDepth : Value {
    static constexpr bool kill = true, effect = true;
    const FragmentState& state;
    template <class S>
    SPANGLE_INLINE StencilDepth(const S& s, std::int32_t x) : Value(s, x), state(s.state->fragment) {}

    bool operator()(Px<N>& p) const {
        if constexpr (N::lanes > 1) {
            return test_lanes(p);
        } else {
            auto* const at = static_cast<std::uint8_t*>(__builtin_assume_aligned(p.depth_plane + 4 * p.i, 4));
            std::uint32_t word;
            __builtin_memcpy(&word, at, 4);
            const StencilState& stencil = state.stencil;
            const std::uint32_t stored = word & 0xFF, mask = stencil.compare_mask;
            std::uint32_t depth = word >> 8;
            StencilOp op = stencil.fail;
            bool passes = compare<std::uint32_t>(stencil.func, stencil.ref & mask, stored & mask);
            if (passes) {
                op = stencil.pass;
                if (state.depth_test) {
                    const std::uint32_t incoming = this->word() >> 8;
                    passes = compare<std::uint32_t>(state.depth_func, incoming, depth);
                    if (!passes)
                        op = stencil.depth_fail;
                    else if (state.depth_write)
                        depth = incoming;
                }
            }
            const std::uint32_t writes = stencil.write_mask;
            const std::uint32_t result =
                (stencil_result(op, stored, stencil.ref) & writes) | (stored & ~writes & 0xFF);
            word = depth << 8 | result;
            __builtin_memcpy(at, &word, 4);
            return passes;
        }
    }

  private:
    bool test_lanes(Px<N>& p) const {
        using L = typename N::L;
        using U16 = typename L::U16;
        std::uint8_t* const at = p.depth_plane + 4 * p.i;
        const StencilState& stencil = state.stencil;
        const auto word = L::load32(at);
        const U16 stored = L::byte(word, 0), mask = L::splat(stencil.compare_mask & 0xFF);
        const auto allowed = compare_depths<L>(
            stencil.func, L::splat(stencil.ref & stencil.compare_mask & 0xFF), stored & mask);
        auto depth = word >> 8;
        typename L::Mask passes = allowed;
        U16 result = stencil_results<L>(stencil.pass, stored, stencil.ref);
        if (state.depth_test) {
            const auto incoming = this->words() >> 8;
            passes &= compare_depths<L>(state.depth_func, incoming, depth);
            result = L::select(passes, result, stencil_results<L>(stencil.depth_fail, stored, stencil.ref));
            if (state.depth_write)
                depth = L::select(passes, incoming, depth);
        }
        result = L::select(allowed, result, stencil_results<L>(stencil.fail, stored, stencil.ref));
        const U16 writes = L::splat(stencil.write_mask & 0xFF);
        result = (result & writes) | (stored & ~writes);
        L::store32(at, L::select(p.live, depth << 8 | L::widened(result), word));
        p.live &= passes;
        return L::any(p.live);
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster

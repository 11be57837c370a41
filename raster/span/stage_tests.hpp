// Tests of a fragment: alpha (GL 1.3, 4.1.4), stencil with depth (4.1.5, 4.1.6).
#pragma once

#include "raster/span/stage_depth.hpp"

namespace spangle::raster {

/// Alpha rounds to 8 bits, as the reference value did.
template <class N> struct AlphaTest : StageBase {
    static_assert(N::lanes == 1);
    static constexpr unsigned in = field_color;
    static constexpr bool kill = true;
    Compare func;
    std::uint32_t ref;
    SPANGLE_INLINE AlphaTest(const Span<typename N::Policy>& s, std::int32_t)
        : func(s.state->fragment.alpha_func), ref(s.state->fragment.alpha_ref) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        return compare<std::uint32_t>(func, static_cast<std::uint32_t>(N::to8(p.color.a)), ref);
    }
};

/// What an operation makes of a stored stencil value.
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

/// Stencil test and, when it is on, the depth test behind it; 24 bits of depth above 8 of stencil.
template <class N, class Value = DepthValueOf<N, DepthFormat::z24s8>> struct StencilDepth : Value {
    static_assert(N::lanes == 1);
    static constexpr bool kill = true, effect = true;
    const FragmentState& state;
    SPANGLE_INLINE StencilDepth(const Span<typename N::Policy>& s, std::int32_t x)
        : Value(s, x), state(s.state->fragment) {}

    bool operator()(Px<N>& p) const {
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
};

} // namespace spangle::raster

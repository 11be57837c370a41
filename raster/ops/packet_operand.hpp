// Operands of what is computed for a whole packet, component by component: each choice is made once per
// packet, and what it chose is a loop over the packet's groups of lanes.
#pragma once

#include "raster/ops/component.hpp"
#include "raster/ops/packet.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// One component of the colours of a packet. Either each group of lanes has a value of its own, or all groups
/// have the same value.
template <class N> struct PacketOperand {
    using Color = typename N::Color;
    using T = typename N::T;
    using Component = T Color::*;
    static constexpr Component components[4] = {&Color::r, &Color::g, &Color::b, &Color::a};

    const Color* colors;
    Component component;
    std::int32_t step; ///< 1; or 0, where all groups have the value of the first

    /// Component c of the colours of all groups.
    SPANGLE_INLINE static PacketOperand of(const Color* colors, int c) { return {colors, components[c], 1}; }
    /// Component c of one colour, for all groups.
    SPANGLE_INLINE static PacketOperand constant(const Color& color, int c) {
        return {&color, components[c], 0};
    }
    /// 0 in all groups.
    SPANGLE_INLINE static PacketOperand zero() {
        static constexpr Color none{};
        return constant(none, 0);
    }
    SPANGLE_INLINE const T& operator[](std::int32_t group) const { return colors[group * step].*component; }
};

/// Component c of colours of a packet, as a loop writes it.
template <class N> struct PacketResult {
    using Operand = PacketOperand<N>;
    typename N::Color* colors;
    typename Operand::Component component;
    std::int32_t groups;

    SPANGLE_INLINE PacketResult(typename N::Color* to, int c, std::int32_t n)
        : colors(to), component(Operand::components[c]), groups(n) {}
    SPANGLE_INLINE Operand operand() const { return {colors, component, 1}; }
    /// Writes f of the operands, group by group. An operand may be the result itself.
    template <class F, class... Of> SPANGLE_INLINE Operand set(F f, const Of&... of) const {
        for (std::int32_t g = 0; g < groups; ++g)
            colors[g].*component = f(of[g]...);
        return operand();
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster

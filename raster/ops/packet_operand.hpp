// Operands for arithmetic on a whole packet, component by component. Each choice is made once per packet, and
// the chosen operation is a loop over the packet's groups of lanes.
#pragma once

#include "raster/ops/component.hpp"
#include "raster/ops/packet.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// One component of the colours of a packet. Either each group of lanes has its own value, or all groups have
/// the same value.
template <class N> struct PacketOperand {
    using Color = typename N::Color;
    using T = typename N::T;
    static constexpr std::int32_t color_step = sizeof(Color) / sizeof(T);

    const T* values;
    std::int32_t step; ///< distance from group to group; 0 where all groups share one value

    /// Component c of the colours of all groups.
    SPANGLE_INLINE static PacketOperand of(const Color* colors, int c) {
        return {reinterpret_cast<const T*>(colors) + c, color_step};
    }
    /// Component c of one colour, which is the value of all groups.
    SPANGLE_INLINE static PacketOperand constant(const Color& color, int c) {
        return {reinterpret_cast<const T*>(&color) + c, 0};
    }
    /// 0 in all groups.
    SPANGLE_INLINE static PacketOperand zero() {
        static constexpr Color none{};
        return constant(none, 0);
    }
    SPANGLE_INLINE const T& operator[](std::int32_t group) const { return values[group * step]; }
};

/// Where a loop writes one component: in colours of a packet, or in values of their own.
template <class N> struct PacketResult {
    using Operand = PacketOperand<N>;
    using T = typename N::T;
    T* values;
    std::int32_t step, groups;

    SPANGLE_INLINE PacketResult(typename N::Color* to, int c, std::int32_t n)
        : values(reinterpret_cast<T*>(to) + c), step(Operand::color_step), groups(n) {}
    SPANGLE_INLINE PacketResult(T* to, std::int32_t n) : values(to), step(1), groups(n) {}
    SPANGLE_INLINE Operand operand() const { return {values, step}; }
    /// Writes f of the operands, group by group. An operand may be the result itself.
    template <class F, class... Of> SPANGLE_INLINE Operand set(F f, const Of&... of) const {
        for (std::int32_t g = 0; g < groups; ++g)
            values[g * step] = f(of[g]...);
        return operand();
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster

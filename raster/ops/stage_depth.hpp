// The depth of a fragment as a code, and the depth test (GL 1.3, 4.1.6).
#pragma once

#include <cstring>

#include "raster/ops/packet_rows.hpp"
#include "raster/ops/stage.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Compares as GL specifies it: incoming Func stored.
template <Compare Func, class T> SPANGLE_INLINE constexpr bool compare(T incoming, T stored) {
    switch (Func) {
    case Compare::never:
        return false;
    case Compare::less:
        return incoming < stored;
    case Compare::equal:
        return incoming == stored;
    case Compare::lequal:
        return incoming <= stored;
    case Compare::greater:
        return incoming > stored;
    case Compare::notequal:
        return incoming != stored;
    case Compare::gequal:
        return incoming >= stored;
    case Compare::always:
        return true;
    }
    return true;
}

/// Compares by a function that is known only at run time.
template <class T> SPANGLE_INLINE constexpr bool compare(Compare func, T incoming, T stored) {
    // In GL's order an enumerator is the set of outcomes that pass: bit 0 is less, bit 1 is equal, bit 2 is
    // greater.
    const unsigned outcome = incoming < stored ? 1u : incoming == stored ? 2u : 4u;
    return (static_cast<unsigned>(func) & outcome) != 0;
}

/// The interpolated depth of the fixed policy, for depth buffers of 16 bits.
template <class N> struct DepthValue : StageBase {
    Ramp<typename N::L> z;
    template <class S> SPANGLE_INLINE DepthValue(const S& s, std::int32_t x) : z(s, x, s.z) {}
    /// The depth as 32 bits, whose top bits are the code. Only stages of one lane call this.
    SPANGLE_INLINE std::uint32_t word() const { return z.at; }
    /// The depth of each lane in this form.
    SPANGLE_INLINE typename N::L::U32 words() const { return z.at; }
    SPANGLE_INLINE void step() {
        if constexpr (is_raw<N>)
            z.step_aside();
        else
            z.step();
    }
    SPANGLE_INLINE void next_row() { z.next_row(); }
};

/// The interpolated depth of the fixed policy, for depth buffers of 24 bits.
template <class N> struct DepthValue24 : StageBase {
    std::uint64_t z, dx;
    SPANGLE_INLINE DepthValue24(const Span<typename N::Policy>& s, std::int32_t x)
        : z(s.at(x, s.z24)), dx(s.z24.dx) {}
    SPANGLE_INLINE std::uint32_t word() const { return static_cast<std::uint32_t>(z >> 32); }
    SPANGLE_INLINE void step() { z += dx; }
};
template <class N>
requires(N::lanes > 1) struct DepthValue24<N> : StageBase {
    inner::GuardedLanes<> row;
    bool in_row; ///< the fragments lie in one row; otherwise `given` holds the depth of each lane
    typename N::L::U32 given;
    SPANGLE_INLINE DepthValue24(const Span<typename N::Policy>& s, std::int32_t x)
        : row(s, x, s.z24), in_row(true) {}
    SPANGLE_INLINE DepthValue24(const PlaneLanes<typename N::L>& s, std::int32_t)
        : in_row(false), given(s.tops(s.planes.z24)) {}
    /// The depth of each lane as 32 bits, whose top bits are the code.
    SPANGLE_INLINE typename N::L::U32 words() const { return in_row ? row.tops() : given; }
    SPANGLE_INLINE void step() {
        if (in_row)
            row.step();
    }
};

/// The depth value of a number system for a depth format. The reference policy, and builds without depths of
/// 24 bits, have one type for both formats.
template <class N, DepthFormat Format>
using DepthValueOf = std::conditional_t<has_format(DepthFormat::z24s8) && Format == DepthFormat::z24s8 &&
                                            std::is_same_v<typename N::Policy, Fixed>,
                                        DepthValue24<N>, DepthValue<N>>;

/// A depth value with the polygon offset added (GL 1.3, 3.5.5), clamped to the range of depths.
template <class N, class Value = DepthValue<N>> struct OffsetDepthValue : Value {
    std::int64_t offset;
    SPANGLE_INLINE OffsetDepthValue(const Span<typename N::Policy>& s, std::int32_t x)
        : Value(s, x), offset(s.state->fragment.depth_offset ? s.state->primitive->depth_offset : 0) {}
    SPANGLE_INLINE std::uint32_t word() const {
        return static_cast<std::uint32_t>(
            numeric::clamp<std::int64_t>(offset + Value::word(), 0, INT64_C(0xFFFFFFFF)));
    }
};
template <class N, class Value>
requires(N::lanes > 1) struct OffsetDepthValue<N, Value> : Value {
    using U32 = typename N::L::U32;
    std::uint32_t up = 0, down = 0; ///< what the offset adds or takes away; one of them is 0
    template <class S> SPANGLE_INLINE OffsetDepthValue(const S& s, std::int32_t x) : Value(s, x) {
        const std::int64_t offset = s.state->fragment.depth_offset ? s.state->primitive->depth_offset : 0,
                           most = INT64_C(0xFFFFFFFF);
        if (offset < 0)
            down = static_cast<std::uint32_t>(offset < -most ? most : -offset);
        else
            up = static_cast<std::uint32_t>(offset > most ? most : offset);
    }
    SPANGLE_INLINE U32 words() const {
        using L = typename N::L;
        const U32 word = Value::words(), less = word - L::minimum_unsigned(word, L::splat32(down));
        return less + L::minimum_unsigned(~less, L::splat32(up));
    }
};

template <class N, DepthFormat Format, Compare Func, bool Write> struct Depth;

/// The depth test of buffers of 16 bits.
template <class N, Compare Func, bool Write> struct Depth<N, DepthFormat::z16, Func, Write> : DepthValue<N> {
    static constexpr bool kill = true, effect = Write;
    using L = typename N::L;
    using DepthValue<N>::DepthValue;
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) { this->z.start(s, x, s.z); }

    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const auto at = p.depth_plane + p.bytes();
        const typename L::U16 incoming = L::high_half(this->z.at);
        if constexpr (N::lanes == 1) {
            const typename L::U16 stored = L::load(at);
            if (p.selects) {
                p.live = compare<Func>(incoming, stored);
                if constexpr (Write)
                    L::store(at, L::select(p.live, incoming, stored));
                return true;
            }
            if (!compare<Func>(incoming, stored))
                return false;
            if constexpr (Write) {
                if constexpr (!numeric::three_operands)
                    p.twice = numeric::factor32(p.twice);
                L::store(p.depth_plane + p.bytes(), numeric::high_half_here(this->z.at));
            }
            return true;
        } else {
            return test(p.live, at, incoming);
        }
    }
    /// Tests the depth codes of a group of lanes. Lanes that fail are cleared in `live`. Where the stage
    /// writes depth, it stores the codes of lanes that pass.
    template <class Place>
    SPANGLE_INLINE static bool test(typename L::Mask& live, const Place& at,
                                    const typename L::U16& incoming) {
        const typename L::U16 stored = L::load(at);
        live = L::both(live, compare_depth_lanes(incoming, stored));
        if constexpr (Write)
            L::store(at, L::select(live, incoming, stored));
        return L::any(live);
    }

  private:
    SPANGLE_INLINE static typename L::Mask compare_depth_lanes(typename L::U16 incoming,
                                                               typename L::U16 stored) {
        switch (Func) {
        case Compare::never:
            return L::negate(L::all);
        case Compare::less:
            return L::less(incoming, stored);
        case Compare::equal:
            return L::equal(incoming, stored);
        case Compare::lequal:
            return L::at_most(incoming, stored);
        case Compare::greater:
            return L::less(stored, incoming);
        case Compare::notequal:
            return L::negate(L::equal(incoming, stored));
        case Compare::gequal:
            return L::at_most(stored, incoming);
        case Compare::always:
            return L::all;
        }
        return L::all;
    }
};

/// The depth test of words with 24 bits of depth above 8 bits of stencil. The stencil bits keep their values.
template <class N, Compare Func, bool Write>
struct Depth<N, DepthFormat::z24s8, Func, Write> : DepthValueOf<N, DepthFormat::z24s8> {
    static_assert(N::lanes == 1);
    static constexpr bool kill = true, effect = Write;
    using DepthValueOf<N, DepthFormat::z24s8>::DepthValueOf;

    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        auto* const at = static_cast<std::uint8_t*>(__builtin_assume_aligned(p.depth_plane + 4 * p.i, 4));
        std::uint32_t stored;
        __builtin_memcpy(&stored, at, 4);
        if (!compare<Func>(this->word() >> 8, stored >> 8))
            return false;
        if constexpr (Write) {
            const std::uint32_t word = (this->word() & ~0xFFu) | (stored & 0xFF);
            __builtin_memcpy(at, &word, 4);
        }
        return true;
    }
};

/// The lanes that pass a comparison whose function is known only at run time.
template <class L, class V>
SPANGLE_INLINE typename L::Mask compare_depths(Compare func, const V& incoming, const V& stored) {
    // An enumerator of Compare is the set of outcomes that pass; compare() describes its bits.
    const auto when = [func](unsigned outcome) {
        return (static_cast<unsigned>(func) & outcome) != 0 ? L::all : L::negate(L::all);
    };
    const typename L::Mask less = L::less(incoming, stored), greater = L::less(stored, incoming);
    return (less & when(1)) | (greater & when(4)) | (~(less | greater) & when(2));
}

/// The depth test of the chain. Its function and write mask are known only at run time. Writes: false leaves
/// writing to a later stage that tests again.
template <class N, DepthFormat Format, class Value = DepthValueOf<N, Format>, bool Writes = true>
struct DepthGeneral : Value {
    static constexpr bool kill = true, effect = Writes;
    using L = typename N::L;
    Compare func;
    bool write;
    template <class S>
    SPANGLE_INLINE DepthGeneral(const S& s, std::int32_t x)
        : Value(s, x), func(s.state->fragment.depth_func), write(Writes && s.state->fragment.depth_write) {}

    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if constexpr (N::lanes > 1 && Format == DepthFormat::z16) {
            std::uint8_t* const at = p.depth_plane + p.bytes();
            const typename L::U16 incoming = L::high_half(this->words()), stored = L::load(at);
            p.live &= compare_depths<L>(func, incoming, stored);
            if (write)
                L::store(at, L::select(p.live, incoming, stored));
            return L::any(p.live);
        } else if constexpr (N::lanes > 1) {
            std::uint8_t* const at = p.depth_plane + 4 * p.i;
            const typename L::U32 incoming = this->words(), stored = L::load32(at);
            p.live &= compare_depths<L>(func, incoming >> 8, stored >> 8);
            if (write)
                L::store32(at, L::select(p.live, (incoming & ~0xFFu) | (stored & 0xFFu), stored));
            return L::any(p.live);
        } else {
            using Word = std::conditional_t<Format == DepthFormat::z16, std::uint16_t, std::uint32_t>;
            constexpr int stencil_bits = Format == DepthFormat::z16 ? 0 : 8;
            constexpr Word stencil = (1u << stencil_bits) - 1;
            auto* const at = static_cast<std::uint8_t*>(
                __builtin_assume_aligned(p.depth_plane + static_cast<int>(sizeof(Word)) * p.i, sizeof(Word)));
            Word stored;
            __builtin_memcpy(&stored, at, sizeof stored);
            const auto word = static_cast<Word>(this->word() >> (32 - 8 * sizeof(Word)));
            if (!compare<std::uint32_t>(func, word >> stencil_bits, stored >> stencil_bits))
                return false;
            if (write) {
                const auto merged = static_cast<Word>((word & ~stencil) | (stored & stencil));
                __builtin_memcpy(at, &merged, sizeof merged);
            }
            return true;
        }
    }
};

/// Counts fragments that have passed all tests, for occlusion queries and statistics.
template <class N> struct Count : StageBase {
    static constexpr bool effect = true, anywhere = true;
    std::uint32_t* passed;
    SPANGLE_INLINE Count(const Span<typename N::Policy>& s, std::int32_t)
        : passed(s.state->counters == nullptr ? nullptr : &s.state->counters->passed) {}
    SPANGLE_INLINE bool operator()(Px<N>&) const {
        if (passed != nullptr)
            ++*passed;
        return true;
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster

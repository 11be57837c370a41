// How many fragments a stage handles at once. Microcontrollers have one lane, and so have the tails of rows.
// Hosts have eight lanes in fused spans and in the chain, by the vector extensions of gcc and clang. A U16
// holds values below 2^16, so both lane counts give the same bits.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "raster/numeric/bits.hpp"
#include "raster/ops/lane_words.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

template <int Count> struct Lanes;

/// The number of lanes of fused spans and of the chain in this build.
#if defined(__SSE2__) || defined(__ARM_NEON)
inline constexpr int host_lanes = std::endian::native == std::endian::little ? 8 : 1;
#else
inline constexpr int host_lanes = 1;
#endif

/// True where the instruction set can shift each word of a vector by its own number (lane_division.hpp).
/// Elsewhere fragments are divided one after the other.
#if defined(__AVX2__)
inline constexpr bool divides_in_lanes = true;
#else
inline constexpr bool divides_in_lanes = false;
#endif

template <> struct Lanes<1> {
    static constexpr int count = 1, rows = 1;
    using Place = std::uint8_t*; ///< address of the first lane's pixel
    using U16 = std::uint32_t;
    using U32 = std::uint32_t;
    using Mask = bool;

    static constexpr Mask all = true;
    SPANGLE_INLINE static U16 splat(std::uint32_t v) { return v; }
    SPANGLE_INLINE static U32 splat32(std::uint32_t v) { return v; }
    /// One word per lane: start, start + step, and the next multiples. With one lane this is start.
    SPANGLE_INLINE static U32 ramp(std::uint32_t start, std::uint32_t) { return start; }
    /// The difference of a plane between each lane and the first lane.
    SPANGLE_INLINE static U32 offsets(std::uint32_t, std::uint32_t) { return 0; }
    SPANGLE_INLINE static U16 high_half(U32 v) { return v >> 16; }
    SPANGLE_INLINE static U16 low_half(U32 v) { return v & 0xFFFF; }
    /// floor(a b / 2^16).
    SPANGLE_INLINE static U16 mul_high(U16 a, U16 b) { return (a * b) >> 16; }
    /// floor(a b / 2^8), a < 2^8.
    SPANGLE_INLINE static U16 mul_256(U16 a, U16 b) { return (a * b) >> 8; }
    /// floor(a b / 2^9), where bits 0 .. 15 of a are a signed number and b < 2^8. The caller adds the result
    /// to a value that makes the sum positive.
    SPANGLE_INLINE static U16 mul_signed_512(U16 a, U16 b) {
        return static_cast<std::uint32_t>(static_cast<std::int32_t>(a) * static_cast<std::int32_t>(b) >> 9);
    }
    SPANGLE_INLINE static U16 minimum(U16 a, U16 b) { return a < b ? a : b; }
    SPANGLE_INLINE static U16 maximum(U16 a, U16 b) { return a < b ? b : a; }
    SPANGLE_INLINE static U16 select(Mask m, U16 a, U16 b) { return m ? a : b; }
    SPANGLE_INLINE static U16 swap_bytes(U16 v) { return __builtin_bswap16(static_cast<std::uint16_t>(v)); }
    SPANGLE_INLINE static bool any(Mask m) { return m; }
    SPANGLE_INLINE static Mask less(U16 a, U16 b) { return a < b; }
    SPANGLE_INLINE static Mask at_most(U16 a, U16 b) { return a <= b; }
    SPANGLE_INLINE static Mask equal(U16 a, U16 b) { return a == b; }
    SPANGLE_INLINE static Mask both(Mask a, Mask b) { return a && b; }
    SPANGLE_INLINE static Mask negate(Mask m) { return !m; }
    /// Loads 16-bit words in host order, one per lane. `p` is 2-aligned.
    SPANGLE_INLINE static U16 load(const std::uint8_t* p) {
        std::uint16_t v;
        __builtin_memcpy(&v, __builtin_assume_aligned(p, 2), 2);
        return v;
    }
    SPANGLE_INLINE static void store(std::uint8_t* p, U16 v) {
        const auto word = static_cast<std::uint16_t>(v);
        __builtin_memcpy(__builtin_assume_aligned(p, 2), &word, 2);
    }
    /// min(max(v, 0), 2^24 - 1) / 2^8, where v is signed.
    SPANGLE_INLINE static U16 clamped_24_to_16(U32 v) {
        return numeric::saturated_after<8, 16>(static_cast<std::int32_t>(v));
    }
    /// Loads one element per lane.
    SPANGLE_INLINE static U32 gather(const std::uint32_t* v) { return v[0]; }
    template <class F> SPANGLE_INLINE static auto generate(F f) { return f(0u); }
    SPANGLE_INLINE static U16 gather(const std::uint16_t* v) { return v[0]; }
    SPANGLE_INLINE static void scatter(U16 v, std::uint16_t* to) { to[0] = static_cast<std::uint16_t>(v); }
    /// Byte `n` of a word; byte 0 is the lowest.
    SPANGLE_INLINE static U16 byte(U32 v, int n) { return (v >> (8 * n)) & 0xFF; }
    SPANGLE_INLINE static bool lane(Mask m, int) { return m; }
    SPANGLE_INLINE static void kill(Mask& m, int) { m = false; }
    /// The mask of the first n lanes, for any n.
    SPANGLE_INLINE static Mask first(std::int32_t n) { return n > 0; }
};

/// Eight lanes, on little-endian hosts only (see host_lanes).
template <> struct Lanes<8> {
    static constexpr int count = 8, columns = 8, rows = 1;
    using Place = std::uint8_t*;
    using U16 [[gnu::vector_size(16)]] = std::uint16_t;
    using Words [[gnu::vector_size(16)]] = std::uint32_t;
    using Signed [[gnu::vector_size(16)]] = std::int16_t;
    using SignedWords [[gnu::vector_size(16)]] = std::int32_t;
    using Mask = U16; ///< a lane that is alive has all ones

    using U32 = LaneWords; ///< one word of 32 bits per lane

    static constexpr Mask all = {0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF};
    SPANGLE_INLINE static U16 splat(std::uint32_t v) {
        const auto w = static_cast<std::uint16_t>(v);
        return U16{w, w, w, w, w, w, w, w};
    }
    SPANGLE_INLINE static U32 splat32(std::uint32_t v) { return U32::splat(v); }
    /// The value of lane I in all lanes.
    template <int I> SPANGLE_INLINE static U16 spread(U16 v) {
        return __builtin_shufflevector(v, v, I, I, I, I, I, I, I, I);
    }
    /// Lanes 0 to 3 of a and b by turns; mixed_high() takes lanes 4 to 7.
    SPANGLE_INLINE static U16 mixed_low(U16 a, U16 b) {
        return __builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11);
    }
    SPANGLE_INLINE static U16 mixed_high(U16 a, U16 b) {
        return __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15);
    }
    SPANGLE_INLINE static U32 ramp(std::uint32_t start, std::uint32_t step) { return U32::ramp(start, step); }
    SPANGLE_INLINE static U32 offsets(std::uint32_t dx, std::uint32_t) { return ramp(0, dx); }
    SPANGLE_INLINE static U16 offsets16(U16 dx, U16) { return dx * U16{0, 1, 2, 3, 4, 5, 6, 7}; }
    SPANGLE_INLINE static Place place(std::uint8_t* first, std::ptrdiff_t) { return first; }
    SPANGLE_INLINE static std::uint8_t* pixel(Place at, int lane, int bytes) { return at + bytes * lane; }
    SPANGLE_INLINE static U16 high_half(const U32& v) { return v.high_half(); }
    SPANGLE_INLINE static U16 low_half(const U32& v) { return v.low_half(); }
    SPANGLE_INLINE static U32 widened(const U16& v) { return U32::widened(v); }
    SPANGLE_INLINE static U16 clamped_24_to_16(const U32& v) {
        return U32::mapped(
                   [](const auto& w) __attribute__((always_inline)) {
                       using Vector = std::remove_cvref_t<decltype(w)>;
                       const auto s = lane_words::as_signed(w);
                       // A v that is too large becomes all ones, which the shift leaves as 16 ones.
                       const auto over = std::bit_cast<Vector>(s > (1 << 24) - 1);
                       return (std::bit_cast<Vector>(s & ~(s >> 31)) | over) >> 8;
                   },
                   v)
            .low_half();
    }
    SPANGLE_INLINE static U16 mul_high(U16 a, U16 b) {
        U16 r;
        for (int i = 0; i < 8; ++i) // both compilers make one instruction of this loop
            r[i] = static_cast<std::uint16_t>((std::uint32_t{a[i]} * b[i]) >> 16);
        return r;
    }
    SPANGLE_INLINE static U16 mul_256(U16 a, U16 b) { return mul_high(a << 8, b); }
    /// floor(a b / 2^16), where a and b are signed.
    SPANGLE_INLINE static U16 mul_high_signed(U16 a, U16 b) {
        const auto s = std::bit_cast<Signed>(a), t = std::bit_cast<Signed>(b);
        Signed r;
        for (int i = 0; i < 8; ++i)
            r[i] = static_cast<std::int16_t>((std::int32_t{s[i]} * t[i]) >> 16);
        return std::bit_cast<U16>(r);
    }
    SPANGLE_INLINE static U16 maximum_signed(U16 a, U16 b) {
        const auto s = std::bit_cast<Signed>(a), t = std::bit_cast<Signed>(b);
        Signed r;
        for (int i = 0; i < 8; ++i)
            r[i] = s[i] < t[i] ? t[i] : s[i];
        return std::bit_cast<U16>(r);
    }
    SPANGLE_INLINE static U16 minimum_signed(U16 a, U16 b) {
        const auto s = std::bit_cast<Signed>(a), t = std::bit_cast<Signed>(b);
        Signed r;
        for (int i = 0; i < 8; ++i)
            r[i] = s[i] < t[i] ? s[i] : t[i];
        return std::bit_cast<U16>(r);
    }
    /// min(max(v, low), high), where all three are signed.
    SPANGLE_INLINE static U16 clamped_signed(U16 v, U16 low, U16 high) {
        return minimum_signed(maximum_signed(v, low), high);
    }
    SPANGLE_INLINE static Mask less_signed(U16 a, U16 b) {
        return std::bit_cast<Mask>(std::bit_cast<Signed>(a) < std::bit_cast<Signed>(b));
    }
    /// v n modulo 2^32, where n holds one 16-bit number in all lanes.
    SPANGLE_INLINE static Words times(const Words& v, const U16& n) {
        const auto halves = std::bit_cast<U16>(v);
        return std::bit_cast<Words>(halves * n) + (std::bit_cast<Words>(mul_high(halves, n)) << 16);
    }
    /// Half-word I of the vector, in all lanes.
    template <int I> SPANGLE_INLINE static U16 splat_half(const Words& v) {
        const auto halves = std::bit_cast<U16>(v);
        return __builtin_shufflevector(halves, halves, I, I, I, I, I, I, I, I);
    }
    SPANGLE_INLINE static U16 mul_signed_512(U16 a, U16 b) { return mul_high_signed(a, b << 7); }
    SPANGLE_INLINE static U16 minimum(U16 a, U16 b) {
        U16 r;
        for (int i = 0; i < 8; ++i)
            r[i] = a[i] < b[i] ? a[i] : b[i];
        return r;
    }
    SPANGLE_INLINE static U16 maximum(U16 a, U16 b) {
        U16 r;
        for (int i = 0; i < 8; ++i)
            r[i] = a[i] < b[i] ? b[i] : a[i];
        return r;
    }
    SPANGLE_INLINE static U16 select(Mask m, U16 a, U16 b) {
#if defined(__AVX2__) // one instruction; the form below compiles to three
        return std::bit_cast<U16>(
            _mm_blendv_epi8(std::bit_cast<__m128i>(b), std::bit_cast<__m128i>(a), std::bit_cast<__m128i>(m)));
#else
        return (m & a) | (~m & b);
#endif
    }
    /// The next functions compare words of 32 bits, all of which are below 2^31.
    SPANGLE_INLINE static U32 minimum(const U32& a, const U32& b) {
        return U32::mapped(
            [](const auto& v, const auto& w)
                __attribute__((always_inline)) { return lane_words::smaller(v, w); },
            a, b);
    }
    SPANGLE_INLINE static U32 maximum(const U32& a, const U32& b) {
        return a + b - minimum(a, b);
    }
    /// The lesser of any two words of 32 bits.
    SPANGLE_INLINE static U32 minimum_unsigned(const U32& a, const U32& b) {
        return U32::mapped(
            [](const auto& v, const auto& w) __attribute__((always_inline)) {
                constexpr std::uint32_t sign = 1u << 31;
                return lane_words::smaller(v ^ sign, w ^ sign) ^ sign;
            },
            a, b);
    }
    /// max(v, 0), where v is signed.
    SPANGLE_INLINE static U32 positive(const U32& v) {
        return U32::mapped(
            [](const auto& w) __attribute__((always_inline)) { return lane_words::positive(w); }, v);
    }
    SPANGLE_INLINE static Mask less(const U32& a, const U32& b) {
        return U32::mapped(
                   [](const auto& v, const auto& w)
                       __attribute__((always_inline)) { return lane_words::is_less(v, w); },
                   a, b)
            .mask();
    }
    SPANGLE_INLINE static U32 select(const Mask& m, const U32& a, const U32& b) {
        return U32::select(m, a, b);
    }
    SPANGLE_INLINE static U16 swap_bytes(U16 v) {
        return (v << 8) | (v >> 8);
    }
    SPANGLE_INLINE static bool any(Mask m) {
#if defined(__AVX2__)
        return _mm_testz_si128(std::bit_cast<__m128i>(m), std::bit_cast<__m128i>(m)) == 0;
#else
        using Halves [[gnu::vector_size(16)]] = std::uint64_t;
        const auto halves = std::bit_cast<Halves>(m);
        return (halves[0] | halves[1]) != 0;
#endif
    }
    /// True where at least one lane is not 0.
    SPANGLE_INLINE static bool any_bits(const U16& v) {
        return any(v);
    }
    SPANGLE_INLINE static bool any_bits(const U32& v) {
        return any(v.any_bits());
    }
    /// One byte per lane. The byte is all ones where any bit of the lane is one.
    SPANGLE_INLINE static std::uint64_t nonzero_bytes(const U16& v) {
        using Bytes [[gnu::vector_size(8)]] = std::int8_t;
        return std::bit_cast<std::uint64_t>(__builtin_convertvector(v != 0, Bytes));
    }
    SPANGLE_INLINE static Mask less(U16 a, U16 b) {
        return std::bit_cast<Mask>(a < b);
    }
    SPANGLE_INLINE static Mask at_most(U16 a, U16 b) {
        return std::bit_cast<Mask>(a <= b);
    }
    SPANGLE_INLINE static Mask equal(U16 a, U16 b) {
        return std::bit_cast<Mask>(a == b);
    }
    SPANGLE_INLINE static Mask both(Mask a, Mask b) {
        return a & b;
    }
    SPANGLE_INLINE static Mask negate(Mask m) {
        return ~m;
    }
    SPANGLE_INLINE static U16 load(const std::uint8_t* p) {
        U16 v;
        __builtin_memcpy(&v, p, 16);
        return v;
    }
    SPANGLE_INLINE static void store(std::uint8_t* p, U16 v) {
        __builtin_memcpy(p, &v, 16);
    }
    /// Joins lanes 0 to 3 (`low`) and lanes 4 to 7 (`high`).
    SPANGLE_INLINE static U16 halves(std::uint64_t low, std::uint64_t high) {
        using Halves [[gnu::vector_size(16)]] = std::uint64_t;
        return std::bit_cast<U16>(Halves{low, high});
    }
    SPANGLE_INLINE static std::uint64_t half(U16 v, int n) {
        using Halves [[gnu::vector_size(16)]] = std::uint64_t;
        return std::bit_cast<Halves>(v)[n];
    }
    /// Loads eight words of 32 bits that lie one after the other.
    SPANGLE_INLINE static U32 load32(const std::uint8_t* p) {
        return U32::load(p);
    }
    SPANGLE_INLINE static void store32(std::uint8_t* p, const U32& v) {
        v.store(p);
    }
    SPANGLE_INLINE static U32 gather(const std::uint32_t* v) {
        return load32(reinterpret_cast<const std::uint8_t*>(v));
    }
    /// The values f(0) .. f(7), one per lane. They move from register to register, because a vector load of
    /// eight stored words would wait for the stores.
    template <class F> SPANGLE_INLINE static auto generate(F f) {
        if constexpr (sizeof(f(0u)) == 2)
            return U16{f(0u), f(1u), f(2u), f(3u), f(4u), f(5u), f(6u), f(7u)};
        else
            return U32::generate(f);
    }
    /// Byte `n` of every lane.
    SPANGLE_INLINE static U16 byte(const U32& v, int n) {
        // This half-word holds byte `n` and one other byte.
        const U16 two = n < 2 ? low_half(v) : high_half(v);
        return n % 2 == 0 ? two & 0xFF : two >> 8;
    }
    SPANGLE_INLINE static U16 gather(const std::uint16_t* v) {
        return U16{v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]};
    }
    SPANGLE_INLINE static void scatter(U16 v, std::uint16_t* to) {
        __builtin_memcpy(to, &v, 16);
    }
    SPANGLE_INLINE static bool lane(Mask m, int i) {
        return m[i] != 0;
    }
    SPANGLE_INLINE static void kill(Mask& m, int i) {
        m[i] = 0;
    }
    SPANGLE_INLINE static Mask first(std::int32_t n) {
        return less(U16{0, 1, 2, 3, 4, 5, 6, 7}, splat(n < 0 ? 0 : static_cast<std::uint32_t>(n)));
    }
};

/// Calls f(i) for each lane i that a guess has left open. An open lane has at least one bit set.
template <class F> SPANGLE_INLINE void each_open(const Lanes<8>::Mask& open, F f) {
    for (std::uint64_t left = Lanes<8>::nonzero_bytes(open); left != 0;) {
        const int lane = std::countr_zero(left) / 8;
        left &= ~(std::uint64_t{0xFF} << (8 * lane));
        f(lane);
    }
}

/// Names the eight lanes that are four columns of two rows. The number is only an argument of Lanes<>, not a
/// count of lanes.
inline constexpr int two_rows = 42;

template <> struct Lanes<two_rows> : Lanes<8> {
    static constexpr int columns = 4, rows = 2;
    struct Place {
        std::uint8_t* first;
        std::ptrdiff_t stride; ///< bytes from the first row to the second
        SPANGLE_INLINE Place& operator+=(std::ptrdiff_t bytes) {
            first += bytes;
            return *this;
        }
        SPANGLE_INLINE friend Place operator+(Place at, std::ptrdiff_t bytes) { return at += bytes; }
    };
    SPANGLE_INLINE static Place place(std::uint8_t* first, std::ptrdiff_t stride) { return {first, stride}; }
    SPANGLE_INLINE static std::uint8_t* pixel(Place at, int lane, int bytes) {
        return at.first + (lane / columns) * at.stride + bytes * (lane % columns);
    }
    SPANGLE_INLINE static U32 offsets(std::uint32_t dx, std::uint32_t dy) { return U32::two_rows(dx, dy); }
    SPANGLE_INLINE static U16 offsets16(U16 dx, U16 dy) {
        constexpr std::uint16_t on = 0xFFFF;
        return dx * U16{0, 1, 2, 3, 0, 1, 2, 3} + (dy & U16{0, 0, 0, 0, on, on, on, on});
    }
    SPANGLE_INLINE static U16 load(const Place& at) {
        std::uint64_t row[2];
        __builtin_memcpy(row, at.first, 8);
        __builtin_memcpy(row + 1, at.first + at.stride, 8);
        return halves(row[0], row[1]);
    }
    SPANGLE_INLINE static void store(const Place& at, U16 v) {
        const std::uint64_t row[2] = {half(v, 0), half(v, 1)};
        __builtin_memcpy(at.first, row, 8);
        __builtin_memcpy(at.first + at.stride, row + 1, 8);
    }
};

/// These functions read and write one lane of eight.
SPANGLE_INLINE void lane_of(const Lanes<8>::U16& v, int i, std::uint32_t& to) {
    to = v[i];
}
SPANGLE_INLINE void set_lane(Lanes<8>::U16& v, int i, std::uint32_t from) {
    v[i] = static_cast<std::uint16_t>(from);
}
SPANGLE_INLINE void lane_of(const Lanes<8>::U32& v, int i, std::uint32_t& to) {
    to = v.lane(i);
}
SPANGLE_INLINE void set_lane(Lanes<8>::U32& v, int i, std::uint32_t from) {
    v.set_lane(i, from);
}
/// A plain number counts as a vector of one lane.
SPANGLE_INLINE void lane_of(std::uint32_t v, int, std::uint32_t& to) {
    to = v;
}
SPANGLE_INLINE void set_lane(std::uint32_t& v, int, std::uint32_t from) {
    v = from;
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster

// Scales components of up to eight bits from one number of bits to another, in words of 16 bits. The result
// is that of rescale (component.hpp), by a multiplication.
#pragma once

#include <array>
#include <cstdint>

namespace spangle::gl {

inline constexpr unsigned most_code_bits = 8;

/// A code c becomes (c * factor + half) >> shift. All products fit 16 bits.
struct CodeScale {
    std::uint16_t factor = 0, half = 0, shift = 0;
};

namespace detail {

/// Returns the scale with this factor and shift that gives the nearest code for every code. If there is none,
/// the result has the factor 0.
constexpr CodeScale scale_by(std::uint32_t factor, std::uint32_t shift, std::uint32_t last,
                             std::uint32_t most) {
    std::uint32_t low = 0, high = 0xFFFF; // possible values of `half`
    for (std::uint32_t c = 0; c <= last && low <= high; ++c) {
        const std::uint32_t nearest = (c * most + last / 2) / last, product = c * factor;
        const std::uint32_t begin = nearest << shift, end = (nearest + 1) << shift;
        if (product >= end)
            return {};
        if (begin > product && begin - product > low)
            low = begin - product;
        if (end - product - 1 < high)
            high = end - product - 1;
    }
    if (low > high || last * factor + low > 0xFFFF)
        return {};
    return {static_cast<std::uint16_t>(factor), static_cast<std::uint16_t>(low),
            static_cast<std::uint16_t>(shift)};
}

/// The scale with the smallest shift that is exact.
constexpr CodeScale find_scale(unsigned from, unsigned to) {
    const std::uint32_t last = (1u << from) - 1, most = (1u << to) - 1;
    for (std::uint32_t shift = 0; shift < 16; ++shift)
        for (std::uint32_t up = 0; up < 2; ++up)
            if (const CodeScale s = scale_by((most << shift) / last + up, shift, last, most); s.factor != 0)
                return s;
    return {};
}

constexpr bool all_found(const auto& scales) {
    for (unsigned from = 1; from <= most_code_bits; ++from)
        for (unsigned to = 1; to <= most_code_bits; ++to)
            if (scales[from][to].factor == 0)
                return false;
    return true;
}

} // namespace detail

/// The scales, indexed by the bits before and after, 1 to 8.
inline constexpr auto code_scales = [] {
    std::array<std::array<CodeScale, most_code_bits + 1>, most_code_bits + 1> scales{};
    for (unsigned from = 1; from <= most_code_bits; ++from)
        for (unsigned to = 1; to <= most_code_bits; ++to)
            scales[from][to] = detail::find_scale(from, to);
    return scales;
}();
static_assert(detail::all_found(code_scales));

} // namespace spangle::gl

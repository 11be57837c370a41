#include "gl/pixel/zoom.hpp"

#include "raster/numeric/bits.hpp"
#include "raster/numeric/reciprocal.hpp"

namespace spangle::gl {

namespace {

constexpr int fraction_bits = 32;
constexpr std::int64_t one = std::int64_t{1} << fraction_bits, half = one / 2;
constexpr int number_bits = 58; ///< distances of up to 2^26 pixels; nothing farther away is visible
constexpr std::int64_t farthest = std::int64_t{1} << 61;

/// Returns a Real as an integer with 32 fraction bits, saturated to number_bits.
std::int64_t fixed(numeric::Real v) {
    const numeric::detail::Unpacked u = numeric::detail::unpack(v);
    const std::int32_t up = u.exponent + fraction_bits;
    const std::uint64_t magnitude = up > number_bits - 24
                                        ? (u.mantissa != 0 ? std::uint64_t{1} << number_bits : 0)
                                        : numeric::shift_right_even(u.mantissa, -up);
    const auto bounded = static_cast<std::int64_t>(magnitude);
    return u.negative ? -bounded : bounded;
}

/// Returns the product a * n for n >= 0, saturated to the range from -farthest to farthest.
std::int64_t times(std::int64_t a, std::int32_t n) {
    const std::uint64_t low = (static_cast<std::uint64_t>(a) & (one - 1)) * static_cast<std::uint32_t>(n);
    const std::int64_t high = (a >> fraction_bits) * n + static_cast<std::int64_t>(low >> fraction_bits);
    constexpr std::int64_t most = farthest >> fraction_bits;
    if (high >= most || high < -most)
        return high < 0 ? -farthest : farthest;
    return high * one + static_cast<std::int64_t>(low & (one - 1));
}

} // namespace

[[gnu::noinline]] Interval clip_interval(std::int32_t at, std::int32_t size, std::int32_t low,
                                         std::int32_t high) {
    std::int32_t end = 0;
    if (__builtin_add_overflow(at, size, &end))
        end = high;
    return {numeric::clamp(at, low, high), numeric::clamp(end, low, high)};
}

std::int32_t whole_pixels(numeric::Real at, numeric::Real origin, std::int32_t ahead) {
    constexpr numeric::Real limit = numeric::from_fixed(1, fraction_bits - number_bits);
    const bool near = numeric::abs(at) < limit && numeric::abs(origin) < limit;
    const std::int64_t corner = near ? fixed(at) - fixed(origin) : fixed(numeric::sub(at, origin));
    constexpr std::int64_t nearly = one >> 13;
    return static_cast<std::int32_t>((corner + nearly + ahead * (one >> 12)) >> fraction_bits);
}

ZoomAxis::ZoomAxis(numeric::Real at, numeric::Real zoom, std::int32_t shift)
    : origin_(fixed(at) + shift * (one >> 8)), zoom_(fixed(zoom)) {}

/// The first fragment whose centre is at or after the beginning of a group.
[[gnu::noinline]] std::int32_t ZoomAxis::first_fragment(std::int32_t group) const {
    const std::int64_t edge = origin_ + times(zoom_, group);
    const std::int64_t fragment = (edge - half + (one - 1)) >> fraction_bits; // |edge| < 2^62
    return numeric::saturate_i32(fragment);
}

ZoomAxis::Range ZoomAxis::covered_fragments(std::int32_t first, std::int32_t last, std::int32_t low,
                                            std::int32_t high) const {
    const std::int32_t a = first_fragment(first), b = first_fragment(last);
    const Range all = zoom_ < 0 ? Range{b, a} : Range{a, b};
    return {all.begin > low ? all.begin : low, all.end < high ? all.end : high};
}

/// The walk begins with d / |zoom|, where d is the distance of the fragment's centre from the raster
/// position, less 2^-32 for a negative zoom. Both are positive, as the fragment is covered, so the floor of
/// the quotient is the group.
ZoomAxis::GroupWalk ZoomAxis::from(std::int32_t fragment) const {
    const std::int64_t center = fragment * one + half;
    const std::int64_t d = zoom_ < 0 ? origin_ - center - 1 : center - origin_;
    GroupWalk walk;
    walk.divisor_ = zoom_ < 0 ? -zoom_ : zoom_;
    const auto divided = [&](std::int64_t n, std::int64_t& quotient, std::int64_t& rest) {
        const numeric::LongQuotient q =
            numeric::divide_long(static_cast<std::uint64_t>(n), static_cast<std::uint64_t>(walk.divisor_));
        quotient = static_cast<std::int64_t>(q.quotient);
        rest = static_cast<std::int64_t>(q.remainder);
    };
    divided(d, walk.group_, walk.remainder_); // d is not negative, since the fragment is covered
    divided(one, walk.step_quotient_, walk.step_remainder_);
    if (zoom_ < 0) {
        walk.step_quotient_ = -walk.step_quotient_;
        walk.step_remainder_ = -walk.step_remainder_;
    }
    return walk;
}

void ZoomAxis::GroupWalk::step() {
    group_ += step_quotient_;
    remainder_ += step_remainder_;
    if (remainder_ >= divisor_) {
        remainder_ -= divisor_;
        ++group_;
    } else if (remainder_ < 0) {
        remainder_ += divisor_;
        --group_;
    }
}

} // namespace spangle::gl

#include <spangle/hal/wire.hpp>

#include <spangle/dither.hpp>

namespace spangle::hal {
namespace {

/// A component as the surface holds it: k / max.
struct Component {
    std::uint32_t k = 0, max = 255;
};
struct Color {
    Component r, g, b;
};

Color load(PixelFormat format, const std::uint8_t* p) {
    if (format == PixelFormat::rgb888 || format == PixelFormat::rgba8888)
        return {{p[0], 255}, {p[1], 255}, {p[2], 255}};
    const unsigned high = format == PixelFormat::rgb565_be ? p[0] : p[1];
    const unsigned low = format == PixelFormat::rgb565_be ? p[1] : p[0];
    const std::uint32_t word = high << 8 | low;
    return {{word >> 11, 31}, {word >> 5 & 63, 63}, {word & 31, 31}};
}

/// v / max, exactly, for the three maxima above and v < 2^14: m = ceil(2^22 / max) and v (m max - 2^22) <
/// 2^22.
std::uint32_t divide(std::uint32_t v, std::uint32_t max) {
    const std::uint32_t m = max == 255 ? 16449u : max == 63 ? 66577u : 135301u;
    return v * m >> 22;
}

/// floor(k / max (2^Bits - 1) + threshold / 32): what GL dithers to (docs/architecture.md, "Numbers").
template <unsigned Bits> std::uint32_t dithered(Component c, std::uint32_t threshold) {
    return divide(c.k * ((1u << Bits) - 1) + (threshold * c.max >> 5), c.max);
}

std::uint32_t eight_bits(Component c) {
    return divide(c.k * 255 + c.max / 2, c.max);
}

template <unsigned Bits> std::uint32_t dithered_grey(const Color& c, std::uint32_t threshold) {
    return dithered<Bits>({luma(eight_bits(c.r), eight_bits(c.g), eight_bits(c.b)), 255}, threshold);
}

/// A row of the picture, to be asked for its pixels' values.
template <class Value> class Row {
  public:
    Row(const Picture& picture, std::int32_t y)
        : at_(picture.pixels + static_cast<std::ptrdiff_t>(y) * picture.stride), format_(picture.format),
          bytes_(format_info(picture.format).bytes_per_pixel),
          thresholds_(dither_row(picture.height - 1 - y)) {}

    std::uint32_t operator[](std::int32_t x) const {
        return Value{}(load(format_, at_ + static_cast<std::ptrdiff_t>(x) * bytes_),
                       dither_threshold(thresholds_, x));
    }

  private:
    const std::uint8_t* at_;
    PixelFormat format_;
    std::int32_t bytes_;
    std::uint32_t thresholds_;
};

template <unsigned Red, unsigned Green, unsigned Blue> struct Packed {
    std::uint32_t operator()(const Color& c, std::uint32_t threshold) const {
        return dithered<Red>(c.r, threshold) << (Green + Blue) | dithered<Green>(c.g, threshold) << Blue |
               dithered<Blue>(c.b, threshold);
    }
};
template <unsigned Bits> struct Grey {
    std::uint32_t operator()(const Color& c, std::uint32_t threshold) const {
        return dithered_grey<Bits>(c, threshold);
    }
};

std::uint8_t low_byte(std::uint32_t v) {
    return static_cast<std::uint8_t>(v);
}

/// Calls `put` with the value of each pixel, row by row.
template <class Value, class Put> void for_each(const Picture& picture, const Rect& area, Put put) {
    for (std::int32_t y = area.y; y < area.y + area.h; ++y) {
        const Row<Value> row(picture, y);
        for (std::int32_t x = area.x; x < area.x + area.w; ++x)
            put(row[x]);
    }
}

/// The bytes of formats whose pixels share one: `Count` of them, side by side, or one above the other.
/// `join(byte, value, i)` adds the i-th.
template <class Value, int Count, class Join>
std::size_t share_bytes(const Picture& picture, const Rect& area, bool side_by_side, std::uint8_t* to,
                        Join join) {
    std::uint8_t* const begin = to;
    const std::int32_t across = side_by_side ? Count : 1, down = side_by_side ? 1 : Count;
    for (std::int32_t y = area.y; y < area.y + area.h; y += down)
        for (std::int32_t x = area.x; x < area.x + area.w; x += across) {
            std::uint32_t byte = 0;
            for (std::int32_t i = 0; i < Count; ++i)
                byte = join(byte, Row<Value>(picture, side_by_side ? y : y + i)[side_by_side ? x + i : x], i);
            *to++ = low_byte(byte);
        }
    return static_cast<std::size_t>(to - begin);
}

} // namespace

std::size_t to_rgb565(const Picture& picture, const Rect& area, std::uint8_t* to) {
    std::uint8_t* const begin = to;
    for_each<Packed<5, 6, 5>>(picture, area, [&to](std::uint32_t v) {
        *to++ = low_byte(v >> 8);
        *to++ = low_byte(v);
    });
    return static_cast<std::size_t>(to - begin);
}

std::size_t to_rgb666(const Picture& picture, const Rect& area, std::uint8_t* to) {
    std::uint8_t* const begin = to;
    for_each<Packed<6, 6, 6>>(picture, area, [&to](std::uint32_t v) {
        *to++ = low_byte(v >> 12 << 2);
        *to++ = low_byte((v >> 6 & 63) << 2);
        *to++ = low_byte((v & 63) << 2);
    });
    return static_cast<std::size_t>(to - begin);
}

/// An odd pixel at the end takes two bytes; the four bits behind it are never looked at.
std::size_t to_rgb444(const Picture& picture, const Rect& area, std::uint8_t* to) {
    std::uint8_t* const begin = to;
    bool second = false;
    for_each<Packed<4, 4, 4>>(picture, area, [&](std::uint32_t v) {
        if (second) {
            to[-1] = low_byte(to[-1] | v >> 8);
            *to++ = low_byte(v);
        } else {
            *to++ = low_byte(v >> 4);
            *to++ = low_byte(v << 4);
        }
        second = !second;
    });
    return static_cast<std::size_t>(to - begin);
}

std::size_t to_rgb332(const Picture& picture, const Rect& area, std::uint8_t* to) {
    std::uint8_t* const begin = to;
    for_each<Packed<3, 3, 2>>(picture, area, [&to](std::uint32_t v) { *to++ = low_byte(v); });
    return static_cast<std::size_t>(to - begin);
}

std::size_t to_grey4(const Picture& picture, const Rect& area, std::uint8_t* to) {
    return share_bytes<Grey<4>, 2>(
        picture, area, !picture.sideways, to,
        [](std::uint32_t byte, std::uint32_t value, std::int32_t) { return byte << 4 | value; });
}

std::size_t to_mono(const Picture& picture, const Rect& area, std::uint8_t* to) {
    return share_bytes<Grey<1>, 8>(
        picture, area, picture.sideways, to,
        [](std::uint32_t byte, std::uint32_t value, std::int32_t i) { return byte | value << i; });
}

} // namespace spangle::hal

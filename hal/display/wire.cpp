#include <spangle/hal/wire.hpp>

#include <type_traits>

namespace spangle::hal {
namespace {

/// A component k / Max, as the surface holds it.
template <std::uint32_t Max> struct Component { std::uint32_t k = 0; };

template <unsigned Bits, std::uint32_t Max>
std::uint32_t dithered(Component<Max> c, std::uint32_t threshold) {
    return dithered_step<Bits, Max>(c.k, threshold);
}

template <std::uint32_t Max> std::uint32_t eight_bits(Component<Max> c) {
    return divide_by<Max>(c.k * 255 + Max / 2);
}

/// A pixel of 16 bits. `high` is the index of its high byte.
struct Of565 {
    Component<31> r;
    Component<63> g;
    Component<31> b;

    Of565(const std::uint8_t* p, std::int32_t high) {
        const std::uint32_t word = std::uint32_t{p[high]} << 8 | p[1 - high];
        r.k = word >> 11, g.k = word >> 5 & 63, b.k = word & 31;
    }
};

/// A pixel with one byte per component, with or without alpha, or an entry of a palette.
struct Of888 {
    Component<255> r, g, b;

    Of888(const std::uint8_t* p, std::int32_t) : r{p[0]}, g{p[1]}, b{p[2]} {}
};

/// A row of the picture. It gives the values of its pixels on the wire.
template <class Color, class Value> class Row {
  public:
    Row() = default;
    Row(const Picture& picture, std::int32_t y)
        : source_(picture.pixels + static_cast<std::ptrdiff_t>(y) * picture.stride),
          bytes_per_pixel_(format_info(picture.format).bytes_per_pixel),
          high_bits_(picture.format == PixelFormat::rgb565_be ? 0 : 1),
          palette_(is_indexed(picture.format) ? picture.palette : nullptr),
          thresholds_(dither_row(picture.height - 1 - y)) {}

    std::uint32_t operator[](std::int32_t x) const {
        return Value{}(Color(pixel(x), high_bits_), dither_threshold(thresholds_, x));
    }

  private:
    const std::uint8_t* pixel(std::int32_t x) const {
        if constexpr (SPANGLE_FEATURE_COLOR_INDEX && std::is_same_v<Color, Of888>)
            if (palette_ != nullptr)
                return palette_->color[source_[x]];
        return source_ + static_cast<std::ptrdiff_t>(x) * bytes_per_pixel_;
    }

    const std::uint8_t* source_ = nullptr;
    std::int32_t bytes_per_pixel_ = 0, high_bits_ = 0;
    const Palette* palette_ = nullptr;
    std::uint32_t thresholds_ = 0;
};

/// Calls `convert` for the colour type of the picture's pixels.
template <class Convert> std::size_t for_format(const Picture& picture, Convert convert) {
    const bool wide = picture.format == PixelFormat::rgb888 || picture.format == PixelFormat::rgba8888 ||
                      is_indexed(picture.format);
    return wide ? convert.template operator()<Of888>() : convert.template operator()<Of565>();
}

template <unsigned Red, unsigned Green, unsigned Blue> struct Packed {
    template <class Color> std::uint32_t operator()(const Color& c, std::uint32_t threshold) const {
        return dithered<Red>(c.r, threshold) << (Green + Blue) | dithered<Green>(c.g, threshold) << Blue |
               dithered<Blue>(c.b, threshold);
    }
};
template <unsigned Bits> struct Grey {
    template <class Color> std::uint32_t operator()(const Color& c, std::uint32_t threshold) const {
        return dithered<Bits>(Component<255>{luma(eight_bits(c.r), eight_bits(c.g), eight_bits(c.b))},
                              threshold);
    }
};

std::uint8_t low_byte(std::uint32_t v) {
    return static_cast<std::uint8_t>(v);
}

/// Calls `put` with the value of each pixel, row by row.
template <class Value, class Put> void for_each(const Picture& picture, const Rect& area, Put put) {
    for_format(picture, [&]<class Color>() -> std::size_t {
        for (std::int32_t y = area.y; y < area.y + area.h; ++y) {
            const Row<Color, Value> row(picture, y);
            for (std::int32_t x = area.x; x < area.x + area.w; ++x)
                put(row[x]);
        }
        return 0;
    });
}

/// Writes formats in which `Count` pixels share a byte, side by side or one above the other. `join(byte,
/// value, i)` adds the i-th pixel to the byte.
template <class Value, int Count, class Join>
std::size_t share_bytes(const Picture& picture, const Rect& area, bool side_by_side, std::uint8_t* to,
                        Join join) {
    const std::int32_t across = side_by_side ? Count : 1, down = side_by_side ? 1 : Count;
    return for_format(picture, [&]<class Color>() {
        std::uint8_t* at = to;
        Row<Color, Value> rows[Count];
        for (std::int32_t y = area.y; y < area.y + area.h; y += down) {
            for (std::int32_t i = 0; i < down; ++i)
                rows[i] = Row<Color, Value>(picture, y + i);
            for (std::int32_t x = area.x; x < area.x + area.w; x += across) {
                std::uint32_t byte = 0;
                for (std::int32_t i = 0; i < Count; ++i)
                    byte = join(byte, side_by_side ? rows[0][x + i] : rows[i][x], i);
                *at++ = low_byte(byte);
            }
        }
        return static_cast<std::size_t>(at - to);
    });
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

/// An odd last pixel takes two bytes. The last four bits of the second byte are ignored.
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

// Texels of packets are found, fetched and filtered in lanes. They must be those of single fragments for
// every wrap mode, filter, size, level, shape and number of fragments.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include "raster/chain/assemble.hpp"
#include "tests/unit/span/any_texture.hpp"

namespace spangle::raster::test {
namespace {

constexpr Wrap wraps[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp, Wrap::clamp_to_edge,
                          Wrap::clamp_to_border};

std::uint32_t word(Random& random) {
    return random.below(1u << 16) << 16 | random.below(1u << 16);
}
/// Returns a random coordinate: anywhere, or within two steps of an edge or middle of a texel, or of the
/// place where filters round.
std::uint32_t coordinate(Random& random, Wrap wrap, std::int32_t size) {
    if (random.below(3) == 0)
        return word(random);
    const bool repeats = wrap == Wrap::repeat || wrap == Wrap::mirrored_repeat;
    const std::int64_t one = std::int64_t{1}
                             << (repeats ? wrap == Wrap::repeat ? 32 : 31 : clamped_coord_bits);
    const std::int64_t halves = random.below(static_cast<std::uint32_t>(2 * size + 3)),
                       round = random.below(3) == 0   ? 0
                               : random.below(2) == 0 ? one >> 13
                                                      : one >> 9;
    return static_cast<std::uint32_t>(((halves - 1) * one - round) / (2 * size) +
                                      static_cast<std::int64_t>(random.below(5)) - 2);
}

void expect_axis(Random& random, Wrap wrap, std::int32_t size) {
    constexpr std::int32_t group = 11;
    std::uint32_t coord[texel_groups * group];
    for (auto& v : coord)
        v = coordinate(random, wrap, size);
    const std::int32_t groups = 1 + static_cast<std::int32_t>(random.below(texel_groups));
    for (const bool linear : {false, true}) {
        TexelNumbers found;
        const bool inside = AxisLanes(wrap, size).find(linear, coord, group, groups, found);
        bool expected = true;
        for (std::int32_t i = 0; i < 8 * groups; ++i) {
            const std::uint32_t v = coord[i / 8 * group + i % 8];
            const auto number = [&](const auto& numbers) {
                return static_cast<std::int16_t>(numbers[i / 8][i % 8]);
            };
            const TexelIndex texel =
                linear ? general_linear(wrap, v, size) : TexelIndex{general_nearest(wrap, v, size), 0};
            const std::int32_t at = linear ? wrap_texel(wrap, texel.i, size) : texel.i,
                               next = linear ? wrap_texel(wrap, texel.i + 1, size) : at;
            expected = expected && at >= 0 && next < size;
            ASSERT_EQ(number(found.at), at) << static_cast<int>(wrap) << ' ' << size << ' ' << v << linear;
            if (!linear)
                continue;
            ASSERT_EQ(number(found.next), next) << static_cast<int>(wrap) << ' ' << size << ' ' << v;
            ASSERT_EQ(found.weight[i / 8][i % 8], texel.weight)
                << static_cast<int>(wrap) << ' ' << size << ' ' << v;
        }
        ASSERT_EQ(inside, expected) << static_cast<int>(wrap) << ' ' << size << ' ' << linear;
    }
}

TEST(TexelLanes, NumbersAreThoseOfSingleFragments) {
    Random random{71};
    for (const Wrap wrap : wraps)
        for (const std::int32_t size : {1, 2, 3, 5, 8, 31, 64, 100, 1024, 2048, 2047, 3000, 4095})
            for (int n = 0; n < 60; ++n)
                expect_axis(random, wrap, size);
}

/// Sizes that are powers of two have arithmetic of their own for coordinates that do not wrap.
TEST(TexelLanes, PlacesInPlainImagesAreThoseOfAnySize) {
    Random random{73};
    for (const Wrap wrap : {Wrap::clamp, Wrap::clamp_to_edge, Wrap::clamp_to_border})
        for (int log2_size = 0; log2_size <= 11; ++log2_size)
            for (int n = 0; n < 2000; ++n) {
                const std::int32_t size = 1 << log2_size;
                const std::uint32_t v = n == 0   ? 0x7FFFFFFF
                                        : n == 1 ? 0x80000000
                                                 : coordinate(random, wrap, size);
                const TexelIndex found = wrapped_linear(wrap, v, log2_size, size),
                                 expected = general_linear(wrap, v, size);
                ASSERT_EQ(found.i, expected.i) << size << ' ' << v;
                ASSERT_EQ(found.weight, expected.weight) << size << ' ' << v;
                ASSERT_EQ(wrapped_nearest(wrap, v, log2_size, size), general_nearest(wrap, v, size))
                    << size << ' ' << v;
            }
}

TEST(TexelLanes, ExactFilterIsThatOfOneLane) {
    Random random{72};
    for (std::uint32_t weights = 0; weights < 1u << 16; ++weights) {
        const std::uint32_t a = weights & 255, b = weights >> 8;
        std::uint32_t texel[4][8];
        LaneBytes bytes[4];
        for (int k = 0; k < 4; ++k) {
            for (auto& v : texel[k])
                v = random.below(4) == 0 ? (random.below(2) == 0 ? 0 : ~0u) : word(random);
            bytes[k] = LaneBytes::of(Lanes<8>::gather(texel[k]));
        }
        const auto found =
            ExactFilter(Lanes<8>::splat(a), Lanes<8>::splat(b))(bytes[0], bytes[1], bytes[2], bytes[3]);
        const int lane = static_cast<int>(weights * 5 % 8);
        Exact::Color one;
        lane_of(found, lane, one);
        using Colors = TexelColors<Exact, false, true>;
        const auto of = [&](int k) { return Colors::unpack(texel[k][lane]); };
        const auto expected = bilinear<Exact>(of(0), of(1), of(2), of(3), a, b);
        ASSERT_EQ(one.r, expected.r) << a << ' ' << b;
        ASSERT_EQ(one.g, expected.g) << a << ' ' << b;
        ASSERT_EQ(one.b, expected.b) << a << ' ' << b;
        ASSERT_EQ(one.a, expected.a) << a << ' ' << b;
        const auto mixed = Colors::mix(Colors::Weights(b), texel[0][lane], texel[1][lane], texel[2][lane],
                                       texel[3][lane], a);
        ASSERT_EQ(mixed.r, expected.r) << a << ' ' << b;
        ASSERT_EQ(mixed.g, expected.g) << a << ' ' << b;
        ASSERT_EQ(mixed.b, expected.b) << a << ' ' << b;
        ASSERT_EQ(mixed.a, expected.a) << a << ' ' << b;
    }
}

/// Compares eight lanes with one lane: the colour of every word of a format, and mixtures of four colours.
template <class Wide> void expect_colors_of_words(TexelFormat format) {
    using One = OneLane<Wide>;
    using L = typename Wide::L;
    Random random{static_cast<std::uint32_t>(format)};
    const auto expect_equal = [](const typename Wide::Color& found, int lane,
                                 const typename One::Color& expected, std::uint32_t word) {
        typename One::Color one;
        lane_of(found, lane, one);
        ASSERT_EQ(one.r, expected.r) << word;
        ASSERT_EQ(one.g, expected.g) << word;
        ASSERT_EQ(one.b, expected.b) << word;
        ASSERT_EQ(one.a, expected.a) << word;
    };
    const std::uint32_t words = format == TexelFormat::rgb332 ? 256 : 65536;
    for (std::uint32_t first = 0; first < words; first += 8) {
        const auto lanes =
            L::generate([&](std::uint32_t lane) { return static_cast<std::uint16_t>(first + lane); });
        const auto colors = texel_as_color<Wide>(format, lanes);
        typename One::Color one[8];
        for (std::uint32_t lane = 0; lane < 8; ++lane) {
            const std::uint8_t low_first[2] = {static_cast<std::uint8_t>(first + lane),
                                               static_cast<std::uint8_t>((first + lane) >> 8)};
            one[lane] = read_texel<One>(format, low_first);
            expect_equal(colors, static_cast<int>(lane), one[lane], first + lane);
        }
        std::uint16_t corner[3][8], weight[2][8];
        for (int lane = 0; lane < 8; ++lane) {
            for (auto& of : corner)
                of[lane] = static_cast<std::uint16_t>(random.below(words));
            for (auto& of : weight)
                of[lane] = static_cast<std::uint16_t>(random.below(4) == 0 ? 0 : random.below(256));
        }
        const auto color = [&](int k) { return texel_as_color<Wide>(format, L::gather(corner[k])); };
        const auto mixed = mixed_colors<Wide>(colors, color(0), color(1), color(2), L::gather(weight[0]),
                                              L::gather(weight[1]));
        for (int lane = 0; lane < 8; ++lane) {
            const auto single = [&](int k) { return texel_as_color<One>(format, corner[k][lane]); };
            expect_equal(
                mixed, lane,
                bilinear<One>(one[lane], single(0), single(1), single(2), weight[0][lane], weight[1][lane]),
                first);
        }
    }
}

TEST(TexelLanes, ColorsOfWordsAreThoseOfOneLane) {
    if constexpr (host_lanes == 8)
        for (const TexelFormat format : {TexelFormat::rgba5551, TexelFormat::rgb332}) {
            expect_colors_of_words<Balanced<host_lanes>>(format);
            expect_colors_of_words<ExactChain>(format);
        }
}

/// Draws a packet of any length by REPLACE. Neighbours lie near each other, but some fragments lie anywhere.
/// Levels differ by less than `spread` 256ths, have a bias, and are held between limits near them.
template <class N> void expect_packet(Random& random, const Texture& any, std::uint32_t spread) {
    using One = OneLane<N>;
    DrawState state;
    Texture texture = any;
    if (random.below(2) == 0) {
        texture.min_lod = static_cast<std::int32_t>(random.below(3 * 256)) - 256;
        texture.max_lod = texture.min_lod + static_cast<std::int32_t>(random.below(3 * 256));
        state.fragment.unit[0].lod_bias = static_cast<std::int32_t>(random.below(513)) - 256;
    }
    state.fragment.unit[0].texture = &texture;
    state.fragment.unit[0].env = TexEnv::replace;
    Span<Fixed> span{};
    span.state = &state;
    const TextureFunction<One> function(state.fragment.unit[0]);
    Packet<N> packet;
    packet.x = 0;
    packet.n = 1 + static_cast<std::int32_t>(random.below(packet_length));
    const auto lod = static_cast<std::int32_t>(random.below(6 * 256)) - 256;
    const std::uint32_t step = random.below(1u << 20), s = word(random), t = word(random);
    const typename One::Color before{1, 2, 3, 4};
    for (std::int32_t i = 0; i < packet.n; ++i) {
        auto& at = packet.coord[0][i / N::lanes];
        const std::uint32_t far = step * static_cast<std::uint32_t>(i);
        at.s[i % N::lanes] = random.below(8) == 0 ? word(random) : (s + far) >> 4;
        at.t[i % N::lanes] = random.below(8) == 0 ? word(random) : (t - far) >> 4;
        packet.lod[0][i] = lod + static_cast<std::int32_t>(random.below(spread));
        set_lane(packet.color[i / N::lanes], i % N::lanes, before);
    }
    PacketTexture<N>::template run<0>(packet, span);
    for (std::int32_t i = 0; i < packet.n; ++i) {
        const auto& at = packet.coord[0][i / N::lanes];
        typename One::Color expected = before, found;
        apply_env<One>(TexEnv::replace, texture.base, expected,
                       function.sample(at.s[i % N::lanes], at.t[i % N::lanes],
                                       function.wants_lod ? packet.lod[0][i] : 0),
                       before);
        lane_of(packet.color[i / N::lanes], i % N::lanes, found);
        ASSERT_EQ(found.r, expected.r) << i;
        ASSERT_EQ(found.g, expected.g) << i;
        ASSERT_EQ(found.b, expected.b) << i;
        ASSERT_EQ(found.a, expected.a) << i;
    }
}
void expect_packets(Random& random, const Texture& texture, std::uint32_t spread) {
    if constexpr (host_lanes > 1) {
        expect_packet<Balanced<host_lanes>>(random, texture, spread);
        expect_packet<ExactChain>(random, texture, spread);
    }
    expect_packet<Balanced<1>>(random, texture, spread); // the numbers of microcontrollers
    expect_packet<Exact>(random, texture, spread);
}

TEST(TexelLanes, PacketsAreTheirFragments) {
    Random random{73};
    for (int n = 0; n < 5000; ++n) {
        const AnyTexture any(random);
        if (!wants_r(any.texture)) // coordinates of the other shapes come from the span
            expect_packets(random, any.texture, n % 2 == 0 ? 8 : 600);
    }
}

TEST(TexelLanes, RowsFarApartAreFound) {
    Random random{74};
    constexpr std::uint32_t stride = 40'000, rows = 4;
    std::vector<std::uint8_t> texels(std::size_t{rows} * stride);
    for (auto& v : texels)
        v = static_cast<std::uint8_t>(random.below(256));
    Texture texture;
    texture.format = TexelFormat::rgba8888;
    texture.base = BaseFormat::rgba;
    texture.min = texture.mag;
    texture.level_count = 1;
    texture.level[0] = {texels.data(), 8, rows, stride};
    for (int n = 0; n < 50; ++n)
        expect_packets(random, texture, 1);
}

/// Memory between two pages that nobody may touch.
class Guarded {
  public:
    Guarded() {
        at_ = static_cast<std::uint8_t*>(
            mmap(nullptr, 3 * page_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
        EXPECT_EQ(mprotect(first(), page_, PROT_READ | PROT_WRITE), 0);
    }
    ~Guarded() { munmap(at_, 3 * page_); }
    Guarded(const Guarded&) = delete;
    Guarded& operator=(const Guarded&) = delete;

    std::uint8_t* first() const { return at_ + page_; }
    std::uint8_t* end() const { return at_ + 2 * page_; }

  private:
    std::size_t page_ = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    std::uint8_t* at_;
};

TEST(TexelLanes, NothingIsReadBesideAnImage) {
    Random random{75};
    const Guarded memory;
    for (std::uint8_t* at = memory.first(); at != memory.end(); ++at)
        *at = static_cast<std::uint8_t>(random.below(256));
    for (const TexelFormat format : {TexelFormat::a8, TexelFormat::l8, TexelFormat::i8, TexelFormat::la88,
                                     TexelFormat::rgb565, TexelFormat::rgb888, TexelFormat::rgba8888})
        for (const Wrap wrap : wraps)
            for (const std::uint16_t width : {1, 2, 3, 8})
                for (const std::uint16_t height : {1, 2, 5}) {
                    Texture texture;
                    texture.format = format;
                    texture.base = format == TexelFormat::rgb565 ? BaseFormat::rgb : BaseFormat::rgba;
                    texture.wrap_s = texture.wrap_t = wrap;
                    texture.mag = texture.min = Filter::linear;
                    texture.level_count = 1;
                    const auto stride = static_cast<std::uint32_t>(width * texel_bytes(format));
                    for (const std::uint8_t* const texels :
                         {memory.first(), memory.end() - height * stride}) {
                        texture.level[0] = {texels, width, height, stride};
                        expect_packets(random, texture, 1);
                    }
                }
}

} // namespace
} // namespace spangle::raster::test

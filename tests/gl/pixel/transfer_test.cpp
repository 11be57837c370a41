// Compares pixel transfer and pixel maps with arithmetic in double (GL 1.3, 3.6.3 and 3.6.5; docs/features.md
// E03, E04).
#include <gtest/gtest.h>

#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_PIXEL_TRANSFER

#include <bit>
#include <cmath>
#include <cstring>
#include <random>

#include "gl/api/generated/commands.hpp"
#include "gl/pixel/group.hpp"
#include "tests/gl/pixel/bare_context.hpp"

namespace spangle::gl {
namespace {

using test::BareContext;
using test::SharedMemory;

struct PixelTransferTest : testing::Test {
    ~PixelTransferTest() override {
        for (PixelMap* map : context.pixel_mode.map)
            memory.arena.free(map);
        EXPECT_EQ(memory.arena.used(), 0u);
    }
    void set(GLenum pname, float value) {
        Params params;
        const bool integer = pname == GL_INDEX_SHIFT || pname == GL_INDEX_OFFSET;
        params.v[0] = integer ? Param::from_integer(static_cast<std::uint32_t>(static_cast<int>(value)))
                              : Param::from(numeric::from_float(value));
        params.count = 1;
        cmd::PixelTransfer(context, pname, params);
        EXPECT_EQ(bare.take_error(), GLenum{GL_NO_ERROR});
    }
    void map(GLenum name, const std::vector<float>& values) {
        cmd::PixelMap(context, name, static_cast<GLsizei>(values.size()), {values.data(), GL_FLOAT});
        EXPECT_EQ(bare.take_error(), GLenum{GL_NO_ERROR});
    }
    SharedMemory memory{1 << 16};
    BareContext bare{memory};
    Context& context = bare.context;
};

/// Returns the reals that a group of RGBA ubytes becomes.
void transferred(const Context& context, const std::uint8_t (&group)[4], float out[4]) {
    PixelLayout layout;
    pixel_layout(GL_RGBA, GL_UNSIGNED_BYTE, layout);
    const Pixel pixel = ColorImage(context, layout).color(group, 0);
    for (unsigned c = 0; c < 4; ++c)
        out[c] = numeric::to_float(to_real(pixel.value[c]));
}

TEST_F(PixelTransferTest, ScaleAndBiasAreThoseOfTheirComponent) {
    constexpr GLenum scales[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE},
                     biases[] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};
    std::mt19937 random(1);
    for (int i = 0; i < 400; ++i) {
        float scale[4], bias[4], out[4];
        std::uint8_t group[4];
        for (unsigned c = 0; c < 4; ++c) {
            scale[c] = static_cast<float>(static_cast<int>(random() % 2001) - 1000) / 128.0f;
            bias[c] = static_cast<float>(static_cast<int>(random() % 2001) - 1000) / 300.0f;
            set(scales[c], scale[c]);
            set(biases[c], bias[c]);
            group[c] = static_cast<std::uint8_t>(random());
        }
        transferred(context, group, out);
        for (unsigned c = 0; c < 4; ++c)
            EXPECT_NEAR(out[c], group[c] / 255.0 * scale[c] + bias[c], 1e-6 * (1 + std::fabs(scale[c])));
    }
}

/// Transfer rounds twice as a float does, and nothing else happens.
TEST_F(PixelTransferTest, ArithmeticIsThatOfFloats) {
    std::mt19937 random(2);
    for (int i = 0; i < 2000; ++i) {
        const auto k = static_cast<std::uint8_t>(random());
        const float scale = static_cast<float>(random() % 4096) / 777.0f,
                    bias = static_cast<float>(random() % 4096) / 999.0f - 2;
        set(GL_RED_SCALE, scale);
        set(GL_RED_BIAS, bias);
        float out[4];
        transferred(context, {k, 0, 0, 0}, out);
        const volatile float product = static_cast<float>(k / 255.0) * scale;
        const float sum = product + bias;
        EXPECT_EQ(std::bit_cast<std::uint32_t>(out[0]), std::bit_cast<std::uint32_t>(sum)) << int{k};
    }
}

TEST_F(PixelTransferTest, IdentityChangesNoCode) {
    PixelLayout layout;
    for (GLenum type : {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT}) {
        pixel_layout(GL_RGBA, type, layout);
        const unsigned char group[8] = {1, 2, 3, 4, 5, 6, 7, 8};
        const ColorImage image(context, layout);
        EXPECT_TRUE(image.is_plain());
        const Pixel pixel = image.color(group, 0);
        for (unsigned c = 0; c < 4; ++c)
            EXPECT_EQ(pixel.value[c].bits, type == GL_UNSIGNED_BYTE ? 8 : 16);
    }
    set(GL_ALPHA_BIAS, 0.25f);
    EXPECT_FALSE(ColorImage(context, layout).is_plain());
    set(GL_ALPHA_BIAS, 0);
    EXPECT_TRUE(ColorImage(context, layout).is_plain());
    set(GL_MAP_COLOR, 0.3f); // a boolean is true if it is not zero
    EXPECT_FALSE(ColorImage(context, layout).is_plain());
}

TEST_F(PixelTransferTest, MapsAddressTheNearestEntryOfTheClampedValue) {
    std::mt19937 random(3);
    for (std::size_t size : {1u, 2u, 3u, 7u, 32u, 255u, 256u}) {
        std::vector<float> table(size);
        for (float& entry : table)
            entry = static_cast<float>(random() % 1000) / 999.0f;
        map(GL_PIXEL_MAP_G_TO_G, table);
        set(GL_MAP_COLOR, 1);
        set(GL_GREEN_SCALE, 1.5f);
        set(GL_GREEN_BIAS, -0.25f);
        for (int k = 0; k < 256; ++k) {
            float out[4];
            transferred(context, {0, static_cast<std::uint8_t>(k), 0, 0}, out);
            const double v =
                std::fmin(1, std::fmax(0, k / 255.0 * 1.5 - 0.25)) * static_cast<double>(size - 1);
            if (std::fabs(v - std::floor(v) - 0.5) > 1e-5) { // only where rounding of floats does not decide
                EXPECT_EQ(out[1], table[static_cast<std::size_t>(std::lround(v))]) << size << ' ' << k;
            }
            EXPECT_EQ(out[0], 0.0f); // the map of red has one entry
        }
        set(GL_GREEN_SCALE, 1);
        set(GL_GREEN_BIAS, 0);
        for (int k = 0; k < 256; ++k) { // results are exact, with halves rounded up
            float out[4];
            transferred(context, {0, static_cast<std::uint8_t>(k), 0, 0}, out);
            EXPECT_EQ(out[1], table[(2 * static_cast<std::size_t>(k) * (size - 1) + 255) / 510])
                << size << ' ' << k;
        }
    }
}

TEST_F(PixelTransferTest, IndicesBecomeColoursWhateverMapColorIs) {
    map(GL_PIXEL_MAP_I_TO_R, {0, 0.25f, 0.5f, 1});
    map(GL_PIXEL_MAP_I_TO_G, {1, 0});
    map(GL_PIXEL_MAP_I_TO_A, {0.5f});
    set(GL_RED_SCALE, 7); // scales components, not indices
    PixelLayout layout;
    pixel_layout(GL_COLOR_INDEX, GL_UNSIGNED_BYTE, layout);
    for (int shift : {-40, -2, -1, 0, 1, 3, 48})
        for (int offset : {-300, -1, 0, 1, 77})
            for (int k = 0; k < 256; ++k) {
                set(GL_INDEX_SHIFT, static_cast<float>(shift));
                set(GL_INDEX_OFFSET, static_cast<float>(offset));
                const auto byte = static_cast<unsigned char>(k);
                const Pixel pixel = ColorImage(context, layout).color(&byte, 0);
                const double moved = std::floor(shift >= 48 ? 0 : k * std::pow(2.0, shift) + 0.5) + offset;
                const auto index = static_cast<unsigned>(static_cast<long long>(moved));
                constexpr float reds[] = {0, 0.25f, 0.5f, 1};
                EXPECT_EQ(numeric::to_float(to_real(pixel.value[0])), reds[index & 3]) << k << ' ' << shift;
                EXPECT_EQ(numeric::to_float(to_real(pixel.value[1])), (index & 1) == 0 ? 1.0f : 0.0f);
                EXPECT_EQ(numeric::to_float(to_real(pixel.value[2])), 0.0f);
                EXPECT_EQ(numeric::to_float(to_real(pixel.value[3])), 0.5f);
            }
}

TEST_F(PixelTransferTest, BitsAreIndices) {
    map(GL_PIXEL_MAP_I_TO_B, {0.125f, 1});
    PixelLayout layout;
    ASSERT_EQ(pixel_layout(GL_COLOR_INDEX, GL_BITMAP, layout), GLenum{GL_NO_ERROR});
    const unsigned char row[2] = {0b10110001, 0b01111111};
    for (bool lsb_first : {false, true}) {
        context.pixel_store.unpack.lsb_first = lsb_first;
        const ColorImage image(context, layout);
        for (std::size_t i = 0; i < 16; ++i) {
            const bool on = (row[i / 8] >> (lsb_first ? i % 8 : 7 - i % 8) & 1) != 0;
            EXPECT_EQ(numeric::to_float(to_real(image.color(row, i).value[2])), on ? 1.0f : 0.125f) << i;
        }
    }
}

TEST_F(PixelTransferTest, StencilAndDepthHaveTheirOwn) {
    map(GL_PIXEL_MAP_S_TO_S, {7, 300.7f, -1, 12});
    const auto stencil = [&](int k) { return rounded(Transfer(context.pixel_mode).stencil(whole_index(k))); };
    set(GL_MAP_COLOR, 1); // does not enable MAP_STENCIL
    EXPECT_EQ(stencil(200), 200u);
    set(GL_INDEX_SHIFT, 2);
    set(GL_INDEX_OFFSET, -1);
    EXPECT_EQ(stencil(3), 11u);
    EXPECT_EQ(stencil(0), 0xFFFFFFFFu);
    set(GL_MAP_STENCIL, 1);
    EXPECT_EQ(stencil(0), 12u); // -1 & 3
    set(GL_INDEX_OFFSET, 1);
    EXPECT_EQ(stencil(9), 301u);
    set(GL_INDEX_OFFSET, 2);
    EXPECT_EQ(stencil(9), 0xFFFFFFFFu);

    const auto depth = [&](Component z) {
        return numeric::to_float(to_real(Transfer(context.pixel_mode).depth(z)));
    };
    set(GL_RED_SCALE, 3);
    EXPECT_EQ(depth({0x8000, 16}), static_cast<float>(0x8000 / 65535.0));
    set(GL_DEPTH_SCALE, -2);
    set(GL_DEPTH_BIAS, 0.5f);
    EXPECT_EQ(depth({65535, 16}), -1.5f);
}

TEST_F(PixelTransferTest, ReadPixelsGoesThroughIt) {
    bare.color[0] = 51;  // 0.2
    bare.color[1] = 102; // 0.4
    bare.color[2] = 0;
    bare.color[3] = 255;
    set(GL_RED_SCALE, 2);
    set(GL_GREEN_BIAS, 0.5f);
    set(GL_BLUE_BIAS, -0.25f);
    std::uint8_t rgba[4], grey;
    cmd::ReadPixels(context, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    EXPECT_EQ(rgba[0], 102);
    EXPECT_EQ(rgba[1], 229); // 0.9 as a float is a little less
    EXPECT_EQ(rgba[2], 0);
    EXPECT_EQ(rgba[3], 255);
    cmd::ReadPixels(context, 0, 0, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, &grey);
    EXPECT_EQ(grey, 255); // 0.4 + 0.9 - 0.25
    set(GL_GREEN_BIAS, -0.1f);
    cmd::ReadPixels(context, 0, 0, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, &grey);
    EXPECT_EQ(grey, 115); // 0.4 + 0.3 - 0.25, clamped at the end only
    float real[4];
    cmd::ReadPixels(context, 0, 0, 1, 1, GL_RGBA, GL_FLOAT, real);
    EXPECT_EQ(real[2], 0.0f);

    bare.planes[0] = 5; // the stored stencil value
    set(GL_INDEX_OFFSET, -7);
    float index;
    std::int8_t small;
    cmd::ReadPixels(context, 0, 0, 1, 1, GL_STENCIL_INDEX, GL_FLOAT, &index);
    EXPECT_EQ(index, -2.0f); // indices are not masked here
    cmd::ReadPixels(context, 0, 0, 1, 1, GL_STENCIL_INDEX, GL_BYTE, &small);
    EXPECT_EQ(small, 0x7E);
    bare.planes[3] = 0x80;
    set(GL_DEPTH_SCALE, 3);
    set(GL_DEPTH_BIAS, -1);
    cmd::ReadPixels(context, 0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &index);
    EXPECT_NEAR(index, 0.5, 1e-5);
    EXPECT_EQ(bare.take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(PixelTransferTest, MapsAreReturnedAsTheyWereGiven) {
    const std::uint32_t indices[4] = {0, 1, 0xFFFFFFFF, 0x12345679},
                        fractions[3] = {0, 0x80000000, 0xFFFFFFFF};
    std::uint32_t words[4];
    float reals[4];
    std::uint16_t shorts[4];
    cmd::PixelMap(context, GL_PIXEL_MAP_I_TO_I, 4, {indices, GL_UNSIGNED_INT});
    cmd::GetPixelMap(context, GL_PIXEL_MAP_I_TO_I, {words, GL_UNSIGNED_INT});
    EXPECT_EQ(std::memcmp(words, indices, sizeof words), 0);
    cmd::GetPixelMap(context, GL_PIXEL_MAP_I_TO_I, {reals, GL_FLOAT});
    EXPECT_EQ(reals[2], 4294967296.0f);
    cmd::PixelMap(context, GL_PIXEL_MAP_A_TO_A, 3, {fractions, GL_UNSIGNED_INT});
    cmd::GetPixelMap(context, GL_PIXEL_MAP_A_TO_A, {reals, GL_FLOAT});
    EXPECT_EQ(reals[1], 0.5f);
    EXPECT_EQ(reals[2], 1.0f);
    cmd::GetPixelMap(context, GL_PIXEL_MAP_A_TO_A, {words, GL_UNSIGNED_INT});
    EXPECT_EQ(words[1], 0x80000000u);
    EXPECT_EQ(words[2], 0xFFFFFFFFu);
    cmd::GetPixelMap(context, GL_PIXEL_MAP_A_TO_A, {shorts, GL_UNSIGNED_SHORT});
    EXPECT_EQ(shorts[1], 32768);
    const std::uint16_t given[2] = {0x1234, 0xFFFF};
    cmd::PixelMap(context, GL_PIXEL_MAP_R_TO_R, 2, {given, GL_UNSIGNED_SHORT});
    cmd::GetPixelMap(context, GL_PIXEL_MAP_R_TO_R, {shorts, GL_UNSIGNED_SHORT});
    EXPECT_EQ(std::memcmp(shorts, given, sizeof given), 0);
    map(GL_PIXEL_MAP_B_TO_B, {-3, 0.5f, 9});
    cmd::GetPixelMap(context, GL_PIXEL_MAP_B_TO_B, {reals, GL_FLOAT});
    EXPECT_EQ(reals[0], 0.0f);
    EXPECT_EQ(reals[2], 1.0f);
    map(GL_PIXEL_MAP_I_TO_I, {2.75f});
    cmd::GetPixelMap(context, GL_PIXEL_MAP_I_TO_I, {reals, GL_FLOAT});
    EXPECT_EQ(reals[0], 2.75f);
    cmd::GetPixelMap(context, GL_PIXEL_MAP_I_TO_I, {words, GL_UNSIGNED_INT});
    EXPECT_EQ(words[0], 3u);
    cmd::GetPixelMap(context, GL_PIXEL_MAP_S_TO_S, {words, GL_UNSIGNED_INT});
    EXPECT_EQ(words[0], 0u);
    EXPECT_EQ(bare.take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(PixelTransferTest, WrongMapsChangeNothing) {
    map(GL_PIXEL_MAP_I_TO_R, {1, 0});
    const std::vector<float> values(600);
    struct Case {
        GLenum map;
        GLsizei size;
        const void* at;
        GLenum code;
    };
    const Case cases[] = {{GL_PIXEL_MAP_I_TO_R, 3, values.data(), GL_INVALID_VALUE},
                          {GL_PIXEL_MAP_S_TO_S, 24, values.data(), GL_INVALID_VALUE},
                          {GL_PIXEL_MAP_I_TO_R, 0, values.data(), GL_INVALID_VALUE},
                          {GL_PIXEL_MAP_I_TO_R, -1, values.data(), GL_INVALID_VALUE},
                          {GL_PIXEL_MAP_I_TO_R, 512, values.data(), GL_INVALID_VALUE},
                          {GL_PIXEL_MAP_I_TO_R, 2, nullptr, GL_INVALID_VALUE},
                          {GL_PIXEL_MAP_A_TO_A + 1, 1, values.data(), GL_INVALID_ENUM},
                          {GL_PIXEL_MAP_I_TO_I - 1, 1, values.data(), GL_INVALID_ENUM},
                          {GL_PIXEL_MAP_A_TO_A, 3, values.data(), GL_NO_ERROR},
                          {GL_PIXEL_MAP_I_TO_A, 256, values.data(), GL_NO_ERROR}};
    for (const Case& c : cases) {
        cmd::PixelMap(context, c.map, c.size, {c.at, GL_FLOAT});
        EXPECT_EQ(bare.take_error(), c.code) << c.map << ' ' << c.size;
        EXPECT_EQ(context.pixel_mode.map[map_i_to_r]->size, 2);
    }
    void* rest = nullptr; // fills all memory
    for (std::size_t bytes = 1 << 16; bytes >= 16; bytes /= 2)
        while (void* const block = memory.arena.allocate(bytes)) {
            *static_cast<void**>(block) = rest;
            rest = block;
        }
    cmd::PixelMap(context, GL_PIXEL_MAP_I_TO_R, 256, {values.data(), GL_FLOAT});
    EXPECT_EQ(bare.take_error(), GLenum{GL_OUT_OF_MEMORY});
    EXPECT_EQ(context.pixel_mode.map[map_i_to_r]->size, 2);
    while (rest != nullptr) {
        void* const next = *static_cast<void**>(rest);
        memory.arena.free(rest);
        rest = next;
    }
}

TEST(PixelIndex, ElementsShiftAndRound) {
    const auto real = [](float v) { return index_of(numeric::from_float(v)); };
    EXPECT_EQ(rounded(real(2.5f)), 3u);
    EXPECT_EQ(rounded(real(2.49f)), 2u);
    EXPECT_EQ(rounded(real(-1.0f)), 0xFFFFFFFFu);
    EXPECT_EQ(rounded(shifted(real(1.25f), 2, 0)), 5u); // the shift keeps the fraction
    EXPECT_EQ(rounded(real(4000000000.0f)), 4000000000u);
    EXPECT_EQ(rounded(real(1e30f)), 0x80000000u); // the result saturates
    EXPECT_EQ(numeric::to_float(to_real(real(-7.5f))), -7.5f);
    EXPECT_EQ(rounded(decode_index(ElementKind::signed_integer, 8, 0x80)), 0xFFFFFF80u);
    EXPECT_EQ(rounded(decode_index(ElementKind::signed_integer, 32, 0x80000000)), 0x80000000u);
    EXPECT_EQ(rounded(decode_index(ElementKind::unsigned_integer, 32, 0xFFFFFFFF)), 0xFFFFFFFFu);
    EXPECT_EQ(rounded(shifted(whole_index(0xFFFF0000), 16, 5)), 5u); // bits that leave at the left are lost
    // Zeros come in from the left; the result is rounded up.
    EXPECT_EQ(rounded(shifted(whole_index(-1), -1, 0)), 0x7FFFFFFFu + 1);
    for (int shift : {48, 100, INT32_MAX, -48, INT32_MIN})
        EXPECT_EQ(rounded(shifted(whole_index(-1), shift, 0)), 0u);
}

TEST(PixelComponent, SignedElementsKeepTheirSign) {
    for (unsigned bits : {8u, 16u, 32u})
        for (std::int64_t c : {-1, -2, -100, -128}) {
            const auto element = static_cast<std::uint32_t>(c) & all_ones(bits);
            const double wanted = (2.0 * static_cast<double>(c) + 1) / all_ones(bits);
            EXPECT_FLOAT_EQ(
                numeric::to_float(to_real(decode_element(ElementKind::signed_integer, bits, element))),
                static_cast<float>(wanted));
        }
    EXPECT_EQ(numeric::to_float(to_real(decode_element(ElementKind::signed_integer, 32, 0x80000000))), -1.0f);
}

TEST(PixelComponent, RealsAreReturnedLikeCodes) {
    std::mt19937 random(4);
    for (int i = 0; i < 100000; ++i) {
        const float v = static_cast<float>(random()) / 4294967296.0f * 1.4f - 0.2f;
        const double f = std::fmin(1, std::fmax(0, static_cast<double>(v)));
        const Component c = component(numeric::from_float(v));
        for (unsigned bits : {8u, 16u, 32u}) {
            const double most = all_ones(bits);
            EXPECT_EQ(encode_element(ElementKind::unsigned_integer, bits, c),
                      static_cast<std::uint32_t>(std::floor(f * most + 0.5)));
            EXPECT_EQ(encode_element(ElementKind::signed_integer, bits, c),
                      static_cast<std::uint32_t>(std::floor(f * most / 2)));
        }
        EXPECT_EQ(encode_element(ElementKind::real, 32, c),
                  std::bit_cast<std::uint32_t>(static_cast<float>(f)));
        EXPECT_NEAR(color_units_of(c), f * 255 * 1048576, 0.5001);
    }
    for (unsigned bits : {1u, 2u, 4u, 5u, 6u, 8u, 10u, 16u})
        for (std::uint32_t k = 0; k <= all_ones(bits); ++k)
            ASSERT_LE(std::fabs(color_units_of({k, static_cast<std::uint8_t>(bits)}) -
                                k * 255.0 * 1048576 / all_ones(bits)),
                      0.5);
}

} // namespace
} // namespace spangle::gl

#endif

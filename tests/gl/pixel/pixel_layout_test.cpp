// Tests formats, types and the places of their bytes (GL 1.3, 3.6.4; docs/features.md E01, E02).
#include <gtest/gtest.h>

#include <string>

#include "gl/pixel/group.hpp"

namespace spangle::gl {
namespace {

constexpr GLenum color_formats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA,     GL_RGB,
                                    GL_BGR, GL_RGBA,  GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA};

void unpack(const PixelLayout& layout, bool swap_bytes, const unsigned char* from, std::uint32_t rgba[4]) {
    PixelStore store;
    store.swap_bytes = swap_bytes;
    const Pixel color = Groups(layout, store).color(from, 0);
    for (unsigned c = 0; c < 4; ++c)
        rgba[c] = code_of(color.value[c], 8);
}

int components_of(GLenum format) {
    switch (format) {
    case GL_RGB:
    case GL_BGR:
        return 3;
    case GL_RGBA:
    case GL_BGRA:
        return 4;
    case GL_LUMINANCE_ALPHA:
        return 2;
    default:
        return 1;
    }
}

struct Plain {
    GLenum type;
    unsigned bytes;
};
constexpr Plain plain_types[] = {{GL_UNSIGNED_BYTE, 1}, {GL_BYTE, 1}, {GL_UNSIGNED_SHORT, 2}, {GL_SHORT, 2},
                                 {GL_UNSIGNED_INT, 4},  {GL_INT, 4},  {GL_FLOAT, 4}};

TEST(PixelLayout, PlainTypesGoWithEveryFormat) {
    for (GLenum format : color_formats)
        for (const Plain& type : plain_types) {
            PixelLayout layout;
            ASSERT_EQ(pixel_layout(format, type.type, layout), GLenum{GL_NO_ERROR});
            EXPECT_EQ(layout.group_bytes(), static_cast<unsigned>(components_of(format)) * type.bytes);
            EXPECT_FALSE(layout.packed);
        }
    PixelLayout layout;
    EXPECT_EQ(pixel_layout(GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, layout), GLenum{GL_NO_ERROR});
    EXPECT_EQ(pixel_layout(GL_STENCIL_INDEX, GL_BITMAP, layout), GLenum{GL_NO_ERROR});
}

TEST(PixelLayout, Refusals) {
    PixelLayout layout;
    for (GLenum format : color_formats)
        EXPECT_EQ(pixel_layout(format, GL_BITMAP, layout), GLenum{GL_INVALID_ENUM});
    for (GLenum unknown : {GLenum{0}, GLenum{GL_INTENSITY}, GLenum{GL_TEXTURE_2D}, GLenum{0xFFFFFFFF},
                           GLenum{GL_RGBA + 0x10000}})
        EXPECT_EQ(pixel_layout(unknown, GL_UNSIGNED_BYTE, layout), GLenum{GL_INVALID_ENUM}) << unknown;
    for (GLenum unknown : {GLenum{0}, GLenum{0x140A}, GLenum{GL_RGBA}, GLenum{GL_FLOAT + 0x10000}})
        EXPECT_EQ(pixel_layout(GL_RGBA, unknown, layout), GLenum{GL_INVALID_ENUM}) << unknown;
}

/// A packed type as table 3.8 and figures 3.x describe it: the highest and lowest bit of each component.
struct PackedCase {
    GLenum type, format;
    unsigned bytes;
    struct {
        unsigned high, low;
    } r, g, b, a;
};
constexpr PackedCase packed_cases[] = {
    {GL_UNSIGNED_BYTE_3_3_2, GL_RGB, 1, {7, 5}, {4, 2}, {1, 0}, {0, 1}},
    {GL_UNSIGNED_BYTE_2_3_3_REV, GL_RGB, 1, {2, 0}, {5, 3}, {7, 6}, {0, 1}},
    {GL_UNSIGNED_SHORT_5_6_5, GL_RGB, 2, {15, 11}, {10, 5}, {4, 0}, {0, 1}},
    {GL_UNSIGNED_SHORT_5_6_5_REV, GL_RGB, 2, {4, 0}, {10, 5}, {15, 11}, {0, 1}},
    {GL_UNSIGNED_SHORT_4_4_4_4, GL_RGBA, 2, {15, 12}, {11, 8}, {7, 4}, {3, 0}},
    {GL_UNSIGNED_SHORT_4_4_4_4, GL_BGRA, 2, {7, 4}, {11, 8}, {15, 12}, {3, 0}},
    {GL_UNSIGNED_SHORT_4_4_4_4_REV, GL_RGBA, 2, {3, 0}, {7, 4}, {11, 8}, {15, 12}},
    {GL_UNSIGNED_SHORT_5_5_5_1, GL_RGBA, 2, {15, 11}, {10, 6}, {5, 1}, {0, 0}},
    {GL_UNSIGNED_SHORT_1_5_5_5_REV, GL_RGBA, 2, {4, 0}, {9, 5}, {14, 10}, {15, 15}},
    {GL_UNSIGNED_SHORT_1_5_5_5_REV, GL_BGRA, 2, {14, 10}, {9, 5}, {4, 0}, {15, 15}},
    {GL_UNSIGNED_INT_8_8_8_8, GL_RGBA, 4, {31, 24}, {23, 16}, {15, 8}, {7, 0}},
    {GL_UNSIGNED_INT_8_8_8_8_REV, GL_RGBA, 4, {7, 0}, {15, 8}, {23, 16}, {31, 24}},
    {GL_UNSIGNED_INT_8_8_8_8_REV, GL_BGRA, 4, {23, 16}, {15, 8}, {7, 0}, {31, 24}},
    {GL_UNSIGNED_INT_10_10_10_2, GL_RGBA, 4, {31, 22}, {21, 12}, {11, 2}, {1, 0}},
    {GL_UNSIGNED_INT_2_10_10_10_REV, GL_RGBA, 4, {9, 0}, {19, 10}, {29, 20}, {31, 30}},
};

TEST(PixelLayout, PackedFieldsUnpackAndPack) {
    for (const PackedCase& c : packed_cases) {
        PixelLayout layout;
        ASSERT_EQ(pixel_layout(c.format, c.type, layout), GLenum{GL_NO_ERROR});
        ASSERT_EQ(layout.group_bytes(), c.bytes);
        const struct {
            unsigned high, low;
        } fields[4] = {{c.r.high, c.r.low}, {c.g.high, c.g.low}, {c.b.high, c.b.low}, {c.a.high, c.a.low}};
        for (int lit = 0; lit < 4; ++lit) { // one component is all ones, the others are zero
            if (fields[lit].high < fields[lit].low)
                continue; // the format has no such component
            const unsigned bits = fields[lit].high - fields[lit].low + 1;
            const std::uint32_t word = all_ones(bits) << fields[lit].low;
            for (bool swap : {false, true}) {
                unsigned char bytes[4];
                store_element(bytes, c.bytes, swap, word);
                std::uint32_t rgba[4];
                unpack(layout, swap, bytes, rgba);
                for (int k = 0; k < 4; ++k) {
                    const bool missing = k == 3 && c.format == GL_RGB;
                    EXPECT_EQ(rgba[k], k == lit || missing ? 255u : 0u) << std::hex << c.type << " " << k;
                }
                Pixel pixel;
                pixel.value[lit] = {255, 8};
                unsigned char out[4] = {0xAA, 0xAA, 0xAA, 0xAA};
                pack_pixel(layout, swap, pixel, out);
                EXPECT_EQ(load_element(out, c.bytes, swap), word) << std::hex << c.type << " " << lit;
            }
        }
    }
}

TEST(PixelLayout, PackedTypesWantTheirNumberOfComponents) {
    for (const PackedCase& c : packed_cases)
        for (GLenum format : color_formats) {
            PixelLayout layout;
            const bool three = c.format == GL_RGB;
            const bool fits = three ? format == GL_RGB : format == GL_RGBA || format == GL_BGRA;
            EXPECT_EQ(pixel_layout(format, c.type, layout),
                      fits ? GLenum{GL_NO_ERROR} : GLenum{GL_INVALID_OPERATION})
                << std::hex << c.type << " " << format;
        }
    PixelLayout layout;
    EXPECT_EQ(pixel_layout(GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT_5_6_5, layout),
              GLenum{GL_INVALID_OPERATION});
    EXPECT_EQ(pixel_layout(GL_STENCIL_INDEX, GL_UNSIGNED_INT_8_8_8_8, layout), GLenum{GL_INVALID_OPERATION});
}

TEST(PixelLayout, MissingComponentsAndLuminance) {
    const unsigned char bytes[4] = {10, 20, 30, 40};
    const struct {
        GLenum format;
        std::uint32_t rgba[4];
    } cases[] = {
        {GL_RED, {10, 0, 0, 255}},         {GL_GREEN, {0, 10, 0, 255}},
        {GL_BLUE, {0, 0, 10, 255}},        {GL_ALPHA, {0, 0, 0, 10}},
        {GL_RGB, {10, 20, 30, 255}},       {GL_BGR, {30, 20, 10, 255}},
        {GL_RGBA, {10, 20, 30, 40}},       {GL_BGRA, {30, 20, 10, 40}},
        {GL_LUMINANCE, {10, 10, 10, 255}}, {GL_LUMINANCE_ALPHA, {10, 10, 10, 20}},
    };
    for (const auto& c : cases) {
        PixelLayout layout;
        ASSERT_EQ(pixel_layout(c.format, GL_UNSIGNED_BYTE, layout), GLenum{GL_NO_ERROR});
        std::uint32_t rgba[4];
        unpack(layout, false, bytes, rgba);
        for (int k = 0; k < 4; ++k)
            EXPECT_EQ(rgba[k], c.rgba[k]) << std::hex << c.format << " " << k;
    }
}

TEST(PixelLayout, StridesOfTheReferenceTable) {
    const struct {
        GLsizei width;
        std::size_t rgb[4]; // strides of rows for ALIGNMENT 1, 2, 4 and 8
        std::size_t bitmap1, bitmap4;
    } rows[] = {
        {1, {3, 4, 4, 8}, 1, 4},      {5, {15, 16, 16, 16}, 1, 4},     {16, {48, 48, 48, 48}, 2, 4},
        {17, {51, 52, 52, 56}, 3, 4}, {33, {99, 100, 100, 104}, 5, 8},
    };
    PixelLayout rgb, bitmap;
    ASSERT_EQ(pixel_layout(GL_RGB, GL_UNSIGNED_BYTE, rgb), GLenum{GL_NO_ERROR});
    ASSERT_EQ(pixel_layout(GL_STENCIL_INDEX, GL_BITMAP, bitmap), GLenum{GL_NO_ERROR});
    for (const auto& row : rows) {
        PixelStore store;
        for (int i = 0; i < 4; ++i) {
            store.alignment = 1 << i;
            EXPECT_EQ(image_rows(store, rgb, row.width).stride, row.rgb[i])
                << row.width << " " << store.alignment;
        }
        store.alignment = 1;
        EXPECT_EQ(image_rows(store, bitmap, row.width).stride, row.bitmap1);
        store.alignment = 4;
        EXPECT_EQ(image_rows(store, bitmap, row.width).stride, row.bitmap4);
    }
}

TEST(PixelLayout, SkipsAndRowLength) {
    PixelLayout layout;
    ASSERT_EQ(pixel_layout(GL_RGBA, GL_UNSIGNED_SHORT, layout), GLenum{GL_NO_ERROR});
    PixelStore store;
    store.alignment = 8; // pads rows of 2-byte elements to 8 bytes
    store.row_length = 5;
    store.skip_rows = 3;
    store.skip_pixels = 2;
    const ImageRows rows = image_rows(store, layout, 4);
    EXPECT_EQ(rows.stride, 40u);
    EXPECT_EQ(rows.skip, 3 * 40u + 2 * 8u);
    store.row_length = 0;
    EXPECT_EQ(image_rows(store, layout, 3).stride, 24u);
    // If the element is as large as the alignment (s >= a), rows are not padded.
    ASSERT_EQ(pixel_layout(GL_RGB, GL_FLOAT, layout), GLenum{GL_NO_ERROR});
    store.alignment = 4;
    EXPECT_EQ(image_rows(store, layout, 3).stride, 36u);
    // SKIP_PIXELS of a bitmap skips bits.
    ASSERT_EQ(pixel_layout(GL_STENCIL_INDEX, GL_BITMAP, layout), GLenum{GL_NO_ERROR});
    store = {};
    store.skip_pixels = 11;
    store.skip_rows = 2;
    EXPECT_EQ(image_rows(store, layout, 20).skip, 2 * 4u + 1);
    EXPECT_EQ(image_rows(store, layout, 20).skip_bits, 3u);
}

} // namespace
} // namespace spangle::gl

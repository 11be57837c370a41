// Compares conversions of components with their definitions (GL 1.3, tables 2.6 and 4.7).
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "gl/pixel/component.hpp"

namespace spangle::gl {
namespace {

double value_of(Component c) {
    return static_cast<double>(c.code) / static_cast<double>(all_ones(c.bits));
}

TEST(Component, RescaleIsNearestForAllSmallCodes) {
    for (unsigned from : {1u, 2u, 3u, 4u, 5u, 6u, 8u, 10u, 16u})
        for (unsigned to : {1u, 2u, 3u, 4u, 5u, 6u, 8u, 10u, 16u, 24u, 32u})
            for (std::uint32_t code = 0; code <= all_ones(from); ++code) {
                const std::uint64_t got = rescale(code, from, to);
                // The condition is |got / ones_to - code / ones_from| <= half a step, without a division.
                const auto a = static_cast<__int128>(got) * all_ones(from) * 2;
                const auto b = static_cast<__int128>(code) * all_ones(to) * 2;
                const auto off = a > b ? a - b : b - a;
                ASSERT_LT(off, static_cast<__int128>(all_ones(from))) << from << "->" << to << " " << code;
            }
}

TEST(Component, RescaleKeepsEndsAndWideCodes) {
    for (unsigned from : {24u, 32u})
        for (unsigned to : {1u, 5u, 8u, 16u, 24u, 32u}) {
            EXPECT_EQ(rescale(0, from, to), 0u);
            EXPECT_EQ(rescale(all_ones(from), from, to), all_ones(to));
        }
    // Components of 5 and 6 bits are read back as ubytes (GL 1.3, 4.3.2).
    EXPECT_EQ(rescale(1, 5, 8), 8u);
    EXPECT_EQ(rescale(12, 5, 8), 99u);
    EXPECT_EQ(rescale(15, 5, 8), 123u);
    EXPECT_EQ(rescale(16, 5, 8), 132u);
    EXPECT_EQ(rescale(25, 6, 8), 101u);
    EXPECT_EQ(rescale(62, 6, 8), 251u);
}

TEST(Component, RealIsTheNearestFloat) {
    for (unsigned bits : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u, 10u, 16u})
        for (std::uint32_t code = 0; code <= all_ones(bits); ++code) {
            const Component c{code, static_cast<std::uint8_t>(bits)};
            ASSERT_EQ(numeric::to_float(to_real(c)), static_cast<float>(value_of(c))) << bits << " " << code;
        }
    std::mt19937 random(1);
    for (int i = 0; i < 200000; ++i) {
        const Component z{static_cast<std::uint32_t>(random()) >> (8 + i % 20), 24};
        ASSERT_EQ(numeric::to_float(to_real(z)), static_cast<float>(value_of(z))) << z.code;
    }
    EXPECT_EQ(numeric::to_float(to_real({0xFFFFFFFF, 32})), 1.0f);
}

struct Entry {
    ElementKind kind;
    unsigned bits;
    std::uint32_t element;
    double value;
};

TEST(Component, ElementsMeanWhatTable26Says) {
    const Entry entries[] = {
        {ElementKind::signed_integer, 8, 0, 1.0 / 255},
        {ElementKind::signed_integer, 8, 0xFF, 0}, // -1 / 255 is clamped
        {ElementKind::signed_integer, 8, 127, 1},
        {ElementKind::signed_integer, 8, 0x80, 0},
        {ElementKind::signed_integer, 8, 64, 129.0 / 255},
        {ElementKind::signed_integer, 16, 0x7FFF, 1},
        {ElementKind::signed_integer, 16, 0x8000, 0},
        {ElementKind::signed_integer, 32, 0x7FFFFFFF, 1},
        {ElementKind::signed_integer, 32, 0x40000000, 0.5},
        {ElementKind::unsigned_integer, 8, 128, 128.0 / 255},
        {ElementKind::unsigned_integer, 16, 0xFFFF, 1},
        {ElementKind::unsigned_integer, 32, 0x40000000, 0.25},
        {ElementKind::real, 32, std::bit_cast<std::uint32_t>(0.75f), 0.75},
        {ElementKind::real, 32, std::bit_cast<std::uint32_t>(-3.0f), 0},
        {ElementKind::real, 32, std::bit_cast<std::uint32_t>(1e30f), 1},
        {ElementKind::real, 32, 0x7F800000, 1}, // infinity
        {ElementKind::real, 32, 0xFF800000, 0},
        {ElementKind::real, 32, 0x7FC00000, 0}, // NaN
        {ElementKind::real, 32, 0x00000001, 0}, // the smallest denormal
    };
    for (const Entry& e : entries)
        for (unsigned bits : {5u, 6u, 8u, 16u}) {
            const auto wanted = static_cast<std::uint32_t>(std::floor(e.value * all_ones(bits) + 0.5));
            EXPECT_EQ(code_of(decode_element(e.kind, e.bits, e.element), bits), wanted)
                << e.element << " to " << bits;
        }
}

/// Returns the fraction that an element stands for (GL 1.3, table 2.6); 0 if it is negative.
double meant(bool is_signed, unsigned bits, std::uint32_t element) {
    const double most = all_ones(bits);
    if (!is_signed)
        return element / most;
    const double c = element > all_ones(bits) / 2 ? element - (most + 1) : element;
    return std::fmax(0, (2 * c + 1) / most);
}

TEST(Component, ElementsDecodeToTheNearestCode) {
    const auto check = [](unsigned bits, std::uint32_t element) {
        for (const bool is_signed : {false, true}) {
            const Component c = decode_element(
                is_signed ? ElementKind::signed_integer : ElementKind::unsigned_integer, bits, element);
            for (unsigned to : {1u, 2u, 3u, 4u, 5u, 6u, 8u, 16u})
                ASSERT_LE(std::fabs(code_of(c, to) - meant(is_signed, bits, element) * all_ones(to)),
                          0.5 + 1e-6)
                    << bits << "->" << to << ' ' << element;
        }
    };
    for (unsigned bits : {8u, 16u})
        for (std::uint32_t element = 0; element <= all_ones(bits); ++element)
            check(bits, element);
    std::mt19937 random(2);
    for (int i = 0; i < 200000; ++i)
        check(32, static_cast<std::uint32_t>(random()));
}

/// A code that is written as an element of more bits and read again is the same code.
TEST(Component, CodesComeBackFromElements) {
    for (const ElementKind kind :
         {ElementKind::unsigned_integer, ElementKind::signed_integer, ElementKind::real})
        for (unsigned bits : {8u, 16u, 32u})
            for (unsigned from : {1u, 2u, 3u, 4u, 5u, 6u, 8u, 16u}) {
                const bool fits = kind == ElementKind::real
                                      ? bits == 32
                                      : bits >= from + (kind == ElementKind::signed_integer);
                for (std::uint32_t code = 0; fits && code <= all_ones(from); ++code) {
                    const Component c{code, static_cast<std::uint8_t>(from)};
                    ASSERT_EQ(code_of(decode_element(kind, bits, encode_element(kind, bits, c)), from), code)
                        << static_cast<int>(kind) << ' ' << bits << ' ' << from;
                }
            }
}

TEST(Component, ReturnedValuesAreThoseOfTable47) {
    // Tests the values of GL 1.3, table 2.6: 1/4 is 0x40000000 of 32 bits to within 2^-33.
    const Component zero{0, 8}, quarter{0x40000000, 32}, half{0x80000000, 32}, one{255, 8};
    const auto get = [](ElementKind kind, unsigned bits, Component c) {
        return encode_element(kind, bits, c);
    };
    constexpr ElementKind u = ElementKind::unsigned_integer, s = ElementKind::signed_integer;
    EXPECT_EQ(get(u, 8, zero), 0u);
    EXPECT_EQ(get(u, 8, quarter), 64u);
    EXPECT_EQ(get(u, 8, half), 128u);
    EXPECT_EQ(get(u, 8, one), 255u);
    EXPECT_EQ(get(s, 8, zero), 0u);
    EXPECT_EQ(get(s, 8, quarter), 31u);
    EXPECT_EQ(get(s, 8, half), 63u);
    EXPECT_EQ(get(s, 8, one), 127u);
    EXPECT_EQ(get(u, 16, quarter), 16384u);
    EXPECT_EQ(get(u, 16, half), 32768u);
    EXPECT_EQ(get(s, 32, quarter), 536870912u);
    EXPECT_EQ(get(s, 32, one), 2147483647u);
    EXPECT_EQ(get(u, 32, one), 0xFFFFFFFFu);
    EXPECT_EQ(get(ElementKind::real, 32, one), 0x3F800000u);
}

TEST(Component, SignedReturnsAreNearest) {
    for (unsigned from : {5u, 6u, 8u, 16u})
        for (unsigned bits : {8u, 16u, 32u})
            for (std::uint32_t code = 0; code <= all_ones(from); ++code) {
                const Component c{code, static_cast<std::uint8_t>(from)};
                const double exact = (value_of(c) * all_ones(bits) - 1) / 2;
                const std::uint32_t got = encode_element(ElementKind::signed_integer, bits, c);
                ASSERT_LE(std::fabs(got - exact), 0.5 + 1e-6) << from << " " << bits << " " << code;
                ASSERT_LE(got, all_ones(bits) / 2);
            }
}

TEST(Component, ElementsAtAnyAddressInBothOrders) {
    unsigned char bytes[8] = {0, 0x12, 0x34, 0x56, 0x78, 0, 0, 0};
    const bool little = std::endian::native == std::endian::little;
    EXPECT_EQ(load_element(bytes + 1, 1, true), 0x12u);
    EXPECT_EQ(load_element(bytes + 1, 2, little), 0x1234u);
    EXPECT_EQ(load_element(bytes + 1, 2, !little), 0x3412u);
    EXPECT_EQ(load_element(bytes + 1, 4, little), 0x12345678u);
    EXPECT_EQ(load_element(bytes + 1, 4, !little), 0x78563412u);
    unsigned char out[6] = {};
    store_element(out + 1, 4, little, 0x12345678);
    EXPECT_EQ(std::memcmp(out + 1, bytes + 1, 4), 0);
    store_element(out + 1, 2, !little, 0x1234);
    EXPECT_EQ(out[1], 0x34);
    EXPECT_EQ(out[2], 0x12);
    EXPECT_EQ(out[5], 0);
}

} // namespace
} // namespace spangle::gl

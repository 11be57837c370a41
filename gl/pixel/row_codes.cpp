#include "gl/pixel/row_codes.hpp"

#if SPANGLE_ROW_CODES

#include <cstring>

#include "raster/ops/lanes.hpp"

namespace spangle::gl {

namespace {

using L = raster::Lanes<8>;
using U16 = L::U16;
using Bytes [[gnu::vector_size(8)]] = std::uint8_t;
constexpr std::int32_t lanes = L::count;
static_assert(row_chunk % lanes == 0);

SPANGLE_INLINE U16 codes_at(const std::uint16_t* code) {
    return L::load(reinterpret_cast<const std::uint8_t*>(code));
}

/// Reads one field of `count` groups, a multiple of the lanes. load() returns a word for each of eight
/// groups, which holds the field at bit `shift`.
template <int GroupBytes, class Load>
void read_field(const std::uint8_t* from, std::int32_t count, unsigned shift, unsigned bits,
                const CodeScale& scale, std::uint16_t* out, Load load) {
    const auto down = static_cast<std::uint16_t>(shift);
    const U16 mask = L::splat((1u << bits) - 1), factor = L::splat(scale.factor), half = L::splat(scale.half);
    const std::uint16_t cut = scale.shift;
    for (std::int32_t i = 0; i < count; i += lanes, from += GroupBytes * lanes) {
        const U16 code = (load(from) >> down) & mask;
        L::scatter((code * factor + half) >> cut, out + i);
    }
}

/// Writes eight groups of three bytes. Each byte is one component.
void write_threes(std::uint8_t* to, const std::uint16_t* const (&byte)[4], std::int32_t at) {
#pragma GCC unroll 8
    for (std::int32_t i = 0; i < lanes; ++i) {
        to[3 * i] = static_cast<std::uint8_t>(byte[0][at + i]);
        to[3 * i + 1] = static_cast<std::uint8_t>(byte[1][at + i]);
        to[3 * i + 2] = static_cast<std::uint8_t>(byte[2][at + i]);
    }
}

void write_fours(std::uint8_t* to, const std::uint16_t* const (&byte)[4], std::int32_t at) {
    const U16 low = codes_at(byte[0] + at) | codes_at(byte[1] + at) << 8,
              high = codes_at(byte[2] + at) | codes_at(byte[3] + at) << 8;
    L::store(to, L::mixed_low(low, high));
    L::store(to + 16, L::mixed_high(low, high));
}

/// Writes groups whose fields are packed into words of at most 16 bits.
template <class Store>
void write_words(const CodeRow& from, const GroupFields& to, std::int32_t at, std::int32_t end, Store store) {
    // For a field that is missing, the bits of another field are ORed a second time, which changes nothing.
    const std::uint16_t* code[4];
    std::uint16_t up[4];
    unsigned there = 0;
    for (unsigned c = 0; c < 4; ++c)
        if (to.field[c].bits != 0)
            there = c;
    for (unsigned c = 0; c < 4; ++c) {
        const unsigned of = to.field[c].bits != 0 ? c : there;
        code[c] = from.code[of];
        up[c] = to.field[of].shift;
    }
    for (; at < end; at += lanes) {
        U16 word = codes_at(code[0] + at) << up[0];
        word |= codes_at(code[1] + at) << up[1];
        word |= codes_at(code[2] + at) << up[2];
        word |= codes_at(code[3] + at) << up[3];
        store(word);
    }
}

/// Writes groups of 1 to 4 bytes. In groups of 3 and 4 bytes each byte is one field.
void write_blocks(const CodeRow& from, const GroupFields& to, std::int32_t at, std::int32_t end,
                  std::uint8_t* out) {
    if (to.bytes == 1)
        return write_words(from, to, at, end, [&](U16 word) {
            const Bytes bytes = __builtin_convertvector(word, Bytes);
            std::memcpy(out, &bytes, sizeof bytes);
            out += lanes;
        });
    if (to.bytes == 2 && to.swapped)
        return write_words(from, to, at, end, [&](U16 word) {
            L::store(out, L::swap_bytes(word));
            out += 2 * lanes;
        });
    if (to.bytes == 2)
        return write_words(from, to, at, end, [&](U16 word) {
            L::store(out, word);
            out += 2 * lanes;
        });
    const std::uint16_t* byte[4] = {};
    for (unsigned c = 0; c < 4; ++c)
        if (to.field[c].bits != 0)
            byte[to.field[c].shift / 8 & 3] = from.code[c];
    for (; to.bytes == 3 && at < end; at += lanes, out += 3 * lanes)
        write_threes(out, byte, at);
    for (; at < end; at += lanes, out += 4 * lanes)
        write_fours(out, byte, at);
}

} // namespace

FieldReader::FieldReader(const GroupFields& from, const CodeBits& to) : source_fields_(from) {
    for (unsigned c = 0; c < 4; ++c) {
        if (from.field[c].bits == 0 || to.of[c] == 0)
            continue;
        const unsigned cut = to.cut ? 8u - to.of[c] : 0;
        scale_[c] = code_scales[from.field[c].bits][to.of[c] + cut];
        scale_[c].shift = static_cast<std::uint16_t>(scale_[c].shift + cut);
    }
}

void FieldReader::blocks(const std::uint8_t* from, std::int32_t count, CodeRow& out, std::int32_t at) const {
    for (unsigned c = 0; c < 4; ++c) {
        if (scale_[c].factor == 0)
            continue;
        const unsigned shift = source_fields_.field[c].shift, bits = source_fields_.field[c].bits;
        const auto each = [&]<int GroupBytes>(unsigned down, auto load) {
            read_field<GroupBytes>(from, count, down, bits, scale_[c], out.code[c] + at, load);
        };
        if (source_fields_.bytes == 1)
            each.template operator()<1>(shift, [](const std::uint8_t* p) {
                Bytes bytes;
                std::memcpy(&bytes, p, sizeof bytes);
                return __builtin_convertvector(bytes, U16);
            });
        else if (source_fields_.bytes == 2 && source_fields_.swapped)
            each.template operator()<2>(shift,
                                        [](const std::uint8_t* p) { return L::swap_bytes(L::load(p)); });
        else if (source_fields_.bytes == 2)
            each.template operator()<2>(shift, [](const std::uint8_t* p) { return L::load(p); });
        else if (source_fields_.bytes == 3)
            each.template operator()<3>(shift & 7, [byte = shift / 8](const std::uint8_t* first) {
                const std::uint8_t* const p = first + byte;
                return U16{p[0], p[3], p[6], p[9], p[12], p[15], p[18], p[21]};
            });
        else if (shift < 16)
            each.template operator()<4>(shift,
                                        [](const std::uint8_t* p) { return L::low_half(L::load32(p)); });
        else
            each.template operator()<4>(shift - 16,
                                        [](const std::uint8_t* p) { return L::high_half(L::load32(p)); });
    }
}

void FieldReader::read(const std::uint8_t* from, std::int32_t count, CodeRow& out) const {
    const std::int32_t whole = count & ~(lanes - 1), rest = count - whole;
    blocks(from, whole, out, 0);
    if (rest == 0)
        return;
    std::uint8_t last[4 * lanes] = {}; // a copy, so that nothing behind the last group is read
    std::memcpy(last, from + std::ptrdiff_t{whole} * source_fields_.bytes,
                static_cast<std::size_t>(rest * source_fields_.bytes));
    blocks(last, lanes, out, whole);
}

void write_fields(const CodeRow& from, const GroupFields& to, std::int32_t count, std::uint8_t* out) {
    const std::int32_t whole = count & ~(lanes - 1), rest = count - whole;
    write_blocks(from, to, 0, whole, out);
    if (rest == 0)
        return;
    std::uint8_t last[4 * lanes]; // a copy, so that nothing behind the last group is written
    write_blocks(from, to, whole, whole + lanes, last);
    std::memcpy(out + std::ptrdiff_t{whole} * to.bytes, last, static_cast<std::size_t>(rest * to.bytes));
}

void add_luminance(CodeRow& row) {
    for (std::int32_t i = 0; i < row_chunk; i += lanes) {
        const U16 sum = codes_at(row.code[0] + i) + codes_at(row.code[1] + i) + codes_at(row.code[2] + i);
        L::scatter(L::minimum(sum, L::splat(255)), row.code[0] + i);
    }
}

} // namespace spangle::gl

#endif

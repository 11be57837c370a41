#include "gl/texture/halve_row.hpp"

#if SPANGLE_ROW_CODES && SPANGLE_FEATURE_MIPMAP_GENERATION

#include "raster/ops/lanes.hpp"

namespace spangle::gl {

namespace {

using L = raster::Lanes<8>;
using U16 = L::U16;

const std::uint8_t* bytes_of(const std::uint16_t* code) {
    return reinterpret_cast<const std::uint8_t*>(code);
}

void add(std::uint16_t* sum, const std::uint16_t* code) {
    for (std::int32_t i = 0; i < row_chunk; i += L::count)
        L::scatter(L::load(bytes_of(sum + i)) + L::load(bytes_of(code + i)), sum + i);
}

/// Halves a row of column sums. The sum of two neighbours, multiplied by `times`, is the sum of eight texels.
void halve_sums(const std::uint16_t* sum, std::uint16_t times, std::uint16_t* out) {
    for (std::int32_t i = 0; i < row_chunk / 2; i += L::count) {
        const L::U32 pairs = L::load32(bytes_of(sum + 2 * i));
        const U16 all = (L::low_half(pairs) + L::high_half(pairs)) * times;
        L::scatter((all + 4) >> 3, out + i);
    }
}

} // namespace

void RowHalver::halve(const std::uint8_t* const (&from)[4], std::int32_t count, std::uint8_t* to) {
    const unsigned rows = from[2] != from[0] ? 4 : from[1] != from[0] ? 2 : 1;
    CodeRow sum{}, row{};
    for (std::int32_t done = 0; done < count; done += row_chunk / 2) {
        const std::int32_t n = count - done < row_chunk / 2 ? count - done : row_chunk / 2;
        const std::size_t first = std::size_t{2} * static_cast<std::uint32_t>(done) * fields_.bytes;
        for (unsigned r = 0; r < rows; ++r) {
            reader_.read(from[r] + first, 2 * n, r == 0 ? sum : row);
            for (unsigned c = 0; r != 0 && c < 4; ++c)
                if (fields_.field[c].bits != 0)
                    add(sum.code[c], row.code[c]);
        }
        for (unsigned c = 0; c < 4; ++c)
            if (fields_.field[c].bits != 0)
                halve_sums(sum.code[c], static_cast<std::uint16_t>(4 / rows), row.code[c]);
        write_fields(row, fields_, n, to + static_cast<std::uint32_t>(done) * std::size_t{fields_.bytes});
    }
}

} // namespace spangle::gl

#endif

#include "host_sim/bake/etc1.hpp"

#include <algorithm>
#include <array>
#include <climits>

namespace spangle::bake {

namespace {

using Color = std::array<int, 3>;

constexpr int tables = 8, candidates = 27;
/// The values that the two bits of a texel, most significant first, add to the base colour (table 3.17.2).
constexpr int steps[tables][4] = {{2, 8, -2, -8},       {5, 17, -5, -17},    {9, 29, -9, -29},
                                  {13, 42, -13, -42},   {18, 60, -18, -60},  {24, 80, -24, -80},
                                  {33, 106, -33, -106}, {47, 183, -47, -183}};

int add_clamped(int base, int step) {
    return std::clamp(base + step, 0, 255);
}

/// Whether texel (x, y) lies in the second half of a block. The halves lie side by side or, flipped, one
/// above the other.
bool in_second(bool flip, int x, int y) {
    return (flip ? y : x) >= 2;
}

struct Texels {
    Color color[16]; ///< texel x * 4 + y, in the order of their bits
};

/// Half a block around one base colour, with its best table and its error.
struct Half {
    Color code{}; ///< base colour, in 4 or 5 bits a component
    int table = 0;
    long error = LONG_MAX;
};

int expand_bits(int code, int bits) {
    return bits == 4 ? code * 17 : code << 3 | code >> 2;
}

/// The step of a table that comes nearest to the texel.
int best_step(const Color& base, const Color& texel, int table, long& error) {
    int best = 0;
    error = LONG_MAX;
    for (int s = 0; s < 4; ++s) {
        long sum = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const long d = add_clamped(base[c], steps[table][s]) - texel[c];
            sum += d * d;
        }
        if (sum < error) {
            error = sum;
            best = s;
        }
    }
    return best;
}

Half fit_half(const Texels& texels, bool flip, bool second, const Color& code, int bits) {
    Half half;
    half.code = code;
    Color base{};
    for (std::size_t c = 0; c < 3; ++c)
        base[c] = expand_bits(code[c], bits);
    for (int table = 0; table < tables; ++table) {
        long sum = 0, one = 0;
        for (int i = 0; i < 16 && sum < half.error; ++i)
            if (in_second(flip, i >> 2, i & 3) == second) {
                best_step(base, texels.color[i], table, one);
                sum += one;
            }
        if (sum < half.error) {
            half.error = sum;
            half.table = table;
        }
    }
    return half;
}

/// Fits half a block with base colours around its mean.
std::array<Half, candidates> fit_candidates(const Texels& texels, bool flip, bool second, int bits) {
    const int most = (1 << bits) - 1;
    Color sum{};
    for (int i = 0; i < 16; ++i)
        if (in_second(flip, i >> 2, i & 3) == second)
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += texels.color[i][c];
    std::array<Half, candidates> out;
    for (int n = 0; n < candidates; ++n) {
        const int offset[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
        Color code{};
        for (std::size_t c = 0; c < 3; ++c)
            code[c] = std::clamp((sum[c] * most + 8 * 255 / 2) / (8 * 255) + offset[c], 0, most);
        out[static_cast<std::size_t>(n)] = fit_half(texels, flip, second, code, bits);
    }
    return out;
}

struct Block {
    bool flip = false, differential = false;
    Half half[2];
    long error = LONG_MAX;
};

/// Whether the difference of two base codes can be stored: per component, the second is at most three above
/// and four below the first.
bool is_near(const Color& a, const Color& b) {
    for (std::size_t c = 0; c < 3; ++c)
        if (b[c] - a[c] < -4 || b[c] - a[c] > 3)
            return false;
    return true;
}

void try_pairs(const Texels& texels, bool flip, bool differential, Block& best) {
    const int bits = differential ? 5 : 4;
    const auto first = fit_candidates(texels, flip, false, bits),
               second = fit_candidates(texels, flip, true, bits);
    for (const Half& a : first)
        for (const Half& b : second)
            if (a.error + b.error < best.error && (!differential || is_near(a.code, b.code)))
                best = {flip, differential, {a, b}, a.error + b.error};
}

void write(const Block& block, const Texels& texels, std::uint8_t* to) {
    for (std::size_t c = 0; c < 3; ++c) {
        const int a = block.half[0].code[c], b = block.half[1].code[c];
        to[c] = static_cast<std::uint8_t>(block.differential ? a << 3 | ((b - a) & 7) : a << 4 | b);
    }
    to[3] = static_cast<std::uint8_t>(block.half[0].table << 5 | block.half[1].table << 2 |
                                      (block.differential ? 2 : 0) | (block.flip ? 1 : 0));
    unsigned high = 0, low = 0;
    for (int i = 0; i < 16; ++i) {
        const Half& half = block.half[in_second(block.flip, i >> 2, i & 3) ? 1 : 0];
        Color base{};
        for (std::size_t c = 0; c < 3; ++c)
            base[c] = expand_bits(half.code[c], block.differential ? 5 : 4);
        long error = 0;
        const auto step = static_cast<unsigned>(best_step(base, texels.color[i], half.table, error));
        high |= (step >> 1) << i;
        low |= (step & 1) << i;
    }
    to[4] = static_cast<std::uint8_t>(high >> 8);
    to[5] = static_cast<std::uint8_t>(high);
    to[6] = static_cast<std::uint8_t>(low >> 8);
    to[7] = static_cast<std::uint8_t>(low);
}

void decode_block(const std::uint8_t* from, Color (&texel)[16]) {
    const bool flip = (from[3] & 1) != 0, differential = (from[3] & 2) != 0;
    const unsigned high = static_cast<unsigned>(from[4] << 8 | from[5]),
                   low = static_cast<unsigned>(from[6] << 8 | from[7]);
    for (unsigned i = 0; i < 16; ++i) {
        const bool second = in_second(flip, static_cast<int>(i >> 2), static_cast<int>(i & 3));
        const int table = from[3] >> (second ? 2 : 5) & 7;
        const int step = steps[table][(high >> i & 1) * 2 + (low >> i & 1)];
        for (std::size_t c = 0; c < 3; ++c) {
            const int byte = from[c], delta = (byte & 7) >= 4 ? (byte & 7) - 8 : byte & 7;
            const int code =
                !differential ? (second ? byte & 15 : byte >> 4) : (byte >> 3) + (second ? delta : 0);
            texel[i][c] = add_clamped(expand_bits(code, differential ? 5 : 4), step);
        }
    }
}

} // namespace

std::vector<std::uint8_t> encode_etc1(const std::vector<std::uint8_t>& rgba, int width, int height) {
    std::vector<std::uint8_t> out;
    for (int top = 0; top < height; top += 4)
        for (int left = 0; left < width; left += 4) {
            Texels texels{};
            for (int i = 0; i < 16; ++i) {
                const int x = std::min(left + (i >> 2), width - 1), y = std::min(top + (i & 3), height - 1);
                for (std::size_t c = 0; c < 3; ++c)
                    texels.color[i][c] = rgba[static_cast<std::size_t>(y * width + x) * 4 + c];
            }
            Block best;
            for (const bool flip : {false, true})
                for (const bool differential : {true, false})
                    try_pairs(texels, flip, differential, best);
            out.resize(out.size() + 8);
            write(best, texels, out.data() + out.size() - 8);
        }
    return out;
}

std::vector<std::uint8_t> decode_etc1(const std::vector<std::uint8_t>& blocks, int width, int height) {
    std::vector<std::uint8_t> out(static_cast<std::size_t>(width * height) * 4, 255);
    const int across = (width + 3) / 4;
    for (int top = 0; top < height; top += 4)
        for (int left = 0; left < width; left += 4) {
            Color texel[16];
            decode_block(blocks.data() + static_cast<std::size_t>(top / 4 * across + left / 4) * 8, texel);
            for (int i = 0; i < 16; ++i) {
                const int x = left + (i >> 2), y = top + (i & 3);
                if (x < width && y < height)
                    for (std::size_t c = 0; c < 3; ++c)
                        out[static_cast<std::size_t>(y * width + x) * 4 + c] =
                            static_cast<std::uint8_t>(texel[i][c]);
            }
        }
    return out;
}

} // namespace spangle::bake

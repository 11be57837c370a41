#include <spangle/hal/row_hash.hpp>

#include <bit>
#include <initializer_list>

namespace spangle::hal {
namespace {

constexpr std::int32_t most_characters = 32;

/// Keys of both hashes. The last key is the initial value of the sum.
struct Keys {
    std::uint32_t first[most_characters + 1], second[most_characters + 1];
};

/// Makes keys from the upper halves of SplitMix64 (Steele, Lea, Flood 2014).
constexpr Keys make_keys() {
    Keys keys{};
    std::uint64_t state = 0x5370616E676C6531; // the letters "Spangle1"
    const auto next = [&state] {
        std::uint64_t z = state += 0x9E3779B97F4A7C15;
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9;
        z = (z ^ z >> 27) * 0x94D049BB133111EB;
        return static_cast<std::uint32_t>((z ^ z >> 31) >> 32);
    };
    for (std::uint32_t* key : {keys.first, keys.second})
        for (std::int32_t i = 0; i <= most_characters; ++i)
            key[i] = next();
    return keys;
}

constexpr Keys keys = make_keys();

RowSpan intersect(RowSpan a, RowSpan b) {
    const RowSpan both = {a.begin > b.begin ? a.begin : b.begin, a.end < b.end ? a.end : b.end};
    return both.begin < both.end ? both : RowSpan{};
}

} // namespace

std::uint32_t RowHash::hash(const std::uint8_t* bytes, std::int32_t count) {
    std::uint32_t first = keys.first[most_characters], second = keys.second[most_characters];
    std::int32_t i = 0;
    for (; 2 * i + 1 < count; ++i) {
        const std::uint32_t character = bytes[2 * i] | static_cast<std::uint32_t>(bytes[2 * i + 1]) << 8;
        first += keys.first[i] * character;
        second += keys.second[i] * character;
    }
    if (2 * i < count) {
        first += keys.first[i] * bytes[2 * i];
        second += keys.second[i] * bytes[2 * i];
    }
    return (first & 0xFFFF0000u) | second >> 16;
}

std::uint32_t RowHash::changed_cells(RowSpan damage, std::int32_t y, const std::uint8_t* row, bool all) {
    const std::int32_t cells = cells_of(width_), bytes = cell_width / 8 * bits_;
    std::uint32_t* const known = memory_->hashes + static_cast<std::ptrdiff_t>(y) * cells;
    std::uint32_t changed = 0;
    for (std::int32_t cell = damage.begin / cell_width; cell * cell_width < damage.end; ++cell) {
        const std::int32_t rest = ((width_ - cell * cell_width) * bits_ + 7) / 8;
        const std::uint32_t now = hash(row + cell * bytes, rest < bytes ? rest : bytes);
        if (all || now != known[cell])
            changed |= 1u << cell;
        known[cell] = now;
    }
    return changed;
}

/// The columns from the first to the last of the cells, whose bits are set.
RowSpan RowHash::columns_of(std::uint32_t cells) const {
    if (cells == 0)
        return {};
    const std::int32_t end = cell_width * (32 - std::countl_zero(cells));
    return {static_cast<std::int16_t>(cell_width * std::countr_zero(cells)),
            static_cast<std::int16_t>(end < width_ ? end : width_)};
}

void RowHash::reduce(RowSpan* damage, const std::uint8_t* pixels, std::int32_t stride, bool all) {
    bool any = false;
    for (std::int32_t y = 0; y < height_; ++y) {
        const std::uint8_t* const row = pixels + static_cast<std::ptrdiff_t>(y) * stride;
        const std::uint32_t cells =
            damage[y].begin < damage[y].end ? changed_cells(damage[y], y, row, all) : 0;
        memory_->changed[y] = cells;
        damage[y] = intersect(damage[y], columns_of(cells));
        any = any || cells != 0;
    }
    if (any)
        refresh_one(damage, pixels, stride);
}

void RowHash::refresh_one(RowSpan* damage, const std::uint8_t* pixels, std::int32_t stride) {
    if (++refresh_cell_ >= cells_of(width_)) {
        refresh_cell_ = 0;
        refresh_row_ = refresh_row_ + 1 < height_ ? refresh_row_ + 1 : 0;
    }
    const std::int32_t y = refresh_row_;
    const RowSpan columns = columns_of(1u << refresh_cell_);
    memory_->changed[y] |= changed_cells(columns, y, pixels + static_cast<std::ptrdiff_t>(y) * stride, true);
    RowSpan& row = damage[y];
    row = {row.begin < columns.begin ? row.begin : columns.begin,
           row.end > columns.end ? row.end : columns.end};
}

} // namespace spangle::hal

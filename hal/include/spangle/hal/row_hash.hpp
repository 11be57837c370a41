// The row hash: for each cell of 16 x 1 pixels a hash of what the panel's memory holds. A cell that is drawn
// again with the same pixels is not sent again.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>

namespace spangle::hal {

class RowHash;
class SpanPlan;
struct WindowCost;

/// A window while its cells are gathered.
struct SpanWindow {
    std::int16_t begin = 0, end = 0, top = 0, bottom = 0; ///< half-open
    std::int32_t spare = 0;                               ///< bits saved and not yet wasted
};

/// Code that only displays with a row hash link, because only the memory of a row hash names it.
struct RowHashCode {
    void (*reduce)(RowHash&, RowSpan* damage, const std::uint8_t* pixels, std::int32_t stride, bool all);
    void (*plan)(SpanPlan&, const RowHash&, const WindowCost&);
    bool (*next)(SpanPlan&, Rect& window);
};
extern const RowHashCode row_hash_code;

/// The memory of a row hash, handed over by its owner: four bytes a cell, four a row, and windows. Null:
/// none.
struct RowHashMemory {
    static constexpr std::int32_t window_count = 64;

    std::uint32_t* hashes = nullptr; ///< height * cells_of(width)
    std::uint32_t* changed = nullptr;
    SpanWindow* windows = nullptr;
    std::int32_t cells = 0;
    const RowHashCode* code = nullptr;
};

class RowHash {
  public:
    static constexpr std::int32_t cell_width = 16;
    static constexpr std::int32_t widest = 32 * cell_width; ///< a row's cells are the bits of one word
    static constexpr std::int32_t cells_of(std::int32_t width) {
        return (width + cell_width - 1) / cell_width;
    }

    RowHash() = default;
    RowHash(const RowHashMemory& memory, std::int32_t width, std::int32_t height, std::int32_t bits)
        : memory_(memory), width_(width), height_(height), bits_(bits) {}

    bool enabled() const { return memory_.code != nullptr; }
    const RowHashMemory& memory() const { return memory_; }
    std::int32_t width() const { return width_; }
    std::int32_t height() const { return height_; }
    /// After reduce(): bits of the cells that changed, by row.
    const std::uint32_t* changed() const { return memory_.changed; }

    /// Cuts `damage`, row by row, to the cells whose hash differs from the panel's; `all`: the panel's hashes
    /// are unknown. From then on the panel is expected to hold what `pixels` holds. Each frame that sends
    /// anything also sends one further cell, all in turn: a cell that was wrongly taken for unchanged does
    /// not stay for ever.
    void reduce(RowSpan* damage, const std::uint8_t* pixels, std::int32_t stride, bool all);

    /// Hash of `count` bytes of a cell, at most 64.
    ///
    /// Two multilinear hashes of 16-bit characters in 32-bit arithmetic, sum of key[i] * c[i], of which the
    /// upper halves are kept (Lemire and Kaser, "Strongly universal string hashing is fast", 2014): over the
    /// choice of keys two different cells collide with a probability of 2^-16 each, 2^-32 together, whatever
    /// their pixels. The keys are constants, chosen before any picture was.
    static std::uint32_t hash(const std::uint8_t* bytes, std::int32_t count);

  private:
    std::uint32_t changed_cells(RowSpan damage, std::int32_t y, const std::uint8_t* row, bool all);
    void refresh_one(RowSpan* damage, const std::uint8_t* pixels, std::int32_t stride);
    RowSpan columns_of(std::uint32_t cells) const;

    RowHashMemory memory_;
    std::int32_t width_ = 0, height_ = 0, bits_ = 0;
    std::int32_t refresh_row_ = 0, refresh_cell_ = 0;
};

/// The memory of a row hash for pictures up to this size; nothing for a width of 0.
template <std::int32_t Height, std::int32_t Width> struct RowHashStorage {
    static_assert(Width <= RowHash::widest, "the row hash serves pictures up to 512 columns");
    static constexpr std::int32_t cells = RowHash::cells_of(Width);

    std::uint32_t hashes[Height * cells], changed[Height];
    SpanWindow windows[RowHashMemory::window_count];

    RowHashMemory memory() { return {hashes, changed, windows, Height * cells, &row_hash_code}; }
};
template <std::int32_t Height> struct RowHashStorage<Height, 0> {
    RowHashMemory memory() { return {}; }
};

} // namespace spangle::hal

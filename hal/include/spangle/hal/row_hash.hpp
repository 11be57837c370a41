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
    /// Columns [begin, end) and rows [top, bottom) of the picture.
    std::int16_t begin = 0, end = 0, top = 0, bottom = 0;
    std::int32_t spare = 0; ///< bits that the window may still spend on unchanged cells
};

/// Code that only displays with a [row hash](docs/glossary.md#row-hash) link, because only the memory of a
/// row hash names it.
struct RowHashCode {
    /// The function RowHash::reduce().
    void (*reduce)(RowHash&, RowSpan* damage, const std::uint8_t* pixels, std::int32_t stride, bool all);
    /// Begins a plan of the windows of a frame.
    void (*plan)(SpanPlan&, const RowHash&, const WindowCost&);
    /// Takes the next window of a plan; false: there is none.
    bool (*next)(SpanPlan&, Rect& window);
};
/// The only RowHashCode that there is.
extern const RowHashCode row_hash_code;

/// The memory of a row hash, handed over by its owner: four bytes a cell, four a row, and windows. Null:
/// none.
struct RowHashMemory {
    /// Windows that are open at the same time while a frame is planned.
    static constexpr std::int32_t window_count = 64;

    std::uint32_t* hashes = nullptr; ///< a hash for each cell: height * cells_of(width)
    /// One word a row: bits of the cells that changed.
    std::uint32_t* changed = nullptr;
    /// Memory for `window_count` windows.
    SpanWindow* windows = nullptr;
    /// The number of elements of `hashes`.
    std::int32_t cells = 0;
    /// The functions that work on this memory.
    const RowHashCode* code = nullptr;
};

/// Remembers a hash for each cell of what the panel's memory holds.
class RowHash {
  public:
    /// The number of pixels of a cell.
    static constexpr std::int32_t cell_width = 16;
    static constexpr std::int32_t widest = 32 * cell_width; ///< a row's cells are the bits of one word
    /// Cells of a row of so many pixels, the last one cut where the row ends.
    static constexpr std::int32_t cells_of(std::int32_t width) {
        return (width + cell_width - 1) / cell_width;
    }

    /// A row hash without memory, for which enabled() is false.
    RowHash() = default;
    /// A row hash for pictures of this size in pixels, of `bits` bits a pixel. `memory` must outlive it.
    RowHash(const RowHashMemory& memory, std::int32_t width, std::int32_t height, std::int32_t bits)
        : memory_(&memory), width_(static_cast<std::int16_t>(width)),
          height_(static_cast<std::int16_t>(height)), bits_(static_cast<std::int16_t>(bits)) {}
    /// A temporary RowHashMemory would end before the row hash.
    RowHash(RowHashMemory&&, std::int32_t, std::int32_t, std::int32_t) = delete;

    /// Whether the row hash has memory.
    bool enabled() const { return memory_ != nullptr && memory_->code != nullptr; }
    /// The memory that the constructor was given.
    const RowHashMemory& memory() const { return *memory_; }
    /// The picture's width in pixels.
    std::int32_t width() const { return width_; }
    /// The picture's height in pixels.
    std::int32_t height() const { return height_; }
    /// After reduce(): bits of the cells that changed, by row.
    const std::uint32_t* changed() const { return memory_->changed; }

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

    const RowHashMemory* memory_ = nullptr;
    std::int16_t width_ = 0, height_ = 0, bits_ = 0, refresh_cell_ = 0;
    std::int32_t refresh_row_ = 0;
};

/// The memory of a row hash for pictures up to this size; nothing for a width of 0.
template <std::int32_t Height, std::int32_t Width> struct RowHashStorage {
    static_assert(Width <= RowHash::widest, "the row hash serves pictures up to 512 columns");
    /// The number of cells in a row of pixels.
    static constexpr std::int32_t cells = RowHash::cells_of(Width);

    /// The hashes, and the bits of changed cells.
    std::uint32_t hashes[Height * cells], changed[Height];
    /// Windows while they are planned.
    SpanWindow windows[RowHashMemory::window_count];

    /// The memory as PanelMemory::hash takes it.
    RowHashMemory memory() { return {hashes, changed, windows, Height * cells, &row_hash_code}; }
};
/// The storage of displays without a row hash.
template <std::int32_t Height> struct RowHashStorage<Height, 0> {
    /// Null pointers, with which the row hash is off.
    RowHashMemory memory() { return {}; }
};

} // namespace spangle::hal

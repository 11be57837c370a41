// The memory in which a panel display keeps its books, which its owner provides.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/hal/op_list.hpp>
#include <spangle/hal/palette.hpp>
#include <spangle/hal/row_hash.hpp>
#include <spangle/hal/scan_order.hpp>

namespace spangle::hal {

/// The memory of a PanelDisplay's bookkeeping, handed over by its owner. All arrays of rows except `content`
/// have `height` elements.
struct PanelMemory {
    /// Touched columns of the frame being drawn.
    RowSpan* touched = nullptr;
    /// Columns in which the panel's memory differs from the frame.
    RowSpan* damage = nullptr;
    /// What each buffer holds, in the form of PanelContent::rows.
    RowSpan* content[2] = {};
    std::int32_t content_height = 0; ///< rows of `content`, as the picture has; 0: bands are sent whole
    /// Memory in which windows are planned.
    std::uint16_t* plan = nullptr;
    /// The number of elements of the arrays of rows.
    std::int32_t height = 0;
    /// Buffers whose content is recorded: 1 or 2.
    std::uint8_t buffers = 0;
    /// Memory for the operations of one list.
    Op* ops = nullptr;
    /// Memory for the parameters of one list.
    OpParams* params = nullptr;
    /// The number of elements of `ops` and of `params`.
    std::size_t op_count = 0;
    /// The memory of the [row hash](docs/glossary.md#row-hash), or none.
    RowHashMemory hash = {};
    RowSpan* turned = nullptr; ///< damage by rows of the turned buffer (PanelConfig::scan_order)
    /// The function turn(). A display that does not turn pictures never names it, and so does not link it.
    decltype(&turn) turner = nullptr;
    RowSpan* held = nullptr;    ///< rows of a frame that was put off (Pacing::coalesce); null: it is dropped
    Palette* palette = nullptr; ///< the palette of surfaces of PixelFormat::index8
};

/// How much memory a PanelStorage has.
struct PanelSizes {
    /// The most rows of a picture and of a sent buffer, or of [bands](docs/glossary.md#band).
    std::int32_t height = 0;
    /// The most buffers: 1 or 2.
    std::uint8_t buffers = 1;
    /// Operations of a list. A longer list goes out in several transfers; frames that are tear-free or sent
    /// while the next is drawn are made of as few windows as one list holds.
    std::size_t ops = 64;
    std::int32_t hashed_width = 0; ///< columns of the row hash; 0: there is none
    bool turned = false;           ///< there is memory for PanelConfig::scan_order
    bool held = false;             ///< there is memory for Pacing::coalesce
    /// Rows of the picture, where `height` is that of bands; 0: what the panel shows is not recorded, and
    /// bands are sent whole; -1: as many as `height`.
    std::int32_t content = -1;
    bool indexed = false; ///< there is a palette, for PixelFormat::index8

    /// Rows of the picture.
    constexpr std::int32_t content_height() const { return content < 0 ? height : content; }
};

/// The memory of a PanelDisplay.
template <PanelSizes sizes> struct PanelStorage {
    static_assert(sizes.height > 0 && sizes.height <= 4096 && (sizes.buffers == 1 || sizes.buffers == 2) &&
                  sizes.ops >= 8);
    /// The number of elements of arrays that some displays do not need.
    static constexpr std::int32_t content_rows = sizes.content_height() != 0 ? sizes.content_height() : 1,
                                  turned_rows = sizes.turned ? sizes.height : 1,
                                  held_rows = sizes.held ? sizes.height : 1;

    /// The memory that the members of PanelMemory by these names point to.
    RowSpan touched[sizes.height], damage[sizes.height], content[sizes.buffers][content_rows],
        turned[turned_rows], held[held_rows];
    /// The memory of PanelMemory::plan.
    std::uint16_t plan[sizes.height];
    /// The memory of PanelMemory::ops.
    Op ops[sizes.ops];
    /// The memory of PanelMemory::params.
    OpParams params[sizes.ops];
    /// The memory of PanelMemory::hash.
    RowHashStorage<sizes.height, sizes.hashed_width> hash;
    /// The memory of PanelMemory::palette.
    PaletteStorage<sizes.indexed> palette;

    /// The memory, as the constructor of a PanelDisplay takes it. The storage must outlive the display.
    PanelMemory memory() {
        return {touched,
                damage,
                {content[0], content[sizes.buffers - 1]},
                sizes.content_height(),
                plan,
                sizes.height,
                sizes.buffers,
                ops,
                params,
                sizes.ops,
                hash.memory(),
                sizes.turned ? turned : nullptr,
                sizes.turned ? &turn : nullptr,
                sizes.held ? held : nullptr,
                palette.memory()};
    }
};

} // namespace spangle::hal

// The memory in which a panel display keeps its books, which its owner provides.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/hal/op_list.hpp>
#include <spangle/hal/palette.hpp>
#include <spangle/hal/row_hash.hpp>
#include <spangle/hal/scan_order.hpp>

namespace spangle::hal {

/// The memory of a PanelDisplay's bookkeeping, handed over by its owner. All rows but those of the content
/// have `height` elements.
struct PanelMemory {
    /// Touched columns of the frame being drawn.
    RowSpan* touched = nullptr;
    /// Columns in which the panel's memory differs from the frame.
    RowSpan* damage = nullptr;
    /// What each buffer holds, as PanelContent::rows.
    RowSpan* content[2] = {};
    std::int32_t content_height = 0; ///< rows of the picture; 0 for bands that are sent whole
    /// Memory in which windows are planned.
    std::uint16_t* plan = nullptr;
    /// Elements of each of these rows.
    std::int32_t height = 0;
    /// Buffers whose content is recorded: 1 or 2.
    std::uint8_t buffers = 0;
    /// Memory of one list.
    Op* ops = nullptr;
    /// Parameters of that list.
    OpParams* params = nullptr;
    /// Elements of `ops` and of `params`.
    std::size_t op_count = 0;
    /// The memory of the [row hash](docs/glossary.md#row-hash), or none.
    RowHashMemory hash = {};
    RowSpan* turned = nullptr;        ///< for PanelConfig::scan_order
    decltype(&turn) turner = nullptr; ///< turn(), which is linked only where it is named
    RowSpan* held = nullptr;          ///< for Pacing::coalesce; without it frames are dropped
    Palette* palette = nullptr;       ///< for PixelFormat::index8
};

/// The memory of a PanelDisplay for pictures and sent buffers up to `Height` rows, and `HashedWidth` columns
/// if they are to be hashed. A list longer than `Ops` goes out in several transfers; frames that are
/// tear-free or sent while the next is drawn are made of as few windows as one list holds. `Content`: rows of
/// the picture, where `Height` is that of bands; 0: what the panel shows is not recorded, and bands are sent
/// whole.
template <std::int32_t Height, std::uint8_t Buffers = 1, std::size_t Ops = 64, std::int32_t HashedWidth = 0,
          bool Turned = false, bool Held = false, std::int32_t Content = Height, bool Indexed = false>
struct PanelStorage {
    static_assert(Height > 0 && Height <= 4096 && (Buffers == 1 || Buffers == 2) && Ops >= 8);

    /// The memory that the members of PanelMemory by these names point to.
    RowSpan touched[Height], damage[Height], content[Buffers][Content != 0 ? Content : 1],
        turned[Turned ? Height : 1], held[Held ? Height : 1];
    /// The memory of PanelMemory::plan.
    std::uint16_t plan[Height];
    /// The memory of PanelMemory::ops.
    Op ops[Ops];
    /// The memory of PanelMemory::params.
    OpParams params[Ops];
    /// The memory of PanelMemory::hash.
    RowHashStorage<Height, HashedWidth> hash;
    /// The memory of PanelMemory::palette.
    PaletteStorage<Indexed> palette;

    /// This memory, for the constructor of a PanelDisplay. The storage must outlive the display.
    PanelMemory memory() {
        return {touched,
                damage,
                {content[0], content[Buffers - 1]},
                Content,
                plan,
                Height,
                Buffers,
                ops,
                params,
                Ops,
                hash.memory(),
                Turned ? turned : nullptr,
                Turned ? &turn : nullptr,
                Held ? held : nullptr,
                palette.memory()};
    }
};

} // namespace spangle::hal

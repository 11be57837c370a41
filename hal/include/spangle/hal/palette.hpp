// The palette of a display whose surface holds colour indices (PixelFormat::index8).
#pragma once

#include <cstdint>

#include <spangle/format.hpp>

namespace spangle::hal {

/// The number of indices of a palette.
inline constexpr std::int32_t palette_size = 256;

/// Whether a palette has the `count` indices from `first` on.
constexpr bool in_palette(std::int32_t first, std::int32_t count) {
    return first >= 0 && count >= 0 && first <= palette_size && count <= palette_size - first;
}

/// A colour of 8 bits a component.
struct Rgb {
    /// Red, green and blue.
    std::uint8_t c[3];
};
/// The colour of an index before it is set: the index read as RRRGGGBB, k / 7, k / 7 and k / 3. A surface of
/// rgb332 looks right through it.
constexpr Rgb initial_color(std::int32_t index) {
    const auto scaled = [index](int shift, int most) {
        return static_cast<std::uint8_t>(((index >> shift & most) * 255 + most / 2) / most);
    };
    return {{scaled(5, 7), scaled(2, 7), scaled(0, 3)}};
}

/// The palette for a panel that has none itself: presents look colours up in it.
struct Palette {
    std::uint8_t color[palette_size][4];    ///< red, green, blue and an unused byte
    std::uint32_t stale[palette_size / 32]; ///< indices whose colours the panel does not show yet
    /// Whether the panel shows another colour for this index than `color` says.
    bool is_stale(std::uint8_t index) const { return (stale[index / 32] >> index % 32 & 1) != 0; }
    /// Whether is_stale() holds for any index.
    bool any_stale() const {
        std::uint32_t any = 0;
        for (const std::uint32_t word : stale)
            any |= word;
        return any != 0;
    }
    /// Says that the panel shows all colours.
    void all_fresh() {
        for (std::uint32_t& word : stale)
            word = 0;
    }
    /// Sets the initial colours. None of them is stale: a panel that was just initialised is black, and shows
    /// no index.
    void begin();
    /// Sets `count` colours from `first` on, for which in_palette() must hold. `rgb` has red, green and blue
    /// bytes of each colour.
    void set(std::int32_t first, std::int32_t count, const std::uint8_t* rgb);
};

/// The memory of a Palette, or none.
template <bool Exists> struct PaletteStorage {
    /// Null, because this storage has no palette.
    Palette* memory() { return nullptr; }
};
/// The memory of a Palette.
template <> struct PaletteStorage<true> {
    /// The palette that memory() points to.
    Palette palette;
    /// A pointer to the palette, for PanelMemory::palette.
    Palette* memory() { return &palette; }
};

} // namespace spangle::hal

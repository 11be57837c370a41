// Orientation as algebra: which MADCTL shows a picture turned or mirrored, its size, and where its window
// begins.
#pragma once

#include <cstdint>

#include <spangle/hal/panel.hpp>

namespace spangle::hal {

/// The value of a register that follows from orientation, colour order, inversion and format.
constexpr std::uint8_t value_of(const Setting& s, std::uint8_t madctl, const PanelDesc& panel,
                                FormatCode format) {
    unsigned value = s.base;
    value ^= (madctl & dcs::MX) != 0 ? s.mx : 0u;
    value ^= (madctl & dcs::MY) != 0 ? s.my : 0u;
    value ^= (madctl & dcs::MV) != 0 ? s.mv : 0u;
    value ^= panel.order == ColorOrder::bgr ? s.bgr : 0u;
    value ^= panel.inverted ? s.inverted : 0u;
    return static_cast<std::uint8_t>(value | (s.format ? format.code : 0u));
}

/// The picture is turned clockwise on the [glass](docs/glossary.md#glass).
enum class Rotation : std::uint8_t { r0, r90, r180, r270 };

/// How a picture is turned and mirrored on the glass. The buffer to draw into is always upright.
struct Orientation {
    /// How far the picture is turned, after mirroring.
    Rotation rotation = Rotation::r0;
    bool mirrored = false; ///< left and right are exchanged, before the picture is turned
    friend constexpr bool operator==(const Orientation&, const Orientation&) = default;
};

/// All eight orientations, for tables and tests.
inline constexpr Orientation orientations[] = {
    {Rotation::r0, false}, {Rotation::r90, false}, {Rotation::r180, false}, {Rotation::r270, false},
    {Rotation::r0, true},  {Rotation::r90, true},  {Rotation::r180, true},  {Rotation::r270, true}};

/// How a picture lies in the controller's memory: pixel (x, y) has the host address (x + offset.x, y +
/// offset.y).
struct Placement {
    std::uint8_t madctl = 0; ///< MADCTL's bits for the orientation, so without BGR
    /// The picture's size: width and height are exchanged where it is turned by 90 or 270 degrees.
    Extent size;
    /// The host address of pixel (0, 0).
    Offset offset;
};

/// The bits MV, MX and MY of MADCTL for an orientation on a panel. Turning by 90 degrees exchanges the axes
/// (MV), then mirrors the column axis (MX). Mirroring the picture's x mirrors the memory axis along which x
/// runs. The bits of `mount` (PanelDesc::mount) are exchanged last, because they belong to the memory's own
/// axes.
constexpr std::uint8_t address_order(std::uint8_t mount, Orientation o) {
    constexpr std::uint8_t turned[] = {0, dcs::MV | dcs::MX, dcs::MX | dcs::MY, dcs::MV | dcs::MY};
    unsigned order = turned[static_cast<unsigned>(o.rotation) & 3u];
    if (o.mirrored)
        order ^= (order & dcs::MV) != 0 ? dcs::MY : dcs::MX;
    return static_cast<std::uint8_t>(order ^ mount);
}

/// Computes where a picture lies in memory. Along a mirrored memory axis the window begins at memory - (glass
/// + offset). Along an axis that is not mirrored, or where only the scan is turned round, it begins at
/// offset. MV exchanges the axes.
constexpr Placement place(const PanelDesc& p, Orientation o) {
    const std::uint8_t order = address_order(p.mount, o);
    const int column = (order & dcs::MX) != 0 ? p.memory.width - (p.glass.width + p.offset.x) : p.offset.x;
    const bool rows_turned = (order & dcs::MY) != 0 && !p.commands->mirrors_rows_on_glass;
    const int row = rows_turned ? p.memory.height - (p.glass.height + p.offset.y) : p.offset.y;
    const auto c = static_cast<std::int16_t>(column), r = static_cast<std::int16_t>(row);
    if ((order & dcs::MV) != 0)
        return {order, {p.glass.height, p.glass.width}, {r, c}};
    return {order, p.glass, {c, r}};
}

} // namespace spangle::hal

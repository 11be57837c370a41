#include "host_sim/bringup/wrong.hpp"

namespace spangle::bringup {
namespace {

using hal::dcs::MX;
using hal::dcs::MY;

constexpr Wrong table[] = {
    {"order", "`order`: the other of `ColorOrder::rgb` and `ColorOrder::bgr`",
     [](Guess& g) {
         g.panel.order = g.panel.order == hal::ColorOrder::rgb ? hal::ColorOrder::bgr : hal::ColorOrder::rgb;
     }},
    {"inversion", "`inverted`: the other value; IPS glass wants `true`",
     [](Guess& g) { g.panel.inverted = !g.panel.inverted; }},
    {"mirrored", "`mount`: exchange `dcs::MX`", [](Guess& g) { g.panel.mount ^= MX; }},
    {"upside-down", "`mount`: exchange `dcs::MX | dcs::MY`, or turn by `Rotation::r180`",
     [](Guess& g) { g.panel.mount ^= MX | MY; }},
    {"turned", "`orientation`: `Rotation::r90` or `r270`; the picture's size changes with it",
     [](Guess& g) {
         g.orientation.rotation =
             static_cast<hal::Rotation>((static_cast<unsigned>(g.orientation.rotation) + 1) % 4);
     }},
    {"offset", "`offset`: where the glass begins in the controller's memory, with `MADCTL` 00h",
     [](Guess& g) { g.panel.offset = {}; }},
    {"size", "`glass`: its size in pixels, not the memory's",
     [](Guess& g) { g.panel.glass.height = static_cast<std::int16_t>(g.panel.glass.height - 40); }},
    {"bytes", "`format`: `PixelFormat::rgb565_be`; on the wire the high byte comes first", [](Guess&) {},
     true},
};

} // namespace

std::span<const Wrong> wrongs() {
    return table;
}

const Wrong* find_wrong(const std::string& name) {
    for (const Wrong& wrong : table)
        if (name == wrong.name)
            return &wrong;
    return nullptr;
}

} // namespace spangle::bringup

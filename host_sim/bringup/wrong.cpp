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
    {"bits",
     "`serial`, `parallel`: the code of COLMOD for the format that is sent; `flaw()` knows which a panel "
     "takes",
     [](Guess& g) { g.panel.serial.rgb565 = g.panel.serial.rgb666; }},
    {"data-command", "the D/C line: its number, and that it is wired to DC (A0, RS) of the panel",
     [](Guess&) {}, false, Line::no_data_command},
    {"clock", "`write_hz`: a slower one; shorter wires", [](Guess&) {}, false, Line::too_fast},
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

/// Drops bytes of pixels: one in 256, chosen by noise.
void SpoiltBus::drop_pixels(const hal::Op& op) {
    std::vector<std::uint8_t>& kept = changed_bytes_.emplace_back();
    for (std::uint32_t y = 0; y < op.rows; ++y)
        for (std::uint32_t i = 0; i < op.length; ++i) {
            noise_state_ = noise_state_ * 1664525u + 1013904223u;
            if (noise_state_ >> 24 != 0)
                kept.push_back(op.data[static_cast<std::ptrdiff_t>(y) * op.stride + i]);
        }
    hal::Op less = op;
    less.data = kept.data();
    less.length = static_cast<std::uint32_t>(kept.size());
    less.rows = 1;
    less.stride = static_cast<std::int32_t>(less.length);
    ops_.push_back(less);
}

/// Turns all data of an operation into commands.
void SpoiltBus::change_operation(const hal::Op& op) {
    const bool pixels = op.kind == hal::Op::Kind::pixels || op.kind == hal::Op::Kind::repeat;
    if (pixels)
        return; // black pixels are NOPs, others set registers at random; none lights the panel
    ops_.push_back(op);
    ops_.back().parameters_are_commands = true;
}

hal::Result<hal::Token> SpoiltBus::submit(const hal::Op* ops, std::size_t count) {
    ops_.clear();
    changed_bytes_.clear();
    for (const hal::Op& op : std::span(ops, count)) {
        if (line_ == Line::too_fast && op.kind == hal::Op::Kind::pixels)
            drop_pixels(op);
        else if (line_ == Line::no_data_command)
            change_operation(op);
        else
            ops_.push_back(op);
    }
    return bus_.submit(ops_.data(), ops_.size());
}

} // namespace spangle::bringup

#include "host_sim/bringup/probe.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <spangle/boards/boards.hpp>
#include <spangle/hal/op_list.hpp>
#include <spangle/panels.hpp>

namespace spangle::bringup {
namespace {

using hal::Identity;

constexpr std::uint32_t reset_low_us = 20, longest_reset_wait_us = 120000, patience_us = 1000000;

/// The ILI9341 answers nothing at 04h. It tells its number in the register where related chips tell theirs
/// (datasheet, 8.3.23).
constexpr Identity ili9341 = [] {
    Identity identity = hal::panels::ili9486_320x480.identity;
    identity.id = 0x009341;
    return identity;
}();

const Identity& identity_of(const hal::PanelDesc& panel) {
    return panel.controller == hal::Controller::ili9341 ? ili9341 : panel.identity;
}

std::uint32_t dummy_clocks(const Identity& identity, hal::BusKind kind) {
    return kind == hal::BusKind::i8080 ? identity.parallel_dummy_bits : identity.dummy_bits;
}

bool asks_the_same(const Identity& a, const Identity& b, hal::BusKind kind) {
    return a.command == b.command && a.bytes == b.bytes && dummy_clocks(a, kind) == dummy_clocks(b, kind);
}

/// Whether the panel has an identity, and hangs on a bus of this kind.
bool answers_on(const hal::PanelDesc& panel, hal::BusKind kind) {
    const bool reached = kind == hal::BusKind::i8080 || panel.serial_bus == kind;
    return reached && !panel.quirks.no_read_back && identity_of(panel).id != 0;
}

hal::Result<void> run(hal::Bus& bus, const hal::OpList& ops) {
    const auto token = ops.submit(bus);
    return token ? bus.wait(token.value(), patience_us) : hal::Result<void>(token.error());
}

hal::Result<void> reset_panel(hal::Bus& bus) {
    hal::Op storage[2];
    hal::OpList ops(storage, nullptr, 2);
    ops.reset(reset_low_us);
    ops.delay(longest_reset_wait_us);
    return run(bus, ops);
}

hal::Result<Answer> ask(hal::Bus& bus, const Identity& identity) {
    std::uint8_t bytes[4] = {};
    const std::uint32_t count = std::min<std::uint32_t>(identity.bytes, 3);
    hal::Op storage[1];
    hal::OpList ops(storage, nullptr, 1);
    ops.read(identity.command, static_cast<std::uint8_t>(dummy_clocks(identity, bus.caps().kind)), bytes,
             count);
    if (const auto done = run(bus, ops); !done)
        return done.error();
    Answer answer{identity};
    for (std::uint32_t i = 0; i < count; ++i)
        answer.id = answer.id << 8 | bytes[i];
    const std::uint32_t ones = 0xFFFFFFu >> (24 - 8 * count);
    answer.floating = answer.id == 0 || answer.id == ones;
    return answer;
}

} // namespace

Findings probe(hal::Bus& bus, bool reset) {
    Findings found;
    const hal::BusCaps caps = bus.caps();
    if (caps.read_hz == 0) {
        found.error = "this bus cannot read: the panel's data output is not wired; see docs/gallery.md";
        return found;
    }
    if (reset)
        if (const auto done = reset_panel(bus); !done) {
            found.error = done.error().rule;
            return found;
        }
    for (const hal::PanelDesc* panel : hal::panels::all) {
        if (!answers_on(*panel, caps.kind))
            continue;
        const auto known = std::find_if(found.answers.begin(), found.answers.end(), [&](const Answer& a) {
            return asks_the_same(a.asked, identity_of(*panel), caps.kind);
        });
        Answer answer = known != found.answers.end() ? *known : Answer{};
        if (known == found.answers.end()) {
            const auto asked = ask(bus, identity_of(*panel));
            if (!asked) {
                found.error = asked.error().rule;
                return found;
            }
            found.answers.push_back(answer = asked.value());
        }
        if (!answer.floating && (answer.id & identity_of(*panel).mask) == identity_of(*panel).id)
            found.panels.push_back(panel);
    }
    return found;
}

std::string i2c_candidates() {
    std::string text;
    for (const hal::Board* board : boards::all)
        if (board->bus == hal::BusKind::i2c)
            text += fmt::format("could be: {}  (board {})\n", board->display.panel->name, board->name);
    return text + "the glass tells which: spangle card --i2c DEVICE --board NAME\n";
}

std::string text_of(const Findings& found) {
    if (!found.error.empty())
        return found.error + "\n";
    std::string text;
    for (const Answer& a : found.answers)
        text += fmt::format("{:02X}h: {:0{}X}{}\n", a.asked.command, a.id, 2 * a.asked.bytes,
                            a.floating ? "  nobody drives the line" : "");
    for (const hal::PanelDesc* panel : found.panels) {
        text += fmt::format("fits: {}", panel->name);
        for (const hal::Board* board : boards::all)
            if (board->display.panel == panel)
                text += fmt::format("  (board {})", board->name);
        text += "\n";
    }
    return text + (found.panels.empty() ? "no known panel answers so\n"
                                        : "the glass tells which: spangle card, spangle wizard\n");
}

} // namespace spangle::bringup

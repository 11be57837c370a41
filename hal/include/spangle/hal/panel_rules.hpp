// The rules that a panel display keeps: one list, which board() asks while it is compiled, and
// PanelDisplay::init() when it runs.
#pragma once

#include <spangle/hal/panel_config.hpp>
#include <spangle/hal/panel_memory.hpp>

namespace spangle::hal {

/// The error of a rule that is broken. The compiler's message shows this call as it is written, with the rule
/// in it.
constexpr Error refused(Fault fault, const char* rule, OnFlaw on) {
    if (on == OnFlaw::stop)
        does_not_compile();
    return {fault, rule};
}

/// The rules of [bands](docs/glossary.md#band).
constexpr Result<void> check_band(const PanelConfig& c, OnFlaw on = OnFlaw::tell) {
    if (c.band < 0 || c.band > INT16_MAX || c.band % band_unit(c) != 0)
        return refused(Fault::unsupported,
                       "display: bands end where bytes do; pages of eight rows ask for a multiple of 8", on);
    if (c.band != 0 && (c.wait_te || c.poll_line || c.scan_order || c.row_hash || c.pacing != Pacing::block))
        return refused(Fault::unsupported,
                       "display: bands go out as they are drawn: no waiting for the beam, no order of the "
                       "scan, no row hash, no frames put off",
                       on);
    return {};
}

/// The rules of a description by itself. It must name a panel.
constexpr Result<void> check_config(const PanelConfig& c, OnFlaw on = OnFlaw::tell) {
    if (const char* rule = flaw(*c.panel, on))
        return Error{Fault::bad_argument, rule};
    if (!lies_as_it_travels(c))
        return refused(Fault::unsupported,
                       "display: pixels that share bytes lie otherwise in the panel's memory; give it a wire",
                       on);
    if (const auto r = check_band(c, on); !r)
        return r;
    if (c.row_hash && !c.wire.converts() && sharing(c.format).height != 1)
        return refused(Fault::unsupported, "display: the row hash serves rows, not pages", on);
    if (c.row_hash && sent_size(c).width > RowHash::widest)
        return refused(Fault::unsupported, "display: the row hash serves pictures up to 512 columns", on);
    if (c.wait_te && c.panel->commands->tearing.empty())
        return refused(Fault::unsupported, "display: waiting for TE, but the controller has no such output",
                       on);
    if (c.read_back && c.panel->quirks.no_read_back)
        return refused(Fault::unsupported,
                       "display: reading back from a panel that never drives its data line", on);
    if (c.poll_line && c.panel->quirks.no_read_back)
        return refused(Fault::unsupported,
                       "display: polling the scanned line of a panel that never drives its data line", on);
    if (c.scan_order && (c.buffers != 2 || c.wire.converts()))
        return refused(
            Fault::bad_argument,
            "display: turning frames into the order of the scan takes two buffers, and pixels that travel "
            "as they are",
            on);
    if (c.buffers < 1 || c.buffers > 2)
        return refused(Fault::bad_argument, "display: a panel display has one or two buffers", on);
    if (c.wire.converts() && c.buffers != 1)
        return refused(Fault::bad_argument,
                       "display: a picture that is turned into another format needs one buffer", on);
    return {};
}

/// The rules of a description on a bus with these capabilities. The description keeps check_config().
constexpr Result<void> check_bus(const PanelConfig& c, const BusCaps& caps, OnFlaw on = OnFlaw::tell) {
    const PanelDesc& panel = *c.panel;
    if (caps.write_hz == 0)
        return refused(Fault::unsupported, "display: the bus has no write clock", on);
    if (caps.max_transfer != 0 && caps.max_transfer < sizeof(OpParams))
        return refused(Fault::unsupported,
                       "display: the bus cannot carry the four bytes of CASET (2Ah) in one operation", on);
    if (!format_code(panel, caps.kind, wire_format(c)).taken)
        return refused(Fault::unsupported, "display: the panel does not take this pixel format on this bus",
                       on);
    if (caps.write_hz > fastest_write(panel, caps.kind))
        return refused(Fault::unsupported,
                       "display: the bus's write clock is faster than this panel is known to take", on);
    if (c.read_back && caps.read_hz == 0)
        return refused(Fault::unsupported,
                       "display: reading back needs a read clock, but the bus cannot read", on);
    if (c.poll_line && caps.read_hz == 0)
        return refused(Fault::unsupported, "display: polling the scanned line, but the bus cannot read", on);
    if ((c.read_back || c.poll_line) && caps.read_hz > fastest_read(panel, caps.kind))
        return refused(Fault::unsupported,
                       "display: the bus's read clock is faster than the panel's datasheet allows", on);
    if (c.wait_te && !caps.has_te)
        return refused(Fault::unsupported, "display: waiting for TE, but the bus has no tearing-effect line",
                       on);
    return {};
}

/// Whether the memory suffices for a description that keeps check_config().
Result<void> check_memory(const PanelConfig& config, const PanelMemory& memory);

} // namespace spangle::hal

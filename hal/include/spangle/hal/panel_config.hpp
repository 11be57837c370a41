// What a program says of a panel display, and what follows from it: sizes, formats, rows that share bytes.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/hal/display.hpp>
#include <spangle/hal/orientation.hpp>
#include <spangle/hal/panel.hpp>
#include <spangle/hal/scan_order.hpp>

namespace spangle::hal {

/// What a program says of a panel display. `panel` must outlive the display.
struct PanelConfig {
    /// The panel; it must not be null.
    const PanelDesc* panel = nullptr;
    /// How the picture is turned on the [glass](docs/glossary.md#glass).
    Orientation orientation = {};
    /// The format of the buffers to draw into.
    PixelFormat format = PixelFormat::rgb565_be;
    /// Another format on the wire: a present converts what it sends, in memory of its own, and returns while
    /// that is on the [wire](docs/glossary.md#wire). If it is left out, the surface's pixels travel as they
    /// are.
    Wire wire = {};
    /// The number of buffers. With one, present() returns when the frame is on the panel; with two, while it
    /// is on the wire.
    std::uint8_t buffers = 1;
    bool reset_line = true; ///< the panel's reset line is wired; false: SWRESET is sent instead
    bool read_back = false; ///< the panel's data line is wired back: init() checks what answers
    bool wait_te = false;   ///< tear-free presents: the TE line tells where the beam is
    bool poll_line = false; ///< tear-free presents: reads of the scanned line (45h) tell where the beam is
    /// Frames are turned into the order of the panel's scan where the picture's rows are not in it: only then
    /// can such a picture be free of tears. The second buffer is the turned one; presents return while it is
    /// on the wire.
    bool scan_order = false;
    /// What a present does while the frame before is on the wire.
    Pacing pacing = Pacing::block;
    bool row_hash = false; ///< cells of 16x1 pixels that were drawn again unchanged are not sent
    /// Rows that a buffer holds, where memory holds no whole picture: frames are drawn
    /// [band](docs/glossary.md#band) by band, and with two buffers, or another format on the wire, a band is
    /// drawn while the one above it is on the wire. 0: whole frames.
    std::int32_t band = 0;
};

/// The picture's pixels across and down that share bytes, where they travel as they are.
constexpr Extent sharing(PixelFormat format) {
    const FormatInfo info = format_info(format);
    return {static_cast<std::int16_t>(info.bits % 8 != 0 ? 2 : 1), info.rows};
}

/// Whether pixels that travel as they are fit the panel's memory: those that share a byte must lie together
/// there, too, and rows must end with bytes.
constexpr bool lies_as_it_travels(const PanelConfig& c) {
    const Extent share = sharing(c.format);
    if (c.wire.converts() || (share.width == 1 && share.height == 1))
        return true;
    const Placement placed = place(*c.panel, c.orientation);
    // Pixels of 12 bits are pairs of the stream; those of greys and pages have fixed places in memory.
    const bool turned = (placed.madctl & dcs::MV) != 0 && c.format != PixelFormat::rgb444;
    return !turned && !c.scan_order && placed.size.width % share.width == 0 &&
           placed.size.height % share.height == 0;
}

/// The format of pixels on the wire.
constexpr WireFormat wire_format(const PanelConfig& config) {
    return config.wire.converts() ? config.wire.format : same_bytes(config.format);
}

/// Rows of the picture that share bytes, in memory or on the wire: bands end where these do.
constexpr std::int32_t band_unit(const PanelConfig& c) {
    const WireInfo wire = wire_info(wire_format(c));
    const bool turned = (place(*c.panel, c.orientation).madctl & dcs::MV) != 0;
    const std::int32_t on_wire = turned ? wire.columns : wire.rows, lying = sharing(c.format).height;
    return on_wire > lying ? on_wire : lying;
}

/// Whether frames are turned into the order of the scan.
constexpr bool turns(const PanelConfig& c) {
    return c.scan_order && scan_order(*c.panel, c.orientation).turns();
}
/// The size of the picture in pixels.
constexpr Extent picture_size(const PanelConfig& c) {
    return place(*c.panel, c.orientation).size;
}
/// The size of the buffer that is sent, which is turned where turns().
constexpr Extent sent_size(const PanelConfig& c) {
    return turns(c) ? scan_order(*c.panel, c.orientation).placement.size : picture_size(c);
}
/// The part of a picture of size `whole` that a buffer holds: rows of a band, or all.
constexpr Extent held(const PanelConfig& c, Extent whole) {
    return {whole.width, c.band != 0 ? static_cast<std::int16_t>(c.band) : whole.height};
}
/// Rows of bookkeeping: enough for the picture and for the buffer that is sent.
constexpr std::int32_t book_height(const PanelConfig& c) {
    const std::int32_t drawn = held(c, picture_size(c)).height, sent = held(c, sent_size(c)).height;
    return drawn > sent ? drawn : sent;
}

/// Whether presents wait for the beam.
constexpr bool tear_free(const PanelConfig& c) {
    return c.wait_te || c.poll_line;
}

/// Whether a frame must be one list: between two lists there is a gap of unknown length, and the first one is
/// waited for.
constexpr bool one_list(const PanelConfig& c) {
    return c.buffers == 2 || c.wire.converts() || tear_free(c);
}

/// What follows from a description: where the picture lies, and the bytes of its rows. The parts of a display
/// read it and never change it.
struct PanelLayout {
    /// The description of which this is the layout.
    PanelConfig config;
    /// How frames are turned into the order of the scan, if they are, and the placement of what is sent.
    ScanOrder scan;
    /// The size of the picture in pixels.
    Extent picture;

    /// A layout without a panel, to be assigned later.
    PanelLayout() = default;
    /// The layout of a description, which is not asked for more than its format before resolve().
    explicit PanelLayout(const PanelConfig& description) : config(description) {}
    /// Computes the layout. The description must keep check_config().
    void resolve();

    /// Whether frames are turned into the order of the scan.
    bool turns() const { return scan.turns(); }
    /// The placement of the buffer that is sent.
    const Placement& placement() const { return scan.placement; }
    /// Bits of a pixel on the wire.
    std::uint32_t wire_bits() const { return wire_info(wire_format(config)).bits; }
    /// The bytes of a rectangle of pixels on the wire, rounded up.
    std::size_t wire_bytes(std::int32_t width, std::int32_t height) const {
        return (static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * wire_bits() + 7) / 8;
    }
    /// Bytes that `columns` columns of a buffer take.
    std::uint32_t line_bytes(std::int32_t columns) const {
        return static_cast<std::uint32_t>(row_bytes(config.format, columns));
    }
    /// Bytes from row to row of the picture.
    std::uint32_t stride() const { return line_bytes(picture.width); }
    /// Bytes from row to row of the buffer that is sent.
    std::uint32_t sent_stride() const { return line_bytes(placement().size.width); }
    /// Rows that share the bytes of a buffer.
    std::int32_t rows_at_once() const { return format_info(config.format).rows; }
    /// Pixels across and down that share bytes in a buffer, or on the wire, where `on_wire` do.
    Extent shared(Extent on_wire) const {
        const Extent lying = config.wire.converts() ? Extent{1, 1} : sharing(config.format);
        return {on_wire.width > lying.width ? on_wire.width : lying.width,
                on_wire.height > lying.height ? on_wire.height : lying.height};
    }
    /// The number of buffers, which are drawn in turn.
    std::uint8_t canvases() const { return turns() || config.band != 0 ? 1 : config.buffers; }
};

} // namespace spangle::hal

// A panel: a controller with its memory, and the glass that shows a window of it. Plain constexpr data; what
// the driver does with it is the same for all of them.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>
#include <spangle/hal/dcs.hpp>
#include <spangle/hal/init_program.hpp>

namespace spangle::hal {

enum class Controller : std::uint8_t {
    ili9341,
    st7789,
    st7735,
    ili9342c,
    ili9486,
    ili9488,
    st7796s,
    gc9a01,
    hx8357d
};
enum class ColorOrder : std::uint8_t { rgb, bgr };
enum class BusKind : std::uint8_t {
    spi4,  ///< 4-wire serial: CS, D/C, SCK, SDA (DBI-C option 3)
    i8080, ///< 8-bit parallel: CS, D/C, WR, RD, D[7:0] (DBI-B)
};

struct Extent {
    std::int16_t width = 0, height = 0;
};
struct Offset {
    std::int16_t x = 0, y = 0;
};

/// What the datasheet demands of time. Cycles are the shortest allowed.
struct PanelTiming {
    std::uint16_t reset_low_us = 10;
    std::uint32_t reset_wait_us = 120000;     ///< reset released, or SWRESET, to the first command
    std::uint32_t sleep_out_wait_us = 120000; ///< SLPOUT to the next command: supplies and registers settle
    std::uint16_t serial_write_ns = 100;
    std::uint16_t serial_read_ns = 150;
    std::uint16_t parallel_write_ns = 66;
    std::uint16_t parallel_read_ns = 450;    ///< of frame memory, the slowest read
    std::uint16_t practical_serial_mhz = 10; ///< what boards run it at; a board above this is a mistake
    std::uint32_t frame_us = 0;              ///< one refresh after `setup`
    std::uint16_t scan_lines = 0;            ///< rows and porches of one refresh
    std::uint16_t porch_lines = 0;           ///< of these, lines of vertical blanking: TE is high
};

/// What tells the controller from others, and the clocks the line needs to turn round on a serial bus.
struct Identity {
    std::uint8_t command = dcs::RDDID; ///< or a register of the maker's
    std::uint8_t bytes = 3;            ///< of its answer, 3 at most
    std::uint8_t dummy_bits = 1;
    std::uint32_t id = 0; ///< the first byte highest
    std::uint32_t mask = 0xFFFFFF;
    std::uint8_t register_dummy_bits = 1; ///< 09h 45h; the one-byte reads have none
    std::uint8_t pixel_dummy_bits = 8;    ///< 2Eh
};

/// COLMOD (3Ah) parameter of each wire format; 0: the controller cannot take it on this bus.
struct WireFormats {
    std::uint8_t rgb565 = 0;
    std::uint8_t rgb666 = 0; ///< three bytes, six bits left aligned: PixelFormat::rgb888 serves it
};

struct Quirks {
    bool resend_window = false; ///< RAMWR does not return to the window's start: CASET and RASET each time
    bool no_read_back = false;  ///< the data line never drives back
    bool reads_write_depth = false; ///< RAMRD answers in COLMOD's format, not in three bytes a pixel
};

struct PanelDesc {
    const char* name = "";
    Controller controller = Controller::ili9341;
    Extent memory;          ///< the controller's frame memory, MADCTL 00h
    Extent glass;           ///< the part of it that shows
    Offset offset{};        ///< of the glass in memory, MADCTL 00h
    std::uint8_t mount = 0; ///< MADCTL's MX, MY that show a picture upright on this glass
    ColorOrder order = ColorOrder::rgb;
    bool inverted = false; ///< IPS glass: INVON shows true colours
    WireFormats serial;
    WireFormats parallel;
    Program setup; ///< registers beyond DCS, sent while asleep
    PanelTiming timing;
    Identity identity;
    Quirks quirks;
};

/// COLMOD's parameter for a surface format on this bus, or 0 when the panel cannot show it.
constexpr std::uint8_t colmod(const PanelDesc& panel, BusKind bus, PixelFormat format) {
    const WireFormats& formats = bus == BusKind::spi4 ? panel.serial : panel.parallel;
    if (format == PixelFormat::rgb565_be)
        return formats.rgb565;
    if (format == PixelFormat::rgb888)
        return formats.rgb666;
    return 0;
}

/// Whether a rule that a description breaks is told, or stops the compiler with the rule in its message.
enum class OnFlaw : std::uint8_t { tell, stop };
/// Not constexpr: no constant expression gets past it.
inline void does_not_compile() {}
/// The compiler shows this call as it is written, the rule in it.
constexpr const char* broken(const char* rule, OnFlaw on) {
    if (on == OnFlaw::stop)
        does_not_compile();
    return rule;
}

/// The rule this description breaks, or null.
constexpr const char* flaw(const PanelDesc& p, OnFlaw on = OnFlaw::tell) {
    if (p.memory.width <= 0 || p.memory.height <= 0)
        return broken("panel: the memory has no size", on);
    if (p.memory.width > 4096 || p.memory.height > 4096)
        return broken("panel: the memory is larger than 4096 x 4096", on);
    if (p.glass.width <= 0 || p.glass.height <= 0)
        return broken("panel: the glass has no size", on);
    if (p.offset.x < 0 || p.offset.y < 0)
        return broken("panel: the offset is negative", on);
    if (p.offset.x + p.glass.width > p.memory.width)
        return broken("panel: the glass is wider than the memory behind it", on);
    if (p.offset.y + p.glass.height > p.memory.height)
        return broken("panel: the glass is taller than the memory behind it", on);
    if ((p.mount & ~(dcs::MX | dcs::MY)) != 0)
        return broken("panel: a mount is made of MX and MY only", on);
    if (!well_formed(p.setup))
        return broken("panel: the setup program is cut short", on);
    if (p.timing.reset_low_us < 10)
        return broken("panel: a reset pulse is at least 10 us", on);
    if (p.identity.bytes < 1 || p.identity.bytes > 3)
        return broken("panel: an identity has one to three bytes", on);
    return nullptr;
}

/// Describes a panel, or does not compile.
consteval PanelDesc panel(PanelDesc description) {
    flaw(description, OnFlaw::stop);
    return description;
}

} // namespace spangle::hal

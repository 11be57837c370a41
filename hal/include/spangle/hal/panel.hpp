// A panel: a controller with its memory, and the [glass](docs/glossary.md#glass) that shows a window of it.
// A panel is plain constexpr data, which the driver treats alike for all panels.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>
#include <spangle/hal/bus.hpp>
#include <spangle/hal/command_set.hpp>
#include <spangle/hal/wire.hpp>

namespace spangle::hal {

/// The controllers that Spangle knows. Two panels with the same controller may differ in their command sets.
/// DCS controllers come first, in the order of the simulator's models (host_sim/controller/chip.hpp). A new
/// one goes behind hx8357d here, and to the end of the models there.
enum class Controller : std::uint8_t {
    ili9341,
    st7789,
    st7735,
    ili9342c,
    ili9486,
    ili9488,
    st7796s,
    gc9a01,
    hx8357d,
    ssd1306,
    sh1106,
    ssd0303,
    ssd1327,
    ssd0323,
    ssd1351,
    ssd1331,
    hx8347
};
/// Which subpixel of the glass the controller's red output drives: MADCTL's BGR.
enum class ColorOrder : std::uint8_t { rgb, bgr };
/// A size in pixels.
struct Extent {
    /// Pixels across and down.
    std::int16_t width = 0, height = 0;
};
/// A position in pixels, right and down.
struct Offset {
    /// Pixels to the right and down.
    std::int16_t x = 0, y = 0;
};

/// Times that the datasheet demands, in the unit that each name ends with. Cycles are the shortest allowed.
struct PanelTiming {
    /// The shortest reset pulse, 10 at least.
    std::uint16_t reset_low_us = 10;
    std::uint32_t reset_wait_us = 120000;     ///< from the end of reset, or SWRESET, to the first command
    std::uint32_t sleep_out_wait_us = 120000; ///< from SLPOUT to the next command: supplies settle
    /// A clock cycle of a serial write.
    std::uint16_t serial_write_ns = 100;
    /// A clock cycle of a serial read.
    std::uint16_t serial_read_ns = 150;
    /// A write cycle of a parallel bus.
    std::uint16_t parallel_write_ns = 66;
    std::uint16_t parallel_read_ns = 450;    ///< a read cycle of frame memory, the slowest
    std::uint32_t i2c_hz = 0;                ///< frequency at which boards run SCL; 0: the panel has no I2C
    std::uint16_t practical_serial_mhz = 10; ///< the fastest serial clock of boards; more is a mistake
    std::uint32_t frame_us = 0;              ///< time of one refresh, with the registers of `setup`
    std::uint16_t scan_lines = 0;            ///< lines of one refresh, porches included
    std::uint16_t porch_lines = 0;           ///< lines of vertical blanking among them, in which TE is high
};

/// What tells the controller from others, and the dummy clocks that a serial data line takes to turn round.
struct Identity {
    std::uint8_t command = dcs::RDDID; ///< the command that reads the identity, which may be the maker's own
    std::uint8_t bytes = 3;            ///< bytes of the answer, 3 at most
    /// Clocks between command and answer on a serial bus.
    std::uint8_t dummy_bits = 1;
    std::uint8_t parallel_dummy_bits = 8; ///< dummy read cycles, eight bits each
    std::uint32_t id = 0;                 ///< the answer, with its first byte highest
    /// The bits of `id` that tell the controller from others.
    std::uint32_t mask = 0xFFFFFF;
    std::uint8_t register_dummy_bits = 1; ///< dummy bits of 09h and 45h; reads of one byte have none
    std::uint8_t pixel_dummy_bits = 8;    ///< dummy bits of 2Eh, the read of pixels
};

/// The pixel format register's code of a [wire](docs/glossary.md#wire) format, or that the controller does
/// not take it.
struct FormatCode {
    /// Whether the controller takes the format.
    bool taken = false;
    /// The code to which the controller's pixel format register is set.
    std::uint8_t code = 0;

    /// The controller does not take the format.
    constexpr FormatCode() = default;
    /// The controller takes the format; its code, 0 to 255.
    constexpr FormatCode(int value) : taken(true), code(static_cast<std::uint8_t>(value)) {}
};

/// Codes of COLMOD (3Ah) or its like; 0 where a controller has no such register.
struct WireFormats {
    /// The code of the WireFormat of that name.
    FormatCode rgb565{}, rgb666{}, rgb444{}, rgb332{}, grey4{}, mono{};
};

/// Where a controller differs from its data sheet or from the others.
struct Quirks {
    bool resend_window = false; ///< RAMWR does not go to the window's start: CASET and RASET are always sent
    bool no_read_back = false;  ///< the controller never drives the data line
    bool reads_write_depth = false; ///< RAMRD answers in COLMOD's format, not with three bytes a pixel
};

/// A panel as data. panel() checks a description while it is compiled. What it points to is constant and
/// static.
struct PanelDesc {
    /// The name that people read.
    const char* name = "";
    /// The controller, by which the simulator chooses its model.
    Controller controller = Controller::ili9341;
    Extent memory;          ///< size of the controller's frame memory, with MADCTL 00h
    Extent glass;           ///< size of the part of the memory that the glass shows
    Offset offset{};        ///< where the glass begins in memory, with MADCTL 00h
    std::uint8_t mount = 0; ///< the MX and MY of MADCTL that show a picture upright on this glass
    /// The order of subpixels on this glass.
    ColorOrder order = ColorOrder::rgb;
    bool inverted = false; ///< IPS glass: INVON shows true colours
    /// The serial bus that this panel has, spi4 or spi_start.
    BusKind serial_bus = BusKind::spi4;
    WireFormats serial; ///< formats on `serial_bus`, and on I2C
    /// Formats on an 8080 bus.
    WireFormats parallel{};
    Program setup; ///< registers beyond the command set's, sent while asleep
    /// The commands that the controller understands.
    const CommandSet* commands = &dcs::commands;
    /// The controller's times.
    PanelTiming timing;
    /// How the controller answers when it is asked for its identity.
    Identity identity{};
    /// What is unusual about the controller.
    Quirks quirks{};
    bool round = false; ///< the glass is a disc: the corners of its rectangle are written and not seen
};

/// Whether and how the panel takes a wire format on this bus.
constexpr FormatCode format_code(const PanelDesc& panel, BusKind bus, WireFormat format) {
    const bool reached = bus == BusKind::i2c     ? panel.timing.i2c_hz != 0
                         : bus == BusKind::i8080 ? true
                                                 : bus == panel.serial_bus;
    if (!reached)
        return {};
    const WireFormats& f = bus == BusKind::i8080 ? panel.parallel : panel.serial;
    // The codes have the order of WireFormat.
    const FormatCode codes[] = {f.rgb565, f.rgb666, f.rgb444, f.rgb332, f.grey4, f.mono, FormatCode{}};
    return codes[static_cast<unsigned>(format)];
}

/// What happens where a description breaks a rule: the rule is returned, or it stops the compiler.
enum class OnFlaw : std::uint8_t { tell, stop };
/// A call of this function is no constant expression, because it is not constexpr.
inline void does_not_compile() {}
/// The compiler's message shows this call as it is written, with the rule in it.
constexpr const char* broken(const char* rule, OnFlaw on) {
    if (on == OnFlaw::stop)
        does_not_compile();
    return SPANGLE_MESSAGES != 0 ? rule : "";
}

/// The fastest clock as BusCaps::write_hz has it: Hz, or cycles of a parallel bus per second.
constexpr std::uint32_t fastest_write(const PanelDesc& panel, BusKind bus) {
    return bus == BusKind::i2c     ? i2c_caps(panel.timing.i2c_hz).write_hz
           : bus == BusKind::i8080 ? 1000000000u / panel.timing.parallel_write_ns
                                   : panel.timing.practical_serial_mhz * 1000000u;
}
/// The fastest clock of a read in Hz, or cycles of a parallel bus per second.
constexpr std::uint32_t fastest_read(const PanelDesc& panel, BusKind bus) {
    return 1000000000u /
           (bus == BusKind::i8080 ? panel.timing.parallel_read_ns : panel.timing.serial_read_ns);
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
    for (const WireFormat shared : {WireFormat::grey4, WireFormat::mono}) {
        const WireInfo info = wire_info(shared);
        if (!format_code(p, p.serial_bus, shared).taken && !format_code(p, BusKind::i8080, shared).taken)
            continue;
        if ((p.memory.width | p.glass.width | p.offset.x) % info.columns != 0 ||
            (p.memory.height | p.glass.height | p.offset.y) % info.rows != 0)
            return broken("panel: memory, glass and offset end where bytes of pixels do", on);
    }
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

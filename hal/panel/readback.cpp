#include <spangle/hal/readback.hpp>
#include <spangle/hal/window.hpp>

namespace spangle::hal {
namespace {

/// A parallel bus always gives one dummy byte first; a serial one the clocks the datasheet asks for.
std::uint8_t dummy_bits(const BusCaps& caps, std::uint8_t serial) {
    return caps.bits_per_cycle > 1 ? 8 : serial;
}

Result<void> run(Bus& bus, const BusCaps& caps, const OpList& ops) {
    const Result<Token> token = ops.submit(bus);
    if (!token)
        return token.error();
    const std::uint32_t time = ops.duration(caps);
    return bus.wait(token.value(), time < UINT32_MAX - caps.late_us ? time + caps.late_us : UINT32_MAX);
}

Result<BusCaps> readable(const Bus& bus, const PanelDesc& panel) {
    const BusCaps caps = bus.caps();
    if (caps.read_hz == 0)
        return Error{Fault::unsupported, "panel: this bus cannot read"};
    if (panel.quirks.no_read_back)
        return Error{Fault::unsupported, "panel: the controller never drives its data line"};
    return caps;
}

/// Whether status registers and memory can be read, which only DCS describes.
Result<BusCaps> readable_as_dcs(const Bus& bus, const PanelDesc& panel) {
    if (!panel.commands->status_registers)
        return Error{Fault::unsupported, "panel: this controller has no status registers (09h to 0Fh)"};
    return readable(bus, panel);
}

/// Appends the read of the identity; returns its bytes.
std::uint32_t read_identity(OpList& ops, const BusCaps& caps, const Identity& identity,
                            ReadScratch& scratch) {
    const std::uint32_t bytes = identity.bytes < sizeof scratch.id ? identity.bytes : sizeof scratch.id;
    const std::uint8_t dummies = caps.bits_per_cycle > 1 ? identity.parallel_dummy_bits : identity.dummy_bits;
    ops.read(identity.command, dummies, scratch.id, bytes);
    return bytes;
}

std::uint32_t big_endian(const std::uint8_t* bytes, int count) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i)
        value = value << 8 | bytes[i];
    return value;
}

/// Widens pixels from two bytes to three, in place. It begins with the last pixel, so that none is
/// overwritten before it is read.
void widen_565(std::uint8_t* rgb, std::uint32_t pixels) {
    for (std::uint32_t i = pixels; i-- > 0;) {
        const unsigned word = static_cast<unsigned>(rgb[2 * i]) << 8 | rgb[2 * i + 1];
        rgb[3 * i] = static_cast<std::uint8_t>(word >> 8 & 0xF8);
        rgb[3 * i + 1] = static_cast<std::uint8_t>(word >> 3 & 0xFC);
        rgb[3 * i + 2] = static_cast<std::uint8_t>(word << 3 & 0xF8);
    }
}

/// The identity that is read from a data line that floats high.
std::uint32_t all_ones_identity(const Identity& identity) {
    return 0xFFFFFFu >> (24u - 8u * (identity.bytes < 3 ? identity.bytes : 3u));
}

} // namespace

std::uint8_t register_dummy_bits(const BusCaps& caps, const PanelDesc& panel) {
    return dummy_bits(caps, panel.identity.register_dummy_bits);
}

Result<PanelStatus> read_status(Bus& bus, const PanelDesc& panel, ReadScratch& scratch) {
    const Result<BusCaps> caps = readable_as_dcs(bus, panel);
    if (!caps)
        return caps.error();
    const std::uint8_t wide = register_dummy_bits(caps.value(), panel);
    const std::uint8_t narrow = dummy_bits(caps.value(), 0);
    scratch = {};
    Op storage[8];
    OpList ops(storage, nullptr, 8);
    const std::uint32_t id_bytes = read_identity(ops, caps.value(), panel.identity, scratch);
    ops.read(dcs::RDDST, wide, scratch.status, 4);
    for (unsigned i = 0; i < 6; ++i)
        ops.read(static_cast<std::uint8_t>(dcs::RDDPM + i), narrow, &scratch.registers[i], 1);
    if (const Result<void> done = run(bus, caps.value(), ops); !done)
        return done.error();
    const std::uint8_t(&registers)[6] = scratch.registers;
    return PanelStatus{big_endian(scratch.id, static_cast<int>(id_bytes)),
                       big_endian(scratch.status, 4),
                       registers[0],
                       registers[1],
                       registers[2],
                       registers[3],
                       registers[4],
                       registers[5]};
}

Result<std::uint16_t> read_scanline(Bus& bus, const PanelDesc& panel, ReadScratch& scratch) {
    const Result<BusCaps> caps = readable_as_dcs(bus, panel);
    if (!caps)
        return caps.error();
    scratch = {};
    Op storage[1];
    OpList ops(storage, nullptr, 1);
    ops.read(dcs::RDSCANLINE, register_dummy_bits(caps.value(), panel), scratch.scanline, 2);
    if (const Result<void> done = run(bus, caps.value(), ops); !done)
        return done.error();
    return static_cast<std::uint16_t>(big_endian(scratch.scanline, 2));
}

Result<void> read_pixels(Bus& bus, const PanelDesc& panel, const Placement& placement, PixelFormat written,
                         const Rect& area, std::uint8_t* rgb, ReadScratch& scratch) {
    const Result<BusCaps> caps = readable_as_dcs(bus, panel);
    if (!caps)
        return caps.error();
    if (area.w <= 0 || area.h <= 0 || area.x < 0 || area.y < 0 || area.w > placement.size.width - area.x ||
        area.h > placement.size.height - area.y)
        return Error{Fault::bad_argument, "panel: the area to read is not inside the picture"};
    const std::uint32_t pixels = static_cast<std::uint32_t>(area.w) * static_cast<std::uint32_t>(area.h);
    const bool two_bytes = panel.quirks.reads_write_depth && written == PixelFormat::rgb565_be;
    Op storage[3];
    OpList ops(storage, scratch.window, 3);
    Windows(panel, placement, same_bytes(written)).select(ops, area);
    ops.read(dcs::RAMRD, dummy_bits(caps.value(), panel.identity.pixel_dummy_bits), rgb,
             pixels * (two_bytes ? 2u : 3u));
    if (const Result<void> done = run(bus, caps.value(), ops); !done)
        return done;
    if (two_bytes)
        widen_565(rgb, pixels);
    return {};
}

/// Reads the identity alone, on controllers without status registers.
static Result<PanelStatus> read_identity_alone(Bus& bus, const PanelDesc& panel, ReadScratch& scratch) {
    const Result<BusCaps> caps = readable(bus, panel);
    if (!caps)
        return caps.error();
    scratch = {};
    Op storage[1];
    OpList ops(storage, nullptr, 1);
    const std::uint32_t bytes = read_identity(ops, caps.value(), panel.identity, scratch);
    if (const Result<void> done = run(bus, caps.value(), ops); !done)
        return done.error();
    PanelStatus status;
    status.id = big_endian(scratch.id, static_cast<int>(bytes));
    status.status = status.id == all_ones_identity(panel.identity) ? 0xFFFFFFFF : 0;
    return status;
}

Result<void> check_identity(Bus& bus, const PanelDesc& panel, ReadScratch& scratch) {
    const bool alone = !panel.commands->status_registers;
    const Result<PanelStatus> answer =
        alone ? read_identity_alone(bus, panel, scratch) : read_status(bus, panel, scratch);
    if (!answer)
        return answer.error();
    const std::uint32_t id = answer.value().id, status = answer.value().status;
    const bool floating =
        (id == 0 && status == 0) || (id == all_ones_identity(panel.identity) && status == 0xFFFFFFFF);
    if (floating)
        return Error{Fault::no_answer, "panel: the identity and RDDST (09h) read a line nobody drives", id};
    if ((id & panel.identity.mask) != panel.identity.id)
        return Error{Fault::wrong_device, "panel: the identity names another controller", id};
    return {};
}

} // namespace spangle::hal

// What a panel says about itself: identity, status, scan position and the pixels in its memory.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>
#include <spangle/hal/bus.hpp>
#include <spangle/hal/op_list.hpp>
#include <spangle/hal/orientation.hpp>

namespace spangle::hal {

/// What a controller's registers of status answered (DCS 1.02, 04h and 09h to 0Fh).
struct PanelStatus {
    std::uint32_t id = 0;         ///< answer to Identity::command; 04h answers ID1, ID2, ID3
    std::uint32_t status = 0;     ///< display status, 09h; the first bit on the wire is bit 31
    std::uint8_t power_mode = 0;  ///< power mode, register 0Ah
    std::uint8_t madctl = 0;      ///< MADCTL, register 0Bh
    std::uint8_t colmod = 0;      ///< COLMOD, register 0Ch
    std::uint8_t image_mode = 0;  ///< image mode, register 0Dh
    std::uint8_t signal_mode = 0; ///< signal mode, register 0Eh
    std::uint8_t self_check = 0;  ///< self-diagnostic result, register 0Fh
};

/// Memory in which answers arrive. It must stay as long as the bus may touch it: after a timeout, until the
/// transfer is done.
struct ReadScratch {
    /// Answers to the identity, to 09h, to 0Ah to 0Fh, and to 45h.
    std::uint8_t id[3], status[4], registers[6], scanline[2];
    /// Parameters of window commands.
    OpParams window[3];
};

/// Reads the identity, 09h and 0Ah to 0Fh in one transfer. Fault::unsupported: the bus or the panel cannot be
/// read.
Result<PanelStatus> read_status(Bus& bus, const PanelDesc& panel, ReadScratch& scratch);

/// Dummy bits of 04h, 09h and 45h on this bus.
std::uint8_t register_dummy_bits(const BusCaps& caps, const PanelDesc& panel);

/// Reads the line that the controller is scanning, by 45h.
Result<std::uint16_t> read_scanline(Bus& bus, const PanelDesc& panel, ReadScratch& scratch);

/// Reads the pixels of `area` by 2Eh, row by row, into `rgb`. Each takes three bytes: R, G and B, in the
/// upper six bits. `written` is the format to which COLMOD is set. The controller's window moves.
Result<void> read_pixels(Bus& bus, const PanelDesc& panel, const Placement& placement, PixelFormat written,
                         const Rect& area, std::uint8_t* rgb, ReadScratch& scratch);

/// Checks that this is the panel it should be. The error says what answered (`detail`), or that nothing did.
Result<void> check_identity(Bus& bus, const PanelDesc& panel, ReadScratch& scratch);

} // namespace spangle::hal

// Commands of the MIPI display command set (DCS 1.02) that the panels share, by their datasheet names.
#pragma once

#include <cstdint>

namespace spangle::hal::dcs {

/// The commands, by their names in datasheets.
enum : std::uint8_t {
    SWRESET = 0x01,
    RDDID = 0x04,
    RDDST = 0x09,
    RDDPM = 0x0A,
    RDDMADCTL = 0x0B,
    RDDCOLMOD = 0x0C,
    RDDIM = 0x0D,
    RDDSM = 0x0E,
    RDDSDR = 0x0F,
    SLPOUT = 0x11,
    NORON = 0x13,
    INVOFF = 0x20,
    INVON = 0x21,
    GAMSET = 0x26,
    DISPON = 0x29,
    CASET = 0x2A,
    RASET = 0x2B,
    RAMWR = 0x2C,
    RAMRD = 0x2E,
    TEON = 0x35,
    MADCTL = 0x36,
    COLMOD = 0x3A,
    RDSCANLINE = 0x45,
};

/// Bits of MADCTL (36h): row order, column order, rows and columns exchanged, refresh upwards, blue first,
/// refresh leftwards.
enum : std::uint8_t { MY = 0x80, MX = 0x40, MV = 0x20, ML = 0x10, BGR = 0x08, MH = 0x04 };

} // namespace spangle::hal::dcs

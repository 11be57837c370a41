// SPI of SiFive's FE310: master, eight bits a frame, chip select by a GPIO line. FE310-G002 manual,
// chapter 19.
#pragma once

#include <cstdint>

#include <spangle/mcu/registers.hpp>

namespace spangle::mcu {

/// One SPI block, for SpiWires.
class Fe310Spi {
  public:
    /// How the block is set up.
    struct Setup {
        std::uint32_t divider; ///< SCK = tlclk / (2 (divider + 1))
        std::uint8_t mode;     ///< SPI mode 0 to 3: CPOL * 2 + CPHA
    };

    /// `base`: the block's address.
    explicit constexpr Fe310Spi(std::uintptr_t base) : base_(base) {}

    /// Sets the block up.
    void start(const Setup& setup) const {
        constexpr std::uint32_t cs_off = 3, eight_bits = 8u << 16;
        reg(base_ + sckdiv) = setup.divider;
        reg(base_ + sckmode) = (setup.mode & 1u) | (setup.mode & 2u);
        reg(base_ + csmode) = cs_off;
        reg(base_ + fmt) = eight_bits; // single data line, most significant bit first, receiver on
    }

    /// Returns when the last bit has left, which is known from the byte that came in beside each one sent.
    void write(const std::uint8_t* bytes, std::uint32_t count) const {
        std::uint32_t under_way = 0;
        for (; count != 0; --count) {
            while ((reg(base_ + txdata) & full) != 0) {
            }
            reg(base_ + txdata) = *bytes++;
            if (++under_way == fifo_depth) {
                take();
                --under_way;
            }
        }
        for (; under_way != 0; --under_way)
            take();
    }

    /// Clocks one byte in.
    std::uint8_t read() const {
        reg(base_ + txdata) = 0;
        return take();
    }

    /// Offsets of the block's registers.
    static constexpr std::uintptr_t sckdiv = 0x00, sckmode = 0x04, csmode = 0x18, fmt = 0x40, txdata = 0x48,
                                    rxdata = 0x4C;

  private:
    static constexpr std::uint32_t full = 1u << 31, empty = 1u << 31;
    static constexpr std::uint32_t fifo_depth = 8;

    std::uint8_t take() const {
        std::uint32_t in = 0;
        do
            in = reg(base_ + rxdata);
        while ((in & empty) != 0);
        return static_cast<std::uint8_t>(in);
    }

    std::uintptr_t base_;
};

} // namespace spangle::mcu

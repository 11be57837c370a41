// SPI of STM32F2/F4: master, eight bits a frame, chip select by software. RM0090 (STM32F405), 28.5.
#pragma once

#include <cstdint>

#include <spangle/mcu/registers.hpp>

namespace spangle::mcu {

/// One SPI block, for SpiWires.
class Stm32Spi {
  public:
    /// How the block is set up.
    struct Setup {
        std::uint8_t divider; ///< value of BR: SCK = PCLK / 2^(divider + 1)
        std::uint8_t mode;    ///< SPI mode 0 to 3: CPOL * 2 + CPHA
    };

    /// `base`: the block's address, whose clock must run.
    explicit constexpr Stm32Spi(std::uintptr_t base) : base_(base) {}

    /// Sets the block up.
    void start(const Setup& setup) const {
        constexpr std::uint32_t ssm = 1u << 9, ssi = 1u << 8, spe = 1u << 6, mstr = 1u << 2;
        reg(base_ + cr1) = ssm | ssi | spe | std::uint32_t{setup.divider} << 3 | mstr |
                           (setup.mode >> 1 & 1u) << 1 | (setup.mode & 1u);
    }

    /// Returns when the last bit has left. Bytes received meanwhile are dropped.
    void write(const std::uint8_t* bytes, std::uint32_t count) const {
        for (; count != 0; --count) {
            while ((reg(base_ + sr) & txe) == 0) {
            }
            reg(base_ + dr) = *bytes++;
        }
        while ((reg(base_ + sr) & (txe | bsy)) != txe) {
        }
        // A read of DR and then one of SR clear OVR (28.3.10).
        [[maybe_unused]] std::uint32_t dropped = reg(base_ + dr);
        dropped = reg(base_ + sr);
    }

    /// Clocks one byte in.
    std::uint8_t read() const {
        reg(base_ + dr) = 0;
        while ((reg(base_ + sr) & rxne) == 0) {
        }
        return static_cast<std::uint8_t>(reg(base_ + dr));
    }

    /// Offsets of the block's registers.
    static constexpr std::uintptr_t cr1 = 0x00, sr = 0x08, dr = 0x0C;

  private:
    static constexpr std::uint32_t rxne = 1u << 0, txe = 1u << 1, bsy = 1u << 7;

    std::uintptr_t base_;
};

} // namespace spangle::mcu

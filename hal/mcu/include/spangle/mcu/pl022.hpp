// Arm PrimeCell PL022 (TI: SSI), the SPI block of Arm's boards and of Stellaris: master, eight bits a frame.
// PrimeCell SSP TRM (DDI 0194), 3.3.
#pragma once

#include <cstdint>

#include <spangle/mcu/registers.hpp>

namespace spangle::mcu {

/// One block, for SpiWires.
class Pl022 {
  public:
    /// How the block is set up.
    struct Setup {
        std::uint8_t prescale; ///< 2 to 254, even: SCK = SSPCLK / (prescale * (1 + rate))
        /// The rate in the formula of `prescale`, 0 to 255.
        std::uint8_t rate;
        std::uint8_t mode; ///< SPI mode 0 to 3: CPOL * 2 + CPHA
    };

    /// `base`: the block's address.
    explicit constexpr Pl022(std::uintptr_t base) : base_(base) {}

    /// Sets the block up.
    void start(const Setup& setup) const {
        constexpr std::uint32_t eight_bits = 7, enable = 1u << 1;
        reg(base_ + cr1) = 0;
        reg(base_ + cpsr) = setup.prescale;
        reg(base_ + cr0) = std::uint32_t{setup.rate} << 8 | (setup.mode & 1u) << 7 |
                           (setup.mode >> 1 & 1u) << 6 | eight_bits;
        reg(base_ + cr1) = enable;
    }

    /// Returns when the last bit has left. Bytes received meanwhile are dropped.
    void write(const std::uint8_t* bytes, std::uint32_t count) const {
        while (count != 0) {
            while ((reg(base_ + sr) & empty) == 0) {
            }
            const std::uint32_t now = count < depth ? count : depth;
            for (std::uint32_t i = 0; i < now; ++i)
                reg(base_ + dr) = bytes[i];
            bytes += now;
            count -= now;
            take();
        }
        while ((reg(base_ + sr) & busy) != 0) {
        }
        take();
    }

    /// Clocks one byte in.
    std::uint8_t read() const {
        reg(base_ + dr) = 0;
        while ((reg(base_ + sr) & (busy | received)) != received) {
        }
        return static_cast<std::uint8_t>(reg(base_ + dr));
    }

  private:
    static constexpr std::uintptr_t cr0 = 0x00, cr1 = 0x04, dr = 0x08, sr = 0x0C, cpsr = 0x10;
    static constexpr std::uint32_t depth = 8; ///< depth of the FIFOs, in bytes
    static constexpr std::uint32_t empty = 1u << 0, received = 1u << 2, busy = 1u << 4;

    /// Empties the receiver. Its overrun does no harm, but the next read would find the old bytes.
    void take() const {
        while ((reg(base_ + sr) & received) != 0) {
            [[maybe_unused]] const std::uint32_t dropped = reg(base_ + dr);
        }
    }

    std::uintptr_t base_;
};

} // namespace spangle::mcu

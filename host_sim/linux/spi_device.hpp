// A model of a device behind spidev, which turns messages into clocked bits. It is written from
// include/uapi/linux/spi/spidev.h and drivers/spi/spidev.c.
#pragma once

#include <string>

#include "host_sim/bus/pins.hpp"
#include "host_sim/linux/kernel.hpp"

namespace spangle::sim {

class SpiDevice final : public Device {
  public:
    /// Messages are clocked into `pins`.
    explicit SpiDevice(SerialPins& pins) : pins_(pins) {}
    /// Makes the device file, and the entry of /sys that tells the module's bufsiz.
    void attach(Kernel& kernel, const std::string& path);

    // --- properties of the SPI controller
    std::size_t bufsiz = 4096;        ///< most bytes of a message; set before attach()
    std::size_t alignment = 128;      ///< multiple to which bufsiz counts a transfer's bytes (arm64)
    bool nine_bit_words = true;       ///< false: only words of 8 bits, as on a Raspberry Pi
    std::uint32_t max_hz = 125000000; ///< higher clock rates are lowered to this one
    std::uint32_t min_hz = 1;         ///< lower clock rates are refused
    Time message_ns = 10000;          ///< ns that a message costs beyond its bits

    struct Settings {
        std::uint32_t mode = 0, hz = 0;
        std::uint8_t bits = 8;
    };
    const Settings& settings() const { return settings_; }
    std::uint64_t message_count() const { return message_count_; }
    std::size_t largest_message() const { return largest_message_; }

    std::unique_ptr<OpenFile> open() override;
    int gone_error() const override;

  private:
    friend class SpiFile;
    SerialPins& pins_;
    Kernel* kernel_ = nullptr;
    Settings settings_;
    std::uint64_t message_count_ = 0;
    std::size_t largest_message_ = 0;
};

} // namespace spangle::sim

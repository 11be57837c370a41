// A device behind spidev: messages become clocked bits. From include/uapi/linux/spi/spidev.h and
// drivers/spi/spidev.c.
#pragma once

#include <string>

#include "host_sim/bus/pins.hpp"
#include "host_sim/linux/kernel.hpp"

namespace spangle::sim {

class SpiDevice final : public Device {
  public:
    /// Messages are clocked into `pins`.
    explicit SpiDevice(SerialPins& pins) : pins_(pins) {}
    /// Makes the device file, and the module's bufsiz in /sys.
    void attach(Kernel& kernel, const std::string& path);

    // --- the controller of the bus
    std::size_t bufsiz = 4096;        ///< of the module; before attach()
    std::size_t alignment = 128;      ///< of each transfer inside bufsiz (arm64)
    bool nine_bit_words = true;       ///< else bytes only, as a Raspberry Pi
    std::uint32_t max_hz = 125000000; ///< faster is slowed down to this
    std::uint32_t min_hz = 1;         ///< slower is refused
    Time message_ns = 10000;          ///< what a message costs beyond its bits

    struct Settings {
        std::uint32_t mode = 0, hz = 0;
        std::uint8_t bits = 8;
    };
    const Settings& settings() const { return settings_; }
    std::uint64_t messages() const { return messages_; }
    std::size_t largest_message() const { return largest_; }

    std::unique_ptr<OpenFile> open() override;
    int gone_error() const override;

  private:
    friend class SpiFile;
    SerialPins& pins_;
    Kernel* kernel_ = nullptr;
    Settings settings_;
    std::uint64_t messages_ = 0;
    std::size_t largest_ = 0;
};

} // namespace spangle::sim

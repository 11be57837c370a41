// OLED controllers on I2C behind the kernel's i2c-dev: every message begins with a control byte that says
// whether commands or data follow (SSD1306 datasheet, 8.1.5.2).
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/linux/transfer_bus.hpp>

namespace spangle::hal {

/// Says which adapter and address to use. Names that it points to must outlive the bus.
struct I2cConfig {
    /// The adapter's device file.
    const char* device = "/dev/i2c-1";
    std::uint8_t address = 0x3C;     ///< address of seven bits, 3Ch or 3Dh
    std::uint32_t clock_hz = 400000; ///< clock of the adapter, which the system sets; only deadlines use it
    std::uint16_t message_bytes = 1024; ///< the longest message, control byte included; some adapters take 32
    /// Reset, backlight and TE.
    PanelPins pins;
    /// A thread carries the lists while the next frame is drawn; else submit() does.
    bool asynchronous = true;
};

/// The configuration of the bus that a board describes, on this adapter.
constexpr I2cConfig i2c_config(const Board& board, const char* device, std::uint8_t address,
                               PanelPins pins = {}) {
    I2cConfig config;
    config.device = device;
    config.address = address;
    config.clock_hz = board.write_hz;
    config.pins = pins;
    return config;
}

/// A Bus over i2c-dev. It cannot read.
class I2cBus final : public TransferBus {
  public:
    /// Opens nothing; open() does that.
    explicit I2cBus(const I2cConfig& config);
    ~I2cBus();

    /// Opens the adapter and addresses the controller. It may be called again after the adapter came back.
    /// Errors name device, operation and cause; docs/faults.md lists them.
    Result<void> open();
    BusCaps caps() const override;

  private:
    I2cConfig config_;
    int device_ = -1;
    std::vector<std::uint8_t> message_; ///< the message that is being filled, with its control byte first
    bool data_ = false;

    void close_device();
    Error failed(const char* operation, const char* cause = nullptr);
    const char* refusal(const Op& op) const override;
    Result<void> put(Byte kind, const std::uint8_t* bytes, std::size_t count) override;
    Result<void> flush() override;
    Result<void> end() override;
};

} // namespace spangle::hal

// SPI panels at a USB adapter with FTDI's MPSSE (FT232H, FT2232H, FT4232H): clocks, data, D/C, select and
// reset are one stream of bytes to the chip, so a frame is a few bulk transfers. From FTDI's AN_108 and
// AN_135.
#pragma once

#include <memory>

#include <spangle/hal/board.hpp>
#include <spangle/linux/transfer_bus.hpp>

namespace spangle::hal {

/// Pins by number: 0 to 7 are ADBUS0 to 7, 8 to 15 ACBUS0 to 7. SCK is ADBUS0, MOSI ADBUS1, MISO ADBUS2.
struct FtdiPins {
    /// The number that stands for no pin.
    static constexpr std::uint8_t none = 0xFF;
    static constexpr std::uint8_t te_pin = 5; ///< the only pin for which the chip can wait (AN_108, 3.7)

    /// The pin of CS, which selects when it is low.
    std::uint8_t select = 3;
    /// The pin of D/C.
    std::uint8_t data_command = 4;
    std::uint8_t reset = 6;     ///< pin of the reset line; none: it is not wired
    std::uint8_t backlight = 7; ///< pin of the backlight, which is lit when high; none: it is not wired
    bool te = false;            ///< the panel's TE is wired to ADBUS5
};

/// Says which adapter to use, and how its pins are wired.
struct FtdiConfig {
    /// The adapter's USB IDs; 0: any of 0403:6014, 0403:6010, 0403:6011.
    std::uint16_t vendor = 0, product = 0;
    /// The adapter's usbfs file. Null: the bus looks for an adapter. The text must outlive the bus.
    const char* device_file = nullptr;
    std::uint8_t channel = 0; ///< channel of the chip: 0 is A, and 1 is B
    /// The clock of writes in Hz; the chip takes the next one below that it can make.
    std::uint32_t write_hz = 0;
    std::uint32_t read_hz = 0; ///< 0: the panel's data output is not wired
    /// How the adapter's pins are wired.
    FtdiPins pins;
    /// A thread carries the lists while the next frame is drawn; else submit() does.
    bool asynchronous = true;
    std::uint32_t timeout_ms = 1000; ///< time that the bus waits beyond that of the bytes on the wire
};

/// The configuration of the bus that a board describes, at the first adapter that is plugged in.
constexpr FtdiConfig ftdi_config(const Board& board, FtdiPins pins = {}) {
    FtdiConfig config;
    config.write_hz = board.write_hz;
    config.read_hz = board.read_hz;
    config.pins = pins;
    return config;
}

/// A Bus over an FTDI adapter.
class FtdiBus final : public TransferBus {
  public:
    /// Looks for no device; open() does that.
    explicit FtdiBus(const FtdiConfig& config);
    ~FtdiBus();

    /// Finds the adapter and starts its engine; a kernel driver lets go of it. It may be called again after
    /// the adapter came back. Errors name device, operation and cause; docs/faults.md lists them.
    Result<void> open();
    BusCaps caps() const override;

  private:
    struct Engine;
    std::unique_ptr<Engine> engine_;
    FtdiConfig config_;

    const char* flaw() const;
    const char* refusal(const Op& op) const override;
    Result<void> begin() override;
    Result<void> put(Byte kind, const std::uint8_t* bytes, std::size_t count) override;
    Result<void> flush() override;
    Result<void> read(const Op& op) override;
    Result<void> end() override;

    bool has_te() const override { return config_.pins.te; }
    bool has_reset() const override { return config_.pins.reset != FtdiPins::none; }
    bool has_backlight() const override { return config_.pins.backlight != FtdiPins::none; }
    Result<void> set_reset(bool high) override;
    Result<void> set_backlight(bool on) override;
    Result<std::uint64_t> await_te(std::uint32_t at_most_micros) override;
};

} // namespace spangle::hal

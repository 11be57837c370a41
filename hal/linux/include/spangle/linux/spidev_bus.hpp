// SPI panels behind the kernel's spidev: 4-wire with a D/C line, or 3-wire with D/C as the first of nine
// bits.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/linux/transfer_bus.hpp>

namespace spangle::hal {

/// Says which device and lines to use. Names that it points to must outlive the bus.
struct SpidevConfig {
    /// The device file.
    const char* device = "/dev/spidev0.0";
    /// The clock of writes in Hz; the kernel may choose a slower one.
    std::uint32_t write_hz = 0;
    std::uint32_t read_hz = 0; ///< 0: the panel's data output is not wired
    std::uint8_t mode = 0;     ///< SPI mode 0 or 3
    LineRef dc;                ///< D/C; not wired: nine bits a byte (DBI-C option 1), or start bytes
    bool start_bytes = false;  ///< each message begins with 70h before an index, or 72h before values
    /// Reset, backlight and TE.
    PanelPins pins;
    /// A thread carries the lists while the next frame is drawn; else submit() does.
    bool asynchronous = true;
    /// What a command costs beyond its bytes: two D/C changes and two messages, 10 to 30 us on a Raspberry
    /// Pi.
    std::uint32_t command_cost_ns = 20000;
};

/// The configuration of the bus that a board describes, on this device.
constexpr SpidevConfig spidev_config(const Board& board, const char* device, LineRef dc, PanelPins pins) {
    SpidevConfig config;
    config.device = device;
    config.write_hz = board.write_hz;
    config.read_hz = board.read_hz;
    config.dc = dc;
    config.start_bytes = board.bus == BusKind::spi_start;
    config.pins = pins;
    return config;
}

/// A Bus over spidev.
class SpidevBus final : public TransferBus {
  public:
    /// Opens nothing; open() does that.
    explicit SpidevBus(const SpidevConfig& config);
    ~SpidevBus();

    /// Opens the device and requests the lines. It may be called again after a device came back. Errors name
    /// device, operation and cause; docs/faults.md lists them.
    Result<void> open();
    BusCaps caps() const override;
    /// The most bytes of one message, which is the kernel's `bufsiz`.
    std::size_t message_bytes() const { return stage_.size(); }

  private:
    SpidevConfig config_;
    std::uint32_t actual_hz_;
    int device_ = -1;
    Lines dc_;
    int dc_level_ = -1; ///< level of the D/C line; -1: unknown

    // Bytes that wait for their message, all with the same D/C in 4-wire mode.
    std::vector<std::uint8_t> stage_;
    std::size_t staged_ = 0;
    std::size_t longest_ = 0; ///< bytes of the longest message; with start bytes, it ends after a whole pixel
    bool staged_data_ = false;

    // 3-wire: nine bits as the kernel's 16-bit words, or eight words in nine bytes where the controller only
    // has bytes.
    bool packed_ = false;
    std::uint32_t bits_ = 0; ///< the last bits, which do not fill a byte yet
    unsigned bit_count_ = 0;

    bool has_dc() const { return config_.dc.wired(); }
    bool three_wire() const { return !has_dc() && !config_.start_bytes; }
    void close_device();
    Result<void> open_rest();
    Result<void> configure();
    Result<void> configure_word();
    Error failed(const char* operation);

    const char* refusal(const Op& op) const override;
    Result<void> put(Byte kind, const std::uint8_t* bytes, std::size_t count) override;
    Result<void> flush() override;
    Result<void> read(const Op& op) override;
    Result<void> end() override;

    Result<void> put_four_wire(bool data, const std::uint8_t* bytes, std::size_t count);
    Result<void> put_messages(bool data, const std::uint8_t* bytes, std::size_t count);
    Result<void> put_three_wire(bool data, const std::uint8_t* bytes, std::size_t count);
    void stage_word(unsigned nine_bits);
    Result<void> send(bool data, const std::uint8_t* bytes, std::size_t count);
    Result<void> set_dc(bool data);
};

} // namespace spangle::hal

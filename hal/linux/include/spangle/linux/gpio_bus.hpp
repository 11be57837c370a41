// Panels on GPIO lines alone: an 8080 bus of 8 or 16 lines, or SPI with 3 or 4 wires, clocked by system
// calls. Slow, for bring-up and small windows: two calls a cycle, so a 320x240 frame takes seconds.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/linux/transfer_bus.hpp>

namespace spangle::hal {

/// How a panel's pins are wired to GPIO lines.
enum class GpioWiring : std::uint8_t {
    serial4,    ///< serial, with a line for D/C (MIPI DBI-C option 3)
    serial3,    ///< serial, D/C is the first of nine bits (MIPI DBI-C option 1)
    parallel8,  ///< parallel, one byte a cycle (MIPI DBI-B)
    parallel16, ///< parallel: two bytes of pixels a cycle, the first on D[15:8]; commands on D[7:0]
};

/// Says which lines go to which pins. Names that it points to must outlive the bus.
struct GpioBusConfig {
    /// The number that stands for no line.
    static constexpr unsigned none = ~0u;

    /// The kind of bus.
    GpioWiring wiring = GpioWiring::parallel8;
    const char* chip = "/dev/gpiochip0"; ///< chip of all lines below; those of `pins` may be on other chips
    unsigned select = none;              ///< CS; none: CS is tied low, and the panel cannot be read
    unsigned data_command = none;        ///< D/C, which serial3 does not have
    unsigned clock = none;               ///< WR or SCK
    unsigned answer = none;              ///< RD or SDO; of serial3 any line, because answers come on SDA
    unsigned data[16] = {};              ///< D0 and up; a serial bus has SDA as its first
    /// Reset, backlight and TE.
    PanelPins pins;
    /// Cycles of WR or SCK per second, from which deadlines are computed: better too few than too many.
    /// Measured: 40 to 100 thousand pairs of calls in virtual machines.
    std::uint32_t cycles_per_second = 40000;
    /// A thread carries the lists while the next frame is drawn; else submit() does.
    bool asynchronous = true;
};

/// A Bus over GPIO lines.
class GpioBus final : public TransferBus {
  public:
    /// Opens nothing; open() does that.
    explicit GpioBus(const GpioBusConfig& config);
    ~GpioBus();

    /// Requests the lines. It may be called again after a chip came back. Errors name device, operation and
    /// cause; docs/faults.md lists them.
    Result<void> open();
    BusCaps caps() const override;

  private:
    GpioBusConfig config_;
    /// Clock, D/C, CS, RD; and the data lines above them unless they must turn round.
    Lines control_;
    Lines data_;
    std::uint32_t levels_ = 0; ///< levels of `control_`
    std::uint32_t word_ = 0;   ///< word on `data_`
    bool levels_known_ = false, word_known_ = false;
    bool floating_ = false;   ///< true: the data lines are inputs
    bool rests_ = false;      ///< true: the last list ended without a fault
    unsigned upper_byte_ = 0; ///< first byte of a 16-bit word that is not complete
    bool half_word_ = false;

    bool serial() const {
        return config_.wiring == GpioWiring::serial4 || config_.wiring == GpioWiring::serial3;
    }
    bool readable() const { return config_.answer != GpioBusConfig::none; }
    bool turns_round() const { return readable() && config_.wiring != GpioWiring::serial4; }
    unsigned width() const;
    const char* flaw() const;
    Result<void> open_lines();

    const char* refusal(const Op& op) const override;
    Result<void> begin() override;
    Result<void> put(Byte kind, const std::uint8_t* bytes, std::size_t count) override;
    Result<void> read(const Op& op) override;
    Result<void> end() override;

    Result<void> set_control(std::uint32_t levels);
    Result<void> select(bool selected);
    Result<void> set_data_command(bool data);
    Result<void> set_data(unsigned word);
    Result<void> cycle(unsigned word);
    Result<void> put_byte(bool data, unsigned byte);
    Result<void> put_pixel_byte(unsigned byte);
    Result<void> drive_data();
    Result<void> read_answer(const Op& op);
    Result<unsigned> sample();
    Result<unsigned> read_unit();
};

} // namespace spangle::hal

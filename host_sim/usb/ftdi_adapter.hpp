// An FT232H or FT2232H on USB: FTDI's vendor requests and packets (AN_232B-04, AN_135) around the engine of
// one channel.
#pragma once

#include "host_sim/usb/mpsse_engine.hpp"
#include "host_sim/usb/usb_function.hpp"

namespace spangle::sim {

class FtdiAdapter final : public UsbFunction {
  public:
    explicit FtdiAdapter(Kernel& clock) : engine(clock) {}

    // --- what it is
    bool two_channels = false; ///< an FT2232H
    unsigned channel = 0;      ///< of the engine, where the panel hangs
    bool has_mpsse = true;     ///< else an FT232R: the mode is taken, and does nothing

    MpsseEngine engine;

    // --- what it does
    std::vector<std::uint8_t> descriptors() const override;
    bool control(const UsbSetup& setup, const std::uint8_t* out, std::vector<std::uint8_t>& in) override;
    bool bulk_out(std::uint8_t endpoint, const std::uint8_t* bytes, std::size_t count) override;
    bool bulk_in(std::uint8_t endpoint, std::size_t most, std::vector<std::uint8_t>& in) override;
    void clear_halt() override {}
    void power_cycle();
    /// The next request of this number is refused.
    void refuse(std::uint8_t request) { refused_ = request; }
    /// The next answer has a bit that is not so.
    void garble_answer() { garble_ = true; }

    /// Bytes of the stream, where a test wants to see them.
    std::vector<std::uint8_t>* log = nullptr;
    std::string violations() const { return violations_ + engine.violations(); }
    unsigned latency_ms() const { return latency_ms_; }

  private:
    enum class Mode { serial, mpsse };
    Mode mode_ = Mode::serial;
    unsigned latency_ms_ = 16;
    int refused_ = -1;
    bool garble_ = false;
    std::string violations_;

    std::uint8_t out_endpoint() const { return static_cast<std::uint8_t>(0x02 + 2 * channel); }
    std::uint8_t in_endpoint() const { return static_cast<std::uint8_t>(0x81 + 2 * channel); }
    bool vendor(const UsbSetup& setup);
};

} // namespace spangle::sim

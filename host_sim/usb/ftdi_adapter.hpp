// A model of an FT232H or FT2232H on USB: FTDI's vendor requests and packets (AN_232B-04, AN_135) around the
// MPSSE engine of one channel.
#pragma once

#include "host_sim/usb/mpsse_engine.hpp"
#include "host_sim/usb/usb_function.hpp"

namespace spangle::sim {

class FtdiAdapter final : public UsbFunction {
  public:
    explicit FtdiAdapter(Kernel& clock) : engine(clock) {}

    // --- properties of the chip
    bool two_channels = false; ///< the chip is an FT2232H
    unsigned channel = 0;      ///< channel of the engine, on which the panel hangs
    bool has_mpsse = true;     ///< false: an FT232R, which takes the mode but does nothing in it

    MpsseEngine engine;

    // --- behaviour
    std::vector<std::uint8_t> descriptors() const override;
    bool control(const UsbSetup& setup, const std::uint8_t* out, std::vector<std::uint8_t>& in) override;
    bool bulk_out(std::uint8_t endpoint, const std::uint8_t* bytes, std::size_t count) override;
    bool bulk_in(std::uint8_t endpoint, std::size_t most, std::vector<std::uint8_t>& in) override;
    void clear_halt() override {}
    void power_cycle();
    /// Makes the next request of this number fail.
    void refuse(std::uint8_t request) { refused_request_ = request; }
    /// Flips bits in the next answer.
    void garble_answer() { garbles_answer_ = true; }

    /// Receives the bytes of the stream, where a test wants to see them.
    std::vector<std::uint8_t>* log = nullptr;
    std::string violations() const { return violations_ + engine.violations(); }
    unsigned latency_ms() const { return latency_ms_; }

  private:
    enum class Mode { serial, mpsse };
    Mode mode_ = Mode::serial;
    unsigned latency_ms_ = 16;
    int refused_request_ = -1;
    bool garbles_answer_ = false;
    std::string violations_;

    std::uint8_t out_endpoint() const { return static_cast<std::uint8_t>(0x02 + 2 * channel); }
    std::uint8_t in_endpoint() const { return static_cast<std::uint8_t>(0x81 + 2 * channel); }
    bool vendor(const UsbSetup& setup);
};

} // namespace spangle::sim

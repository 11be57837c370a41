// A display that scans a picture out of memory, in virtual time. It stands for the scan-out block of a
// microcontroller's port and for the glass behind it.
#pragma once

#include <functional>

#include <spangle/hal/mapped_display.hpp>
#include <spangle/sim/image.hpp>

namespace spangle::sim {

struct ScanTiming {
    int lines = 0, blanking = 0; ///< lines of a refresh: visible ones, and blanking behind them
    std::uint32_t line_ns = 0;
};

class ScannedMemory final : public hal::ScanOut {
  public:
    ScannedMemory(int width, PixelFormat format, int stride, const ScanTiming& timing)
        : format_(format), stride_(stride), timing_(timing), glass_(width, timing.lines) {}

    /// Is called with the picture of each refresh that ended.
    std::function<void(const Image&)> on_refresh;
    std::function<void(const std::uint8_t* from, std::size_t bytes)> on_clean;
    bool stands_still = false; ///< the clock of the scan has stopped: no line is scanned any more

    /// Lets time go by. Each line is read when its time of scanning has passed.
    void advance(std::uint64_t ns);
    std::uint64_t now() const { return current_time_; }
    std::uint64_t period() const {
        return static_cast<std::uint64_t>(timing_.lines + timing_.blanking) * timing_.line_ns;
    }

    void show(const std::uint8_t* pixels) override;
    const std::uint8_t* scanned() const override { return address_; }
    std::uint32_t micros() override { return static_cast<std::uint32_t>(current_time_ / 1000); }
    void clean(const std::uint8_t* from, std::size_t bytes) override {
        if (on_clean)
            on_clean(from, bytes);
    }
    /// Sets entries of the palette, in which bytes of pixels are looked up while lines are read.
    void palette(std::int32_t first, std::int32_t count, const std::uint8_t* rgb) override;
    void sleep() override { advance(timing_.line_ns); }

  private:
    PixelFormat format_;
    int stride_;
    ScanTiming timing_;
    Image glass_;
    std::uint8_t palette_[hal::palette_size][3] = {};
    const std::uint8_t *address_ = nullptr, *next_address_ = nullptr;
    std::uint64_t current_time_ = 0, scanned_until_ = 0; ///< ns: the present; the lines before were scanned
    int scan_line_ = 0;

    void scan_line();
};

} // namespace spangle::sim

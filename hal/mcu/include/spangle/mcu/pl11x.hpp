// Arm PrimeCell PL110 and PL111: an LCD controller that reads its picture from memory. PL111 TRM (DDI 0293),
// 3.2. The colours of a pixel lie blue first unless told otherwise; RGB565 asks for the latter.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/hal/mapped_display.hpp>
#include <spangle/mcu/registers.hpp>

namespace spangle::mcu {

/// Columns, rows and clocks of a panel behind the controller.
struct LcdTiming {
    std::uint16_t width, height; ///< size in pixels; the width is a multiple of 16
    /// Clocks of synchronisation and of the porches in front and behind, and lines of the same.
    std::uint8_t h_sync, h_front, h_back, v_sync, v_front, v_back;
};

/// The block as a ScanOut. `Cache` has clean(from, bytes), `Timer` micros().
template <class Cache, class Timer> class Pl111 final : public hal::ScanOut {
  public:
    /// `frame_bytes`: size of one buffer; buffers lie where the controller can read.
    constexpr Pl111(std::uintptr_t base, std::uint32_t frame_bytes, Cache cache, Timer timer)
        : base_(base), frame_bytes_(frame_bytes), cache_(cache), timer_(timer) {}

    /// Sets up 16 bits a pixel, 5:6:5. The panel stays dark until the first show().
    void start(const LcdTiming& t) const {
        constexpr std::uint32_t tft_pads = 1u << 26; // BCD: the panel gets the block's own clock
        reg(base_ + timing0) = std::uint32_t{t.h_back} << 24 | std::uint32_t{t.h_front} << 16 |
                               std::uint32_t{t.h_sync} << 8 | (t.width / 16u - 1) << 2;
        reg(base_ + timing1) = std::uint32_t{t.v_back} << 24 | std::uint32_t{t.v_front} << 16 |
                               std::uint32_t{t.v_sync} << 10 | (t.height - 1u);
        reg(base_ + timing2) = tft_pads | (t.width - 1u) << 16;
        reg(base_ + interrupts) = 0;
    }

    void show(const std::uint8_t* pixels) override {
        constexpr std::uint32_t enable = 1u << 0, bits_565 = 6u << 1, tft = 1u << 5, red_first = 1u << 8,
                                power = 1u << 11;
        reg(base_ + upper_base) = address(pixels);
        reg(base_ + control) = enable | bits_565 | tft | red_first | power;
        before_ = shown_ != nullptr ? shown_ : pixels;
        shown_ = pixels;
    }
    /// The current address register runs through the frame that is scanned. Where it is not in the frame
    /// shown last, the one before is still scanned.
    const std::uint8_t* scanned() const override {
        const std::uint32_t at = reg(base_ + upper_current), begin = address(shown_);
        return at >= begin && at - begin < frame_bytes_ ? shown_ : before_;
    }
    std::uint32_t micros() override { return timer_.micros(); }
    void clean(const std::uint8_t* from, std::size_t bytes) override { cache_.clean(from, bytes); }

  private:
    static constexpr std::uintptr_t timing0 = 0x00, timing1 = 0x04, timing2 = 0x08, upper_base = 0x10,
                                    control = 0x18, interrupts = 0x1C, upper_current = 0x2C;

    static std::uint32_t address(const std::uint8_t* p) {
        return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(p));
    }

    std::uintptr_t base_;
    std::uint32_t frame_bytes_;
    Cache cache_;
    Timer timer_;
    const std::uint8_t *shown_ = nullptr, *before_ = nullptr;
};

} // namespace spangle::mcu

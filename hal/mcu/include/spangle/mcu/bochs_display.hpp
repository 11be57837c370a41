// The display of Bochs and QEMU (`-device bochs-display`): a linear frame buffer behind PCI, set up through
// the VBE "dispi" registers. Its memory holds several frames; the picture begins where the virtual offset
// says.
#pragma once

#include <cstdint>

#include <spangle/hal/mapped_display.hpp>
#include <spangle/mcu/pci.hpp>
#include <spangle/mcu/registers.hpp>

namespace spangle::mcu {

/// The block as a ScanOut. `Timer` has micros().
template <class Timer> class BochsDisplay final : public hal::ScanOut {
  public:
    /// The addresses of its two windows in the processor's memory map.
    constexpr BochsDisplay(std::uintptr_t memory, std::uintptr_t registers, Timer timer)
        : memory_(memory), registers_(registers), timer_(timer) {}

    /// Sets up 16 bits a pixel. False: there is no such device.
    bool start(std::uintptr_t ecam, std::uint16_t width, std::uint16_t height) {
        const std::uintptr_t device = find_pci(ecam, 0x1234, 0x1111);
        if (device == 0)
            return false;
        set_pci_base(device, 0, memory_);
        set_pci_base(device, 2, registers_);
        enable_pci_memory(device);
        constexpr std::uint16_t off = 0, on_linear = 1 | 0x40;
        set(enable, off);
        set(x_resolution, width);
        set(y_resolution, height);
        set(bits_per_pixel, 16);
        set(virtual_width, width);
        set(x_offset, 0);
        set(y_offset, 0);
        set(enable, on_linear);
        row_bytes_ = width * 2u;
        return true;
    }

    /// Frames lie in the display's own memory, at whole rows.
    std::uint8_t* frame(std::uint32_t index, std::uint32_t frame_bytes) const {
        return reinterpret_cast<std::uint8_t*>(memory_ + std::uintptr_t{index} * frame_bytes);
    }

    void show(const std::uint8_t* pixels) override {
        shown_ = pixels;
        set(y_offset,
            static_cast<std::uint16_t>((reinterpret_cast<std::uintptr_t>(pixels) - memory_) / row_bytes_));
    }
    /// This display has no beam: the frame shown last is scanned at once.
    const std::uint8_t* scanned() const override { return shown_; }
    std::uint32_t micros() override { return timer_.micros(); }

  private:
    enum Index : unsigned {
        x_resolution = 1,
        y_resolution = 2,
        bits_per_pixel = 3,
        enable = 4,
        virtual_width = 6,
        x_offset = 8,
        y_offset = 9,
    };
    void set(Index index, std::uint16_t value) const {
        *reinterpret_cast<volatile std::uint16_t*>(registers_ + 0x500 + 2 * index) = value;
    }

    std::uintptr_t memory_, registers_;
    Timer timer_;
    std::uint32_t row_bytes_ = 0;
    const std::uint8_t* shown_ = nullptr;
};

} // namespace spangle::mcu

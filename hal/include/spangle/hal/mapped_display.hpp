// A display that reads its picture from memory by itself: a frame is shown by telling it another address.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/hal/display.hpp>

namespace spangle::hal {

/// The block that scans a picture out of memory, refresh after refresh (LTDC, DPI, LCDIF, an FPGA's), as a
/// board's port makes it.
class ScanOut {
  public:
    /// The block reads at this address from its next blanking on. At most one address waits: a later one
    /// takes its place.
    virtual void show(const std::uint8_t* pixels) = 0;
    /// The address that the refresh under way reads. It changes only at a blanking, to the address that
    /// waits.
    virtual const std::uint8_t* scanned() const = 0;
    virtual std::uint32_t micros() = 0; ///< microseconds, which wrap at 2^32
    /// Writes what a data cache holds of these bytes to memory. It is called before show().
    virtual void clean(const std::uint8_t*, std::size_t) {}
    /// Sets colours of a palette in hardware, red, green and blue bytes each. It is called where pixels have
    /// eight bits.
    virtual void palette(std::int32_t first, std::int32_t count, const std::uint8_t* rgb) {
        static_cast<void>(first), static_cast<void>(count), static_cast<void>(rgb);
    }
    virtual void sleep() {} ///< sleeps until an interrupt, or not at all

  protected:
    ~ScanOut() = default;
};

/// What a board says of a memory-mapped display. What it points to must outlive the display.
struct MappedConfig {
    /// The most buffers that a display takes.
    static constexpr std::uint8_t most_buffers = 3;

    /// The name that people read, in static memory.
    const char* name = "memory-mapped display";
    /// The size of the picture in pixels.
    std::int32_t width = 0, height = 0;
    /// The format that the block reads.
    PixelFormat format = PixelFormat::rgb565_le;
    std::int32_t stride = 0; ///< bytes from row to row; 0: rows without gaps
    /// Memory that the block can read. One buffer is drawn into while it is scanned. With two, frames are
    /// whole, and the next one waits for the refresh. With three it does not wait.
    std::uint8_t* buffers[most_buffers] = {};
    RowSpan* touched = nullptr; ///< memory for `height` elements; null: clean() gets whole buffers
    /// What a present does while the frame before waits for the refresh. Only with three buffers, `coalesce`
    /// shows the newer frame instead; `drop` shows the older one, and the newer one is drawn over.
    Pacing pacing = Pacing::block;
    std::uint32_t refresh_us = 100000; ///< longest time of a refresh, after which the block counts as stopped
};

/// A Display whose present is an address that a ScanOut takes.
class MappedDisplay final : public Display {
  public:
    /// `port` must outlive the display. Nothing is called before init(), which checks the description.
    MappedDisplay(ScanOut& port, const MappedConfig& config) : port_(port), config_(config) {}

    DisplayInfo info() const override;
    /// Shows black, or index 0; a palette has its initial colours, through which rgb332 looks right.
    Result<void> init() override;
    /// Returns a buffer that is not scanned; waits for the refresh where there is none.
    Result<Frame> acquire() override;
    Result<void> present() override;
    Result<void> finish() override;
    void swap_interval(std::int32_t interval) override { waits_ = interval != 0; }
    /// Takes effect at once: the block looks colours up while it scans.
    Result<void> set_palette(std::int32_t first, std::int32_t count, const std::uint8_t* rgb) override;

  private:
    std::int32_t stride() const;
    bool is_free(std::uint8_t buffer) const;
    bool take_free_buffer();
    Result<void> wait_for_scan();
    Result<void> check() const;
    void clean();
    void forget_extents();
    void begin_palette();

    ScanOut& port_;
    MappedConfig config_;
    std::uint8_t count_ = 0; ///< number of buffers
    std::uint8_t asked_ = 0; ///< the buffer that was last to be shown
    std::uint8_t back_ = 0;  ///< the buffer being drawn, where `drawing_`
    bool drawing_ = false, ready_ = false, waits_ = true;
    std::uint32_t frame_ = 0;                                        ///< number of presents that succeeded
    std::uint32_t drawn_in_[MappedConfig::most_buffers] = {0, 0, 0}; ///< last present of each buffer; 0: none
    RowExtents extents_;
};

} // namespace spangle::hal

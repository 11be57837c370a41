// Controllers of grey and colour OLED glass whose memory is written through a window of columns (15h) and
// rows (75h): SSD1327, SSD0323, SSD1351, SSD1331. The models are written from the datasheets' facts alone.
#pragma once

#include <array>

#include "host_sim/controller/oled.hpp"

namespace spangle::sim {

/// The bits of A0h with their meanings; 0: the chip has no such bit.
struct RemapBits {
    std::uint8_t vertical, columns, nibbles, order, com_reversed, com_split;
};

enum class DisplayMode : std::uint8_t { memory, all_on, all_off, inverse };

struct WindowedChip {
    OledChip chip;
    RemapBits remap;
    bool grey = false; ///< a byte and a column address hold two pixels; else A0h bits 7..6 select the depth
    bool order_set_is_rgb = false;   ///< what a set order bit means; false: blue, green, red
    std::uint8_t stream_command = 0; ///< the command that takes pixels; 0: data are pixels at any time
    std::uint8_t multiplex_command = 0xA8;
    /// What the commands A4h to A7h make the glass show.
    std::array<DisplayMode, 4> shown{DisplayMode::memory, DisplayMode::all_on, DisplayMode::all_off,
                                     DisplayMode::inverse};
    std::uint8_t offset_at_reset = 0;
    int first_com = 0; ///< COM line at which the glass begins, which drivers set by command A2h
    std::uint8_t lock_command = 0, unlock_all = 0; ///< the key that opens `locked`
    std::span<const std::uint8_t> locked{};
    std::uint8_t clear_command = 0; ///< command of the drawing engine that clears a rectangle; 0: none
};

extern const WindowedChip ssd1327, ssd0323, ssd1351, ssd1331;

class WindowedController final : public OledController {
  public:
    WindowedController(const WindowedChip& chip, const GlassMount& glass, OledBus bus);

    bool display_on() const { return is_display_on_; }
    std::uint8_t remap() const { return remap_bits_; }
    /// A cell of the memory: 0..15 on grey chips, else 16 bits as RGB565.
    unsigned value(int column, int row) const { return memory_[index(column, row)]; }

  private:
    const WindowedChip windowed_chip_;
    std::vector<std::uint16_t> memory_;
    std::uint8_t remap_bits_ = 0;
    int first_column_ = 0, last_column_ = 0, first_row_ = 0, last_row_ = 0, column_ = 0, row_ = 0;
    int start_line_ = 0, display_offset_ = 0, multiplex_ratio_ = 0;
    DisplayMode display_mode_ = DisplayMode::memory;
    bool is_display_on_ = false, is_streaming_ = false, is_scrolling_ = false, is_unlocked_ = false;
    std::array<std::uint8_t, 2> pixel_bytes_{};
    int pixel_byte_count_ = 0;
    std::uint64_t stream_pixels_ = 0; ///< column addresses written since the last command
    Time busy_until_ = 0;

    void power_on() override;
    void execute(std::uint8_t command, std::span<const std::uint8_t> parameters, Time now) override;
    void data(std::uint8_t byte, Time now) override;
    void end_data(Time now) override;
    void put(unsigned value, Time now);
    void clear(std::span<const std::uint8_t> corners, Time now);
    bool is_locked_out(std::uint8_t command) const;
    bool bit(std::uint8_t mask) const { return (remap_bits_ & mask) != 0; }
    bool two_bytes() const { return !windowed_chip_.grey && (remap_bits_ & 0xC0) != 0; }
    /// The number of column addresses.
    int address_count() const { return windowed_chip_.grey ? chip_.width / 2 : chip_.width; }
    std::uint64_t window() const;
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row * chip_.width + column);
    }
    void advance();
    Lit lit(int column, int line) const override;
    Rgb666 cell(int column, int row) const override;
};

} // namespace spangle::sim

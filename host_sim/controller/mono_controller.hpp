// Controllers of one-bit OLED glass: SSD1306, SH1106, SSD0303. A byte holds eight pixels, one above the
// other, the uppermost in bit 0; eight rows are a page. The models are written from the datasheets' facts
// alone.
#pragma once

#include "host_sim/controller/oled.hpp"

namespace spangle::sim {

struct MonoChip {
    OledChip chip;
    bool page_mode_only = false; ///< the chip lacks commands 20h, 21h, 22h
    /// The converter that lights the glass, and the bit of the command that switches it on. 0: the glass
    /// needs no converter.
    std::uint8_t pump_command = 0, pump_bit = 0;
    bool pump_at_reset = false;
};

extern const MonoChip ssd1306, sh1106, ssd0303;

class MonoController final : public OledController {
  public:
    MonoController(const MonoChip& chip, const GlassMount& glass, OledBus bus);

    bool display_on() const { return is_display_on_; }
    bool bit(int column, int row) const;

  private:
    const MonoChip mono_;
    std::vector<std::uint8_t> memory_; ///< bytes, by page, then column

    enum class Mode : std::uint8_t { horizontal, vertical, page };
    Mode mode_ = Mode::page;
    int column_ = 0, page_ = 0;
    int first_column_ = 0, last_column_ = 0, first_page_ = 0, last_page_ = 0;
    int read_modify_write_column_ = 0; ///< column at which read-modify-write (E0h) began
    bool is_read_modify_write_ = false;
    int start_line_ = 0, display_offset_ = 0, multiplex_ratio_ = 64;
    bool is_segment_remapped_ = false, is_com_reversed_ = false, is_com_alternating_ = true,
         is_entirely_on_ = false, is_inverted_ = false, is_display_on_ = false, has_charge_pump_ = false,
         is_scrolling_ = false;
    std::uint64_t stream_bytes_ = 0; ///< number of data bytes since the last command

    void power_on() override;
    void execute(std::uint8_t command, std::span<const std::uint8_t> parameters, Time now) override;
    void execute_with(std::uint8_t command, std::span<const std::uint8_t> parameters, Time now);
    void data(std::uint8_t byte, Time now) override;
    void end_data(Time now) override;
    void advance();
    int pages() const { return chip_.height / 8; }
    std::uint64_t window() const;
    Lit lit(int column, int line) const override;
    Rgb666 cell(int column, int row) const override;
};

} // namespace spangle::sim

// A MIPI DCS display controller at the level of bytes on its bus: command decoder, frame memory, scan,
// read-back, and the rules of its protocol. It is written from the datasheets' facts alone and uses nothing
// of Spangle's drivers.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "host_sim/controller/chip.hpp"
#include "host_sim/controller/controller.hpp"
#include "host_sim/controller/dcs_commands.hpp"

namespace spangle::sim {

class DcsController final : public Controller {
  public:
    DcsController(const Chip& chip, const GlassMount& glass, bool parallel);

    // --- pins of the controller
    void reset(bool low, Time now) override;
    void select(bool chip_select, Time now) override;
    void write(std::uint8_t byte, bool data, Time now, unsigned period_ns) override;
    bool answers() const override {
        return is_answering_ && (read_position_ < read_bits_.size() || reads_memory());
    }
    bool drive_bit() override;
    void read_clock(Time now, unsigned period_ns) override;
    bool te(Time now) override;

    // --- what a viewer and a test can see
    /// Scans up to `now` before it takes the picture.
    std::vector<Rgb666> glass(Time now) override;
    std::vector<Rgb666> cells() const override { return memory_; }
    MemorySize memory_size() const override { return {chip_.width, chip_.height}; }
    Time line_time() const override { return chip_.line_ns; }
    Time refresh_time() const override {
        return Time(chip_.line_ns) * Time(chip_.height + chip_.porch_lines);
    }
    /// The frame memory, in the order in which MADCTL 00h addresses it.
    const std::vector<Rgb666>& memory() const { return memory_; }
    const Chip& chip() const { return chip_; }
    int scan_line(Time now) const;
    std::uint64_t frames_scanned(Time now) const;
    bool is_awake() const { return is_awake_; }
    bool display_on() const { return is_display_on_; }
    std::uint8_t madctl() const { return madctl_; }
    /// The parameters last written to one of the maker's registers; empty after reset.
    std::vector<std::uint8_t> maker_register(std::uint8_t command) const;

    std::uint64_t pixels_written() const { return pixels_written_; }

    /// Is called at the end of each refresh with the picture that the refresh showed, in the order of the
    /// memory. Without a write in between, some of several refreshes may be left out.
    std::function<void(const std::vector<Rgb666>& shown)> watch_refreshes;

  private:
    Chip chip_;
    bool is_parallel_;
    std::vector<Rgb666> memory_,
        scanned_memory_; ///< the frame memory, and what the last scan put on the glass

    // --- registers that commands set
    bool is_awake_ = false, is_display_on_ = false, is_inverted_ = false, is_idle_ = false,
         is_partial_ = false, is_scrolling_ = false, has_te_ = false, te_with_hblank_ = false;
    std::uint8_t madctl_ = 0, colmod_ = dcs::pixel_format_18_bits;
    int te_line_ = 0;
    std::map<std::uint8_t, std::vector<std::uint8_t>> maker_registers_;
    int unlocked_keys_ = 0;
    int column_start_ = 0, column_end_ = 0, page_start_ = 0, page_end_ = 0;
    int partial_start_ = 0, partial_end_ = 0;
    int scroll_top_ = 0, scroll_height_ = 0, scroll_start_ = 0;
    /// The modes of the frame that is being scanned. Changes of a mode wait for the next frame.
    struct Modes {
        bool visible = false, partial = false, scrolling = false, idle = false;
        int partial_start = 0, partial_end = 0, scroll_start = 0;
    } frame_modes_;

    // --- decoder of commands and pixels
    bool is_selected_ = false, has_command_ = false, is_in_reset_ = false;
    std::uint8_t command_ = 0;
    std::vector<std::uint8_t> parameters_;
    std::size_t parameter_count_ = 0;
    std::array<std::uint8_t, 3> pixel_bytes_{};
    int pixel_byte_count_ = 0, column_ = 0, page_ = 0;
    std::uint64_t stream_pixels_ = 0, stream_bytes_ = 0, pixels_written_ = 0;
    bool has_torn_ = false, has_written_too_fast_ = false;
    std::vector<bool> read_bits_;
    std::size_t read_position_ = 0, read_dummy_bits_ = 0;
    std::uint64_t read_clocks_ = 0; ///< bits that the host has taken
    bool is_answering_ = false, has_read_too_fast_ = false;
    int read_column_ = 0, read_page_ = 0;

    // --- moments in virtual time, ns
    Time ready_at_ = 0, sleep_out_allowed_at_ = 0, sleep_in_allowed_at_ = 0, reset_fell_at_ = 0,
         scanned_to_ = 0, next_row_at_ = 0;

    void power_on_registers();
    void check_write_clock(Time now, unsigned period_ns);
    void begin_command(std::uint8_t command, Time now);
    void end_command(Time now);
    void end_read(Time now);
    void end_write(Time now);
    void turn_key();
    void end_maker_register(Time now);
    void parameter(std::uint8_t byte, Time now);
    void execute(Time now);
    void set_window(bool columns, Time now);
    void begin_write(bool restart, Time now);
    void pixel_byte(std::uint8_t byte, Time now);
    void put_pixel(Rgb666 color, Time now);
    void prepare_read(Time now);
    void forget_read();
    void push_read(std::initializer_list<std::uint8_t> bytes, int dummy_bits);
    void push_bytes(const std::uint8_t* bytes, std::size_t count);
    void push_pixels();
    bool writes_memory() const { return command_ == dcs::memory_write || command_ == dcs::memory_write_on; }
    bool reads_memory() const { return command_ == dcs::memory_read || command_ == dcs::memory_read_on; }
    bool locate_cell(int x, int y, int& column, int& row) const;
    enum class Format : std::uint8_t { rgb444 = 3, rgb565 = 5, rgb666 = 6 };
    Format format() const;
    std::uint64_t bytes_of(std::uint64_t pixels) const;
    bool reads_565() const { return chip_.reads_write_depth && format() == Format::rgb565; }
    Rgb666 decode_pixel(int nibble) const;
    std::uint64_t window_pixels() const;
    void scan_until(Time now);
    void begin_line(Time line);
    void scan_row(int row);
};

} // namespace spangle::sim

// A MIPI DCS display controller at the level of bytes on its bus: command decoder, frame memory, scan-out,
// read-back, and the rules of the protocol it watches. Written from the datasheets' facts alone; no driver of
// ours is known here.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <spangle/sim/violations.hpp>

#include "host_sim/controller/chip.hpp"

namespace spangle::sim {

/// The part of the frame memory that glass covers, as the module's maker glued it. Offsets count in memory
/// columns and rows.
struct GlassMount {
    int x = 0, y = 0, width = 0, height = 0;
    bool mirror_columns = false, mirror_rows = false; ///< seen from the front
    bool bgr_filter = false;                          ///< the colour filter's stripes are blue, green, red
    bool normally_inverted = false;                   ///< IPS: the glass shows the complement unless INVON
};

/// 18-bit colour, six bits each.
struct Rgb666 {
    std::uint8_t r = 0, g = 0, b = 0;
    friend bool operator==(const Rgb666&, const Rgb666&) = default;
};

class DcsController {
  public:
    DcsController(const Chip& chip, const GlassMount& glass, bool parallel);

    // --- the pins
    void reset(bool low, Time now);
    void select(bool chip_select, Time now);
    /// One byte clocked in, `data`: D/C as sampled with its last bit; `period_ns`: of the clock that carried
    /// it.
    void write(std::uint8_t byte, bool data, Time now, unsigned period_ns);
    /// A read command is being answered: the controller drives its data line.
    bool answers() const { return answering_ && (read_at_ < read_bits_.size() || reads_memory()); }
    /// The next bit onto the line; the host then takes it with a clock of that period.
    bool drive_bit();
    void read_clock(Time now, unsigned period_ns);
    /// Both at once; a byte is eight clocks of a serial bus, one of a parallel one.
    bool read_bit(Time now, unsigned period_ns);
    std::uint8_t read_byte(Time now, unsigned period_ns);
    bool te(Time now);

    // --- views
    /// What a person in front of the glass sees, top row first, after scanning up to `now`.
    std::vector<Rgb666> glass(Time now);
    /// The frame memory as MADCTL 00h addresses it.
    const std::vector<Rgb666>& memory() const { return memory_; }
    const GlassMount& mount() const { return glass_; }
    const Chip& chip() const { return chip_; }
    int scan_line(Time now) const;
    std::uint64_t frames_scanned(Time now) const;
    bool awake() const { return awake_; }
    bool display_on() const { return on_; }
    std::uint8_t madctl() const { return madctl_; }
    /// What was last written to one of the maker's registers; empty after reset.
    std::vector<std::uint8_t> maker_register(std::uint8_t command) const;

    const Violations& violations() const { return violations_; }
    void report(Rule rule, const std::string& text, Time at);
    void forget_violations() { violations_.clear(); }
    std::uint64_t pixels_written() const { return pixels_written_; }

  private:
    Chip chip_;
    GlassMount glass_;
    bool parallel_;
    std::vector<Rgb666> memory_, shown_; ///< frame memory; what the last scan put on the glass
    Violations violations_;

    // registers
    bool awake_ = false, on_ = false, inverted_ = false, idle_ = false, partial_ = false, scrolling_ = false,
         te_on_ = false, te_with_hblank_ = false;
    std::uint8_t madctl_ = 0, colmod_ = 0x66;
    int te_line_ = 0;
    std::map<std::uint8_t, std::vector<std::uint8_t>> makers_;
    int keys_turned_ = 0;
    int xs_ = 0, xe_ = 0, ys_ = 0, ye_ = 0;
    int partial_start_ = 0, partial_end_ = 0;
    int scroll_top_ = 0, scroll_height_ = 0, scroll_start_ = 0;
    /// The modes of the frame being scanned: changes wait for the next one.
    struct Modes {
        bool visible = false, partial = false, scrolling = false, idle = false;
        int partial_start = 0, partial_end = 0, scroll_start = 0;
    } modes_;

    // decoder
    bool selected_ = false, has_command_ = false, in_reset_ = false;
    std::uint8_t command_ = 0;
    std::vector<std::uint8_t> parameters_;
    std::size_t parameter_count_ = 0;
    std::array<std::uint8_t, 3> pixel_bytes_{};
    int pixel_fill_ = 0, x_ = 0, y_ = 0;
    std::uint64_t stream_pixels_ = 0, stream_bytes_ = 0, pixels_written_ = 0;
    bool stream_tore_ = false, write_too_fast_ = false;
    std::vector<bool> read_bits_;
    std::size_t read_at_ = 0, read_dummies_ = 0;
    std::uint64_t read_clocks_ = 0; ///< bits the host took
    bool answering_ = false, read_too_fast_ = false;
    int read_x_ = 0, read_y_ = 0;

    // time
    Time ready_at_ = 0, sleep_out_allowed_at_ = 0, sleep_in_allowed_at_ = 0, reset_fell_at_ = 0,
         scanned_to_ = 0;

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
    bool reads_memory() const { return command_ == 0x2E || command_ == 0x3E; }
    bool locate(int x, int y, int& column, int& row) const;
    enum class Format : std::uint8_t { rgb444 = 3, rgb565 = 5, rgb666 = 6 };
    Format format() const;
    std::uint64_t bytes_of(std::uint64_t pixels) const;
    bool reads_565() const { return chip_.reads_write_depth && format() == Format::rgb565; }
    Rgb666 decode(int nibble) const;
    std::uint64_t window_pixels() const;
    void scan_until(Time now);
    void scan_row(int row);
    Time frame_ns() const { return Time(chip_.line_ns) * Time(chip_.height + chip_.porch_lines); }
};

} // namespace spangle::sim

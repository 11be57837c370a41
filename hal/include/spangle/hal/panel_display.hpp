// A panel behind an op-list bus as a Display: frames are drawn in bus-owned memory in the
// [wire](docs/glossary.md#wire) format, and a present sends what differs from the panel's memory.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/hal/bus.hpp>
#include <spangle/hal/bus_buffer.hpp>
#include <spangle/hal/display.hpp>
#include <spangle/hal/op_list.hpp>
#include <spangle/hal/panel_config.hpp>
#include <spangle/hal/panel_memory.hpp>
#include <spangle/hal/readback.hpp>
#include <spangle/hal/refresh.hpp>
#include <spangle/hal/row_hash.hpp>
#include <spangle/hal/scan_order.hpp>
#include <spangle/hal/window.hpp>

namespace spangle::hal {

class FramePlan;

/// What one frame buffer holds: outside of these spans, the clear value.
struct PanelContent {
    /// One element a row of the picture.
    RowSpan* rows = nullptr;
    /// The pixel of the last clear, as RowExtents::clear_value has it.
    std::uint32_t clear_value = 0;
};

/// What became of the frames presented so far.
struct PresentCounters {
    std::uint32_t sent = 0;            ///< sent with at least one window
    std::uint32_t put_off = 0;         ///< the wire was busy: dropped, or merged with the next
    std::uint32_t led = 0, lagged = 0; ///< tear-free: started in the blanking, or behind the beam
    std::uint32_t unsafe = 0;          ///< no start is free of tears
};

/// A Display over a Bus. It remembers what the panel's memory holds, and sends what differs.
class PanelDisplay : public Display {
  public:
    /// Functions that not every display calls. Those that no display names are not linked.
    struct Parts {
        /// Checks the description and the memory.
        Result<void> (*check)(const PanelConfig&, const PanelMemory&) = nullptr;
        /// Checks who answers: check_identity().
        Result<void> (*identify)(Bus&, const PanelDesc&, ReadScratch&) = nullptr;
        Result<void> (PanelDisplay::*measure)() = nullptr; ///< measures the refresh
        void (PanelDisplay::*sync)(FramePlan&) = nullptr;  ///< makes transfers lead or lag the beam
        /// Counts the operations of a plan, for frames that are one list.
        std::size_t (PanelDisplay::*count_ops)(FramePlan&) const = nullptr;
        Result<Frame> (PanelDisplay::*acquire)() = nullptr; ///< acquires whole frames
        /// Presents whole frames.
        Result<void> (PanelDisplay::*present)() = nullptr;
        Result<void> (PanelDisplay::*show)(bool in_place) = nullptr; ///< shows frames that were put off
        /// Acquires bands.
        Result<Frame> (PanelDisplay::*acquire_band)(std::int32_t first, std::int32_t rows) = nullptr;
        /// Presents bands.
        Result<void> (PanelDisplay::*present_band)() = nullptr;
        /// Sends a band: what changed, or all of it.
        Result<void> (PanelDisplay::*send_band)() = nullptr;
    };
    /// The parts of a display whose description and memory were checked when it was compiled. `remembers`:
    /// bands are not sent whole.
    static constexpr Parts parts_of(const PanelConfig& config, bool remembers);
    /// The parts of a display that is described at run time.
    static const Parts every_part;

    /// `bus`, `parts` and what `memory` points to must outlive the display. Nothing is sent before init(),
    /// which checks the description, the memory and the bus.
    PanelDisplay(Bus& bus, const PanelConfig& config, const PanelMemory& memory,
                 const Parts& parts = every_part);

    DisplayInfo info() const override;
    /// Reset, identity, setup, a black glass, display on. May be called again, to recover a panel that lost
    /// its power.
    Result<void> init() override;
    Result<Frame> acquire() override;
    /// With two buffers, or another format on the wire, the error of a transfer is reported by the next
    /// present(), which then sends nothing.
    Result<void> present() override;

    Result<Frame> acquire_band(std::int32_t first, std::int32_t rows) override;
    /// The error of a transfer is reported as by present().
    Result<void> present_band() override;

    /// Waits until everything presented is on the panel, and sends what was put off unless something was
    /// drawn since.
    Result<void> finish() override;
    /// Does what finish() does, without waiting, before the next frame is acquired: for idle loops of
    /// programs that coalesce.
    Result<void> poll();
    void swap_interval(std::int32_t interval) override { waits_ = interval != 0; }
    /// The next present sends the pixels that show these indices, if their colours changed.
    Result<void> set_palette(std::int32_t first, std::int32_t count, const std::uint8_t* rgb) override;
    /// What became of the frames so far.
    const PresentCounters& counters() const { return counters_; }
    /// Asks the controller for its status; see read_status(). Fault::bad_argument: init() did not succeed.
    Result<PanelStatus> status();
    /// Asks for the line that the controller is scanning; see read_scanline().
    Result<std::uint16_t> scanline();
    /// Reads pixels of the panel's memory; see read_pixels().
    Result<void> read_back(const Rect& area, std::uint8_t* rgb);

    /// The placement of the buffer that is sent.
    const Placement& placement() const { return placement_; }

  private:
    /// The time that the scan-out is given to show itself, beyond two refreshes.
    static constexpr std::uint32_t grace_us = 100000;

    static Result<void> check_description(const PanelConfig& config, const PanelMemory& memory);
    Result<Frame> acquire_frame();
    Result<void> present_frame();
    Result<Frame> acquire_rows(std::int32_t first, std::int32_t rows);
    Result<void> present_rows();
    Result<void> send_changed_rows();
    Result<void> send_all_rows();
    Result<void> take_buffers();
    Result<void> reset_panel();
    Result<void> append_setup();
    Result<void> append_registers();
    Result<void> append_program(Program program);
    Result<void> append_black();
    Result<void> append_black_window(const Rect& window);

    void collect_damage();
    void collect_band_damage();
    void forget_content();
    void begin_palette();
    bool collect_palette_damage();
    Result<void> send();
    Result<void> append_windows(const Rect& area);
    Result<void> append_window(const Rect& window);
    std::size_t convert(const Rect& window);
    void widen_damage();
    Result<void> append_pixels(const std::uint8_t* data, std::uint32_t row_bytes, std::uint32_t rows);
    void append_sync(FramePlan& plan);
    Result<void> measure_refresh();
    SafeStart safe_start(FramePlan& plan) const;
    template <class Visit> void rehearse(FramePlan& plan, Visit visit) const;
    std::size_t ops_of(FramePlan& plan) const;
    std::size_t pixel_ops(const Rect& window) const;
    Result<void> send_windows(FramePlan& plan);
    void begin_send();
    Result<void> end_send();
    Result<void> read_turned(const Rect& area, std::uint8_t* rgb);
    void turn_damage();
    Result<void> show(bool in_place);
    void accept(bool in_place);
    bool put_off();
    void hold_extents();
    void restore_extents();
    void forget_extents();
    bool drawn_since() const;
    Result<void> settle();

    Result<void> make_room(std::size_t ops);
    Result<void> start();
    Result<void> complete();

    std::uint32_t wire_bits() const { return wire_info(wire_format(config_)).bits; }
    std::size_t wire_bytes(const Extent& size) const;
    static constexpr bool tear_free(const PanelConfig& c) { return c.wait_te || c.poll_line; }
    bool tear_free() const { return tear_free(config_); }
    /// Whether a frame must be one list: between two lists there is a gap of unknown length, and the first
    /// one is waited for.
    static constexpr bool one_list(const PanelConfig& c) {
        return c.buffers == 2 || c.wire.converts() || tear_free(c);
    }
    std::uint8_t canvases() const { return turns_ || config_.band != 0 ? 1 : config_.buffers; }
    /// Rows that are drawn and sent at once.
    std::int32_t sent_rows() const { return config_.band != 0 ? band_.rows : placement_.size.height; }
    BusBuffer& sent_buffer() { return config_.wire.converts() ? wire_ : buffers_[turns_ ? 1 : back_]; }
    RowSpan* sent_damage() const { return turns_ ? memory_.turned : memory_.damage; }
    std::uint32_t line_bytes(std::int32_t columns) const {
        return static_cast<std::uint32_t>(row_bytes(config_.format, columns));
    }
    std::uint32_t stride() const { return line_bytes(picture_.width); }
    std::uint32_t sent_stride() const { return line_bytes(placement_.size.width); }
    std::int32_t rows_at_once() const { return format_info(config_.format).rows; }
    Extent shared() const;
    std::uint32_t op_limit() const;

    Bus& bus_;
    PanelConfig config_;
    PanelMemory memory_;
    const Parts& parts_;
    BusCaps caps_;
    Placement placement_; ///< of the buffer that is sent
    ScanOrder scan_;
    Extent picture_;
    bool turns_ = false;
    Windows windows_;
    RowHash hash_;
    OpList ops_;
    ReadScratch scratch_{};

    BusBuffer buffers_[2];
    BusBuffer wire_;           ///< pixels that were converted to another format
    std::size_t wire_end_ = 0; ///< end of what the list under way takes from it
    PanelContent content_[2];
    RowExtents extents_;
    /// The band that is drawn or sent; of whole frames all zero.
    struct Band {
        std::int32_t first = 0, rows = 0; ///< rows of the picture
        std::uint32_t clear_value = 0;    ///< clear value of this frame's bands
        bool complete = true;             ///< the frame's last band was sent
        bool acquired = false;            ///< it may be drawn to
    } band_;
    std::uint32_t frame_ = 0;        ///< presents that succeeded
    std::uint32_t drawn_in_[2] = {}; ///< the last of them that each buffer holds; 0: none
    std::uint8_t front_ = 0;         ///< the buffer the panel shows
    std::uint8_t back_ = 0;          ///< the buffer being drawn

    std::int32_t line_ns_ = 0;   ///< a line of the panel's scan, tear-free displays only
    std::uint32_t moments_[2]{}; ///< the moments that measure_refresh() takes

    Token token_;
    std::uint32_t token_time_ = 0; ///< microseconds the running transfer should take
    bool opened_ = false;          ///< bookkeeping and buffers hold what was drawn
    bool ready_ = false;           ///< the last init() succeeded
    bool in_flight_ = false;
    bool late_ = false;    ///< the running transfer missed its deadline; its buffer may have changed since
    bool suspect_ = false; ///< what the panel holds inside `damage` is unknown
    bool behind_ = false;  ///< the other buffer, or the panel, lacks what `damage` holds
    bool owed_ = false;    ///< a frame was put off and is still to be sent; what it touched is in `held`
    bool held_cleared_ = false;
    std::uint32_t held_clear_value_ = 0;
    bool waits_ = true; ///< the swap interval is not 0
    PresentCounters counters_;
};

constexpr PanelDisplay::Parts PanelDisplay::parts_of(const PanelConfig& config, bool remembers) {
    Parts parts;
    if (config.read_back)
        parts.identify = check_identity;
    if (tear_free(config)) {
        parts.measure = &PanelDisplay::measure_refresh;
        parts.sync = &PanelDisplay::append_sync;
    }
    if (one_list(config))
        parts.count_ops = &PanelDisplay::ops_of;
    if (config.band == 0) {
        parts.acquire = &PanelDisplay::acquire_frame;
        parts.present = &PanelDisplay::present_frame;
        if (one_list(config))
            parts.show = &PanelDisplay::show;
    } else {
        parts.acquire_band = &PanelDisplay::acquire_rows;
        parts.present_band = &PanelDisplay::present_rows;
        parts.send_band = remembers ? &PanelDisplay::send_changed_rows : &PanelDisplay::send_all_rows;
    }
    return parts;
}

} // namespace spangle::hal

// A panel behind an op-list bus as a Display: frames are drawn in bus-owned memory in the
// [wire](docs/glossary.md#wire) format, and a present sends what differs from the panel's memory.
#pragma once

#include <cstdint>

#include <spangle/hal/bands.hpp>
#include <spangle/hal/bus_buffer.hpp>
#include <spangle/hal/damage_book.hpp>
#include <spangle/hal/display.hpp>
#include <spangle/hal/pacer.hpp>
#include <spangle/hal/panel_config.hpp>
#include <spangle/hal/panel_memory.hpp>
#include <spangle/hal/presenter.hpp>
#include <spangle/hal/readback.hpp>
#include <spangle/hal/transfer.hpp>

namespace spangle::hal {

/// A Display over a Bus. It remembers what the panel's memory holds, and sends what differs. It is composed
/// of parts, each with a contract of its own: Transfer, DamageBook, Bands, Pacer and Presenter. It owns the
/// buffers and decides which part acts when.
class PanelDisplay : public Display {
  public:
    /// Functions that not every display calls. Those that no display names are not linked.
    struct Parts {
        /// Checks the description and the memory.
        Result<void> (*check)(const PanelConfig&, const PanelMemory&) = nullptr;
        /// Checks which controller answers; see check_identity().
        Result<void> (*identify)(Bus&, const PanelDesc&, ReadScratch&) = nullptr;
        /// Measures the time of a refresh.
        Result<void> (*measure)(Pacer&) = nullptr;
        /// The functions that the Presenter calls.
        Presenter::Parts sending = {};
        /// Acquires whole frames.
        Result<Frame> (*acquire)(PanelDisplay&) = nullptr;
        /// Presents whole frames.
        Result<void> (*present)(PanelDisplay&) = nullptr;
        /// Shows frames that were put off.
        Result<void> (*show)(PanelDisplay&, bool in_place) = nullptr;
        /// Acquires [bands](docs/glossary.md#band).
        Result<Frame> (*acquire_band)(PanelDisplay&, std::int32_t first, std::int32_t rows) = nullptr;
        /// Presents bands.
        Result<void> (*present_band)(PanelDisplay&) = nullptr;
        /// Sends what changed in a band, or the whole band.
        Result<void> (*send_band)(PanelDisplay&) = nullptr;
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
    PanelDisplay(const PanelDisplay&) = delete;            ///< the parts of a display refer to each other
    PanelDisplay& operator=(const PanelDisplay&) = delete; ///< the parts of a display refer to each other

    DisplayInfo info() const override;
    /// Resets the panel, checks its identity, sets it up, makes the [glass](docs/glossary.md#glass) black,
    /// and turns it on. It may be called again, to recover a panel that lost its power.
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
    void swap_interval(std::int32_t interval) override { pacer_.waits(interval != 0); }
    /// The next present sends the pixels that show these indices, if their colours changed.
    Result<void> set_palette(std::int32_t first, std::int32_t count, const std::uint8_t* rgb) override;
    /// What became of the frames so far.
    const PresentCounters& counters() const { return pacer_.counters(); }
    /// Asks the controller for its status; see read_status(). Fault::bad_argument: init() did not succeed.
    Result<PanelStatus> status();
    /// Asks for the line that the controller is scanning; see read_scanline().
    Result<std::uint16_t> scanline();
    /// Reads pixels of the panel's memory; see read_pixels().
    Result<void> read_back(const Rect& area, std::uint8_t* rgb);

    /// The placement of the buffer that is sent.
    const Placement& placement() const { return layout_.placement(); }

  private:
    static Result<void> check_description(const PanelConfig& config, const PanelMemory& memory);
    Result<void> take_buffers();
    Result<void> set_up();
    Result<void> reset_panel();
    Result<void> append_registers();

    Result<Frame> acquire_frame();
    Result<void> present_frame();
    Result<void> show(bool in_place);
    Result<Frame> acquire_rows(std::int32_t first, std::int32_t rows);
    Result<void> present_rows();
    Result<void> send_changed_rows();
    Result<void> send_all_rows();
    Result<void> sent(Result<void> outcome);
    Result<void> settle();
    Result<void> read_turned(const Rect& area, std::uint8_t* rgb);

    bool in_bands() const { return layout_.config.band != 0; }
    const PanelMemory& book_memory() const { return book_.memory(); }
    BusBuffer& sent_buffer() { return buffers_[layout_.turns() ? 1 : back_]; }

    const Parts& parts_;
    PanelLayout layout_;
    Transfer transfer_;
    DamageBook book_;
    Bands bands_;
    Pacer pacer_;
    Presenter presenter_;
    ReadScratch scratch_{};

    BusBuffer buffers_[2];
    std::uint32_t frame_ = 0;        ///< number of presents that succeeded
    std::uint32_t drawn_in_[2] = {}; ///< the present that each buffer holds; 0: none
    std::uint8_t front_ = 0;         ///< number of the buffer that the panel shows
    std::uint8_t back_ = 0;          ///< number of the buffer that is drawn to
    bool opened_ = false;            ///< true: book_ and the buffers hold what was drawn
    bool ready_ = false;             ///< the last init() succeeded
};

constexpr PanelDisplay::Parts PanelDisplay::parts_of(const PanelConfig& config, bool remembers) {
    Parts parts;
    if (config.read_back)
        parts.identify = check_identity;
    if (tear_free(config))
        parts.measure = [](Pacer& pacer) { return pacer.measure(); };
    parts.sending = Presenter::parts(tear_free(config), one_list(config));
    if (config.band == 0) {
        parts.acquire = [](PanelDisplay& d) { return d.acquire_frame(); };
        parts.present = [](PanelDisplay& d) { return d.present_frame(); };
        if (one_list(config))
            parts.show = [](PanelDisplay& d, bool in_place) { return d.show(in_place); };
    } else {
        parts.acquire_band = [](PanelDisplay& d, std::int32_t first, std::int32_t rows) {
            return d.acquire_rows(first, rows);
        };
        parts.present_band = [](PanelDisplay& d) { return d.present_rows(); };
        if (remembers)
            parts.send_band = [](PanelDisplay& d) { return d.send_changed_rows(); };
        else
            parts.send_band = [](PanelDisplay& d) { return d.send_all_rows(); };
    }
    return parts;
}

} // namespace spangle::hal

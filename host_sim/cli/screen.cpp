#include "host_sim/cli/screen.hpp"

#include <fmt/format.h>

namespace spangle::cli {
namespace {

/// Changes how the board presents frames. Returns the rule that this breaks, or an empty string.
std::string present_as(const PresentOptions& options, hal::Board& board) {
    hal::PanelConfig& display = board.display;
    display.row_hash = options.row_hash || display.row_hash;
    if (options.tear_free == "te")
        display.wait_te = board.has_te = true;
    if (options.tear_free == "poll")
        display.poll_line = true;
    if (options.pacing != "block") {
        display.pacing = options.pacing == "drop" ? hal::Pacing::drop : hal::Pacing::coalesce;
        display.buffers = display.wire.converts() ? 1 : 2;
    }
    if (options.buffers != 0)
        display.buffers = static_cast<std::uint8_t>(options.buffers);
    const bool against_the_scan = hal::scan_order(*display.panel, display.orientation).turns();
    if (options.tear_free != "off" && against_the_scan && !display.wire.converts() && options.buffers != 1) {
        display.scan_order = true;
        display.buffers = 2;
    }
    const char* const rule = hal::flaw(board);
    return rule == nullptr ? "" : std::string(board.name) + ": " + rule;
}

/// The bytes of a whole frame as it travels, without commands.
std::uint64_t frame_bytes(const hal::PanelConfig& display) {
    const hal::Extent size = hal::sent_size(display);
    if (!display.wire.converts())
        return static_cast<std::uint64_t>(row_bytes(display.format, size.width)) *
               static_cast<std::uint64_t>(stored_rows(display.format, size.height));
    const auto pixels = static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
    return (pixels * hal::wire_info(display.wire.format).bits + 7) / 8;
}

/// Why the options cannot be used with a display that is not a panel of Spangle's; empty if they can.
std::string without_panel(const RunOptions& options) {
    if (options.present.any())
        return "--gud presents as its display does; leave out the options of presenting";
    return options.bands.height != 0 ? "--gud takes whole frames; leave out --band-height" : "";
}

} // namespace

std::string Screen::open_display(const RunOptions& options) {
    const std::string name = options.bus.board_name();
    const hal::Board* const known = bringup::find_board(name);
    if (known == nullptr)
        return "no board '" + name + "'; `spangle boards` lists them";
    hal::Board board = *known;
    board.display.band = options.bands.height;
    if (options.bus.gud) {
        if (std::string rule = without_panel(options); !rule.empty())
            return rule;
    } else if (std::string rule = present_as(options.present, board); !rule.empty())
        return rule;
    attachment_ = bringup::attach(options.bus, board);
    if (!attachment_.error.empty())
        return attachment_.error;
    if (attachment_.simulated != nullptr)
        display_ = &attachment_.simulated->display();
    else if (attachment_.display != nullptr)
        display_ = attachment_.display.get();
    else {
        attachment_.board.display.reset_line = attachment_.reset;
        counted_bus_.emplace(*attachment_.bus);
        real_panel_.emplace(*counted_bus_, attachment_.board.display);
        display_ = &real_panel_->display();
    }
    if (SPANGLE_EXTENTS == 0)
        display_ = &whole_frames_.emplace(*display_);
    return "";
}

std::string Screen::open(const RunOptions& options, Session& session) {
    if (options.width != 0)
        return session.open_picture(options.width, options.height, options.precision);
    const std::string problem = open_display(options);
    return problem.empty() ? session.open_display(*display_, options.precision, options.bands) : problem;
}

Screen::Counts Screen::read_counts() const {
    if (attachment_.simulated != nullptr) {
        const sim::BoardCounters c = attachment_.simulated->counters();
        return {c.bytes, c.commands, c.pixel_bytes, c.busy_ns, attachment_.simulated->now()};
    }
    return counted_bus_
               ? Counts{counted_bus_->bytes(), counted_bus_->commands(), counted_bus_->pixel_bytes(), 0, 0}
               : Counts{};
}

void Screen::start() {
    counts_before_ = read_counts();
    start_time_ = finish_time_ = Clock::now();
}

std::string Screen::finish() {
    const auto shown = display_ == nullptr ? hal::Result<void>{} : display_->finish();
    finish_time_ = Clock::now();
    return shown.ok() ? "" : shown.error().rule;
}

void Screen::describe(const RunOptions& options, const Session& session, Report& report) const {
    report.full_frame_bytes =
        static_cast<std::uint64_t>(session.width()) * static_cast<std::uint64_t>(session.height()) * 2;
    if (display_ == nullptr) {
        report.board = fmt::format("off-screen {}x{}", session.width(), session.height());
        return;
    }
    const Counts now = read_counts();
    const double seconds = static_cast<double>(now.busy_ns - counts_before_.busy_ns) * 1e-9;
    report.bus_bytes = now.bytes - counts_before_.bytes;
    report.bus_pixel_bytes = now.pixel_bytes - counts_before_.pixel_bytes;
    report.bus_commands = now.commands - counts_before_.commands;
    report.fps_at_bus_clock = seconds > 0.0 ? report.frames / seconds : 0.0;
    if (attachment_.display == nullptr)
        report.full_frame_bytes = frame_bytes(attachment_.board.display);
    report.board = attachment_.display != nullptr
                       ? fmt::format("GUD display {}x{}", session.width(), session.height())
                       : attachment_.board.name;
    if (real()) {
        report.board += " at " + attachment_.where;
        report.measured_fps =
            report.frames / std::chrono::duration<double>(finish_time_ - start_time_).count();
    }
    if (options.bands.height != 0) {
        const std::size_t record =
            options.bands.record ? static_cast<std::size_t>(options.bands.record_bytes) : 0;
        report.bands = BandMemory{hal::bus_memory(attachment_.board), session.surface_bytes() - record,
                                  session.record_peak()};
    }
    if (!options.present.any())
        return;
    report.presents = real_panel_ ? static_cast<const bringup::RealPanel&>(*real_panel_).display().counters()
                                  : attachment_.simulated->presents();
    report.virtual_fps = real() ? *report.measured_fps
                                : report.frames / (static_cast<double>(now.now - counts_before_.now) * 1e-9);
}

} // namespace spangle::cli

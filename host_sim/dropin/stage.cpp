#include "host_sim/dropin/stage.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>

#include "host_sim/dropin/options.hpp"
#include "host_sim/dropin/pictures.hpp"
#include "host_sim/dropin/recording.hpp"
#include "host_sim/output/output.hpp"

namespace spangle::dropin {

namespace {

constexpr int bad_end = 1;

/// The conversion for a board whose surface holds the bytes of its wire format.
hal::Wire wire_of(hal::WireFormat format) {
    switch (format) {
    case hal::WireFormat::rgb565:
        return hal::wires::rgb565;
    case hal::WireFormat::rgb666:
        return hal::wires::rgb666;
    case hal::WireFormat::rgb444:
        return hal::wires::rgb444;
    case hal::WireFormat::rgb332:
        return hal::wires::rgb332;
    case hal::WireFormat::grey4:
        return hal::wires::grey4;
    case hal::WireFormat::mono:
        return hal::wires::mono;
    default:
        return {};
    }
}

/// Returns the board with surfaces of eight bits a component, which a present converts to the format of
/// the panel.
hal::Board with_full_colors(hal::Board board) {
    hal::PanelConfig& display = board.display;
    if (!display.wire.converts())
        display.wire = wire_of(hal::wire_format(display));
    display.format = PixelFormat::rgba8888;
    display.buffers = 1;
    display.scan_order = false;
    return board;
}

/// The columns from the first to the last in which two rows differ; empty where none differs.
RowSpan differing(const std::uint8_t* a, const std::uint8_t* b, std::int32_t width, std::int32_t step) {
    const auto bytes = static_cast<std::size_t>(step);
    const auto differs = [&](std::int32_t x) { return std::memcmp(a + x * step, b + x * step, bytes) != 0; };
    std::int32_t first = 0, last = width;
    while (first < width && !differs(first))
        ++first;
    while (last > first && !differs(last - 1))
        --last;
    return first < last ? RowSpan{static_cast<std::int16_t>(first), static_cast<std::int16_t>(last)}
                        : RowSpan{};
}

void widen(RowSpan& span, const RowSpan& by) {
    span.begin = std::min(span.begin, by.begin);
    span.end = std::max(span.end, by.end);
}

/// Where a picture lies on a glass of another size, along one axis, in pixels. It is centred, and cut on both
/// sides if it is larger.
struct Side {
    std::int32_t from, to, length;
};
Side centered(std::int32_t picture, std::int32_t glass) {
    return {std::max((picture - glass) / 2, 0), std::max((glass - picture) / 2, 0), std::min(picture, glass)};
}

/// Copies the picture to the frame, and tells which columns of each row changed.
void copy(const sim::Image& picture, const hal::DisplayInfo& glass, const hal::Frame& to) {
    const Side across = centered(picture.width, glass.width), down = centered(picture.height, glass.height);
    const std::int32_t step = format_info(glass.format).bytes_per_pixel;
    std::vector<std::uint8_t> row(static_cast<std::size_t>(glass.width * step));
    for (std::int32_t y = 0; y < glass.height; ++y) {
        constexpr std::uint8_t black[4] = {0, 0, 0, 255};
        for (std::int32_t x = 0; x < glass.width; ++x) {
            const bool inside =
                y >= down.to && y < down.to + down.length && x >= across.to && x < across.to + across.length;
            put_pixel(glass.format,
                      inside ? picture.at(x - across.to + across.from, y - down.to + down.from) : black,
                      row.data() + x * step);
        }
        std::uint8_t* const target = to.pixels + std::ptrdiff_t{y} * to.stride;
        const RowSpan changed = to.age == 0 ? RowSpan{0, static_cast<std::int16_t>(glass.width)}
                                            : differing(row.data(), target, glass.width, step);
        std::memcpy(target, row.data(), row.size());
        if (to.extents != nullptr && to.extents->rows != nullptr && changed.begin < changed.end)
            widen(to.extents->rows[y], changed);
    }
}

[[noreturn]] void stop(const char* why) {
    std::fprintf(stderr, "spangle: %s\n", why);
    std::_Exit(bad_end);
}

} // namespace

namespace {
std::once_flag made;
Stage* the_stage = nullptr; // never freed: it lives as long as the program may draw
} // namespace

Stage& Stage::get() {
    std::call_once(made, [] { the_stage = new Stage; });
    return *the_stage;
}

void Stage::finish_if_any() {
    if (the_stage != nullptr)
        the_stage->finish();
}

Stage::Stage() {
    const Options& wish = options();
    if (wish.board == nullptr)
        return;
    hal::Board board = wish.panel_format ? *wish.board : with_full_colors(*wish.board);
    if (const char* const rule = hal::flaw(board); rule != nullptr)
        stop(rule);
    if (const std::string problem = target_.open(wish.bus, board); !problem.empty())
        stop(problem.c_str());
    const hal::DisplayInfo glass = target_.display()->info();
    glass_ = {glass.width, glass.height};
    if (!wish.panel_format)
        return;
    format_ = target_.display()->info().format;
    if (!is_copied(format_))
        stop("SPANGLE_FORMAT=panel: pixels of this panel share bytes; leave it out");
}

Stage::Size Stage::window_size() const {
    const Options& wish = options();
    return wish.width != 0 ? Size{wish.width, wish.height} : glass_;
}

void Stage::show(const hal::Frame& frame, const hal::DisplayInfo& info) {
    if (is_finished_ || !is_copied(info.format))
        return;
    if (has_board())
        send(frame, info);
    if (target_.simulated() == nullptr &&
        (has_board() || !options().shot.empty() || !options().report.empty()))
        last_picture_ = picture_of(frame, info);
    triangle_count_ += counters_.triangles;
    fragment_count_ += counters_.fragments;
    counters_.triangles = counters_.fragments = 0;
    if (++frame_count_ == options().frames) {
        finish();
        if (!options().end_by_signal)
            std::_Exit(0);
        std::raise(SIGTERM); // a program that catches SIGTERM ends by itself
    }
}

void Stage::send(const hal::Frame& frame, const hal::DisplayInfo& info) {
    hal::Display& display = *target_.display();
    const auto buffer = display.acquire();
    if (!buffer.ok())
        stop(buffer.error().rule);
    copy(picture_of(frame, info), display.info(), buffer.value());
    if (const auto shown = display.present(); !shown.ok())
        stop(shown.error().rule);
}

sim::Image Stage::picture() const {
    return target_.simulated() != nullptr ? target_.simulated()->glass() : last_picture_;
}

void Stage::finish() {
    if (is_finished_ || frame_count_ == 0)
        return;
    is_finished_ = true;
    if (has_board())
        if (const auto shown = target_.display()->finish(); !shown.ok())
            stop(shown.error().rule);
    const Options& wish = options();
    if (const std::string problem = write_recording(); !problem.empty())
        stop(problem.c_str());
    if (!wish.shot.empty())
        if (const std::string problem = sim::write_png(picture(), wish.shot); !problem.empty())
            stop(problem.c_str());
    if (!wish.report.empty())
        write_report(); // written last: whoever finds figures knows that the rest is there
    target_.close();
}

/// Writes the report that `spangle exec` reads. Each line is a figure: name, blank, value. Rules that the bus
/// broke follow, if any.
void Stage::write_report() const {
    std::string text;
    const auto number = [&text](const char* name, auto value) {
        text += std::string(name) + ' ' + std::to_string(value) + '\n';
    };
    number("frames", frame_count_);
    number("triangles", triangle_count_);
    number("fragments", fragment_count_);
    number("width", has_board() ? glass_.width : last_picture_.width);
    number("height", has_board() ? glass_.height : last_picture_.height);
    text += "picture_hash " + sim::hash(picture()) + '\n';
    if (has_board())
        text += target_.figures();
    if (const std::string problem = sim::write_file(options().report, text); !problem.empty())
        stop(problem.c_str());
}

} // namespace spangle::dropin

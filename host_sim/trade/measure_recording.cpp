#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include <spangle/boards/boards.hpp>
#include <spangle/sim/board.hpp>

#include "host_sim/trade/judge.hpp"
#include "host_sim/trade/recording.hpp"

namespace spangle::trade {

namespace {

/// Reads the next frame of a capture. Returns false, and sets `problem`, where it is missing or has another
/// size.
bool read(CaptureReader& from, int frame, const Setting& s, DrawnFrame& out, std::string& problem) {
    double time = 0;
    if (!from.next(out, time))
        problem = fmt::format("the replay ended before frame {}", frame + 1);
    else if (out.picture.width != s.width || out.picture.height != s.height)
        problem = fmt::format("frame {} is {}x{}, the first {}x{}; judge fewer frames with --frames",
                              frame + 1, out.picture.width, out.picture.height, s.width, s.height);
    return problem.empty();
}

/// Checks that the figures follow the last frame. Returns what is wrong, or an empty string.
std::string read_end(CaptureReader& from) {
    DrawnFrame none;
    double time = 0;
    return !from.next(none, time) && from.whole() ? "" : "the replay left no figures";
}

/// The columns from the first to the last in which two rows differ.
RowSpan differing(const std::uint8_t* a, const std::uint8_t* b, std::int32_t width) {
    constexpr int bytes = 2;
    const auto differs = [&](std::int32_t x) {
        return std::memcmp(a + x * bytes, b + x * bytes, bytes) != 0;
    };
    std::int32_t first = 0, last = width;
    while (first < width && !differs(first))
        ++first;
    while (last > first && !differs(last - 1))
        --last;
    return {static_cast<std::int16_t>(first), static_cast<std::int16_t>(last)};
}

/// Sends frames to a simulated ILI9341. Of each frame only those parts are sent that differ from the frame
/// before.
class Bus {
  public:
    Bus() { is_usable_ = board_.display().init().ok(); }

    void show(const DrawnPicture& picture) {
        const auto frame = board_.display().acquire();
        is_usable_ = is_usable_ && frame.ok();
        if (!is_usable_)
            return;
        const hal::Frame& to = frame.value();
        std::vector<std::uint8_t> row(2 * static_cast<std::size_t>(picture.width));
        for (std::int32_t y = 0; y < picture.height; ++y) {
            const std::uint8_t* from =
                picture.rgba.data() + 4 * std::ptrdiff_t{picture.height - 1 - y} * picture.width;
            for (std::size_t i = 0; i < row.size(); i += 2, from += 4) {
                row[i] = static_cast<std::uint8_t>((from[0] & 0xF8) | from[1] >> 5);
                row[i + 1] = static_cast<std::uint8_t>((from[1] << 3 & 0xE0) | from[2] >> 3);
            }
            std::uint8_t* const target = to.pixels + std::ptrdiff_t{y} * to.stride;
            const RowSpan changed = to.age == 0 ? RowSpan{0, static_cast<std::int16_t>(picture.width)}
                                                : differing(row.data(), target, picture.width);
            std::memcpy(target, row.data(), row.size());
            if (to.extents != nullptr && to.extents->rows != nullptr && changed.begin < changed.end) {
                RowSpan& known = to.extents->rows[y];
                known = {std::min(known.begin, changed.begin), std::max(known.end, changed.end)};
            }
        }
        is_usable_ = board_.display().present().ok();
        if (present_count_++ == 0)
            first_present_bytes_ = board_.counters().bytes;
    }
    /// The mean bytes of a frame after the first; 0 where there was only one.
    std::uint64_t bytes() const {
        return is_usable_ && present_count_ > 1
                   ? (board_.counters().bytes - first_present_bytes_) / (present_count_ - 1)
                   : 0;
    }

  private:
    sim::SimBoard board_{boards::ili9341_spi};
    bool is_usable_ = false;
    std::uint64_t present_count_ = 0, first_present_bytes_ = 0;
};

std::string measure_pictures(Recording& from, const Tier& tier, const Format& format, const Setting& s,
                             Measured& out) {
    CaptureReader ours, twin;
    std::string problem = from.capture(format.format, tier.precision, s, ours);
    if (problem.empty())
        problem = from.capture(format.format, EGL_PRECISION_DOUBLE_SPANGLE, s, twin);
    const bool on_bus = format.format == PixelFormat::rgb565_be && s.width == 320 && s.height == 240;
    Bus bus;
    DrawnFrame picture, reference;
    for (int f = 0; f < s.frames && problem.empty(); ++f) {
        if (!read(ours, f, s, picture, problem) || !read(twin, f, s, reference, problem))
            break;
        judge(picture, reference, out);
        if (on_bus)
            bus.show(picture.picture);
    }
    if (problem.empty())
        problem = read_end(ours);
    out.picture = image_of(picture.picture);
    out.reference = image_of(reference.picture);
    out.off_own = ours.end().mismatches;
    out.bus_bytes = bus.bytes();
    return problem;
}

std::string measure_against_plain(Recording& from, const Setting& s, Measured& out) {
    CaptureReader plain;
    Setting undithered = s;
    undithered.dither = false;
    std::string problem =
        from.capture(PixelFormat::rgba8888, EGL_PRECISION_DOUBLE_SPANGLE, undithered, plain);
    DrawnFrame frame;
    for (int f = 0; f < s.frames && problem.empty(); ++f)
        read(plain, f, s, frame, problem);
    if (!problem.empty())
        return problem;
    out.plain = image_of(frame.picture);
    judge_plain(out);
    return "";
}

std::string measure_stages(Recording& from, const Tier& tier, const Format& format, const Setting& s,
                           Measured& out) {
    CaptureReader shadow;
    std::string problem = from.capture(format.format, tier.shadow, s, shadow);
    DrawnFrame frame;
    for (int f = 0; f < s.frames && problem.empty(); ++f)
        read(shadow, f, s, frame, problem);
    if (problem.empty())
        problem = read_end(shadow);
    out.stages = shadow.end().stages;
    if (problem.empty() && image_of(frame.picture) != out.picture)
        problem = "the shadow draws another picture";
    return problem;
}

} // namespace

Measured measure_recording(const Program& program, const Tier& tier, const Format& format, const Setting& s) {
    Measured out;
    Recording& from = *program.recording;
    out.problem = measure_pictures(from, tier, format, s, out);
    if (out.problem.empty())
        out.problem = measure_against_plain(from, s, out);
    if (out.problem.empty())
        out.problem = measure_stages(from, tier, format, s, out);
    out.frame_bytes = static_cast<std::uint64_t>(row_bytes(format.format, s.width)) *
                      static_cast<std::uint64_t>(stored_rows(format.format, s.height));
    return out;
}

} // namespace spangle::trade

// The part of GPIO lines that does not depend on the major version of libgpiod.
#include <spangle/linux/lines.hpp>

#include <cerrno>
#include <ctime>

#include "hal/linux/line_names.hpp"
#include "hal/linux/persist.hpp"

namespace spangle::hal {
namespace {

std::int64_t monotonic_now() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * 1000000000 + now.tv_nsec;
}

/// The kernel keeps 16 events of a line; a line that has twice as many never rests.
constexpr int most_stale_edges = 32;

} // namespace

Result<void> Lines::open_outputs(const char* chip, std::span<const unsigned> offsets, std::uint32_t levels) {
    return open_checked(chip, offsets, &levels);
}

Result<void> Lines::open_inputs(const char* chip, std::span<const unsigned> offsets) {
    return open_checked(chip, offsets, nullptr);
}

Result<void> Lines::open_checked(const char* chip, std::span<const unsigned> offsets,
                                 const std::uint32_t* levels) {
    close();
    if (chip == nullptr || offsets.empty() || offsets.size() > most)
        return error_.say(Fault::bad_argument, "gpio", "request", "a chip, and 1 to 32 of its lines");
    name_lines(name_, chip, offsets);
    return open(chip, offsets, levels);
}

template <class Call> Result<void> Lines::run(const char* operation, Call call) {
    if (!opened())
        return error_.say(Fault::bad_argument, "gpio", operation, "the lines were not opened");
    if (retry_interrupted(call) < 0)
        return failed(operation);
    return {};
}

Result<void> Lines::set(std::uint32_t levels) {
    return run("set", [&] { return set_values(levels); });
}

Result<std::uint32_t> Lines::get() {
    std::uint32_t levels = 0;
    if (const auto r = run("get", [&] { return get_values(levels); }); !r)
        return r.error();
    return levels;
}

Result<void> Lines::drive(std::uint32_t levels) {
    return run("make output", [&] { return make_outputs(levels); });
}

Result<void> Lines::float_lines() {
    return run("make input", [&] { return make_inputs(); });
}

Error Lines::failed(const char* operation) {
    return error_.system(DeviceClass::gpio, name_, operation, errno);
}

Error EdgeLine::failed(const char* operation) {
    return error_.system(DeviceClass::gpio, name_, operation, errno);
}

Result<std::uint64_t> EdgeLine::next_edge(std::uint32_t timeout_micros) {
    if (!opened())
        return error_.say(Fault::bad_argument, "gpio", "wait for edge", "the line was not opened");
    std::uint64_t time = 0;
    // Edges from before this call are dropped: they would start the frame in the middle of a scan.
    for (int stale = 0; stale < most_stale_edges; ++stale) {
        const int queued = retry_interrupted([&] { return wait(0); });
        if (queued < 0)
            return failed("wait for edge");
        if (queued == 0)
            break;
        if (retry_interrupted([&] { return take(time); }) < 0)
            return failed("read edge");
    }
    const std::int64_t deadline = monotonic_now() + std::int64_t{timeout_micros} * 1000;
    std::int64_t left = std::int64_t{timeout_micros} * 1000;
    const int came = retry_interrupted([&] {
        const int answer = wait(left > 0 ? left : 0);
        left = deadline - monotonic_now();
        return answer;
    });
    if (came < 0)
        return failed("wait for edge");
    if (came == 0)
        return error_.say(Fault::timeout, name_, "wait for edge",
                          "none came in time; is the panel's TE output wired, and TEON (35h) sent?");
    if (retry_interrupted([&] { return take(time); }) < 0)
        return failed("read edge");
    return time;
}

} // namespace spangle::hal

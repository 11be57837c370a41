// Lines over libgpiod 1.x (Debian 12 has 1.6.3).
#include <spangle/linux/lines.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>

#include <gpiod.h>

#include "hal/linux/line_names.hpp"
#include "hal/linux/persist.hpp"

namespace spangle::hal {
namespace {

gpiod_chip* open_path(const char* path) {
    gpiod_chip* chip = nullptr;
    retry_interrupted([&] { return (chip = gpiod_chip_open(path)) != nullptr ? 0 : -1; });
    return chip;
}

gpiod_chip* open_label(const char* label) {
    for (int n = 0; n < most_chips; ++n) {
        char path[32];
        name_chip(path, n);
        gpiod_chip* const chip = open_path(path);
        if (chip == nullptr && errno != ENOENT)
            return nullptr; // a chip that cannot be read may have the label
        if (chip == nullptr)
            continue;
        if (std::strcmp(gpiod_chip_label(chip), label) == 0)
            return chip;
        gpiod_chip_close(chip);
    }
    errno = ENOENT;
    return nullptr;
}

gpiod_chip* open_chip(const char* chip) {
    return is_path(chip) ? open_path(chip) : open_label(chip);
}

using Values = std::array<int, Lines::most>;

Values values_of(std::uint32_t levels) {
    Values values;
    for (unsigned i = 0; i < Lines::most; ++i)
        values[i] = static_cast<int>(levels >> i & 1);
    return values;
}

/// The consumer of the first line that is taken, or null.
const char* holder(gpiod_line_bulk& bulk, unsigned count) {
    for (unsigned i = 0; i < count; ++i) {
        gpiod_line* const line = gpiod_line_bulk_get_line(&bulk, i);
        if (gpiod_line_update(line) == 0 && gpiod_line_is_used(line))
            return gpiod_line_consumer(line);
    }
    return nullptr;
}

} // namespace

struct Lines::Request {
    gpiod_chip* chip = nullptr;
    gpiod_line_bulk bulk = {};
    unsigned count = 0;

    ~Request() {
        if (count != 0)
            gpiod_line_release_bulk(&bulk);
        if (chip != nullptr)
            gpiod_chip_close(chip);
    }
};

Lines::Lines() = default;
Lines::~Lines() = default;

void Lines::close() {
    request_.reset();
}

Result<void> Lines::open(const char* chip, std::span<const unsigned> offsets, const std::uint32_t* levels) {
    auto request = std::make_unique<Request>();
    request->chip = open_chip(chip);
    if (request->chip == nullptr)
        return failed("open");
    std::array<unsigned, most> copy{}; // a copy, because libgpiod takes no const
    std::copy(offsets.begin(), offsets.end(), copy.begin());
    const auto count = static_cast<unsigned>(offsets.size());
    if (gpiod_chip_get_lines(request->chip, copy.data(), count, &request->bulk) != 0)
        return failed("find line");
    const gpiod_line_request_config config = {
        line_consumer,
        levels != nullptr ? GPIOD_LINE_REQUEST_DIRECTION_OUTPUT : GPIOD_LINE_REQUEST_DIRECTION_INPUT, 0};
    const Values values = values_of(levels != nullptr ? *levels : 0);
    if (retry_interrupted([&] { return gpiod_line_request_bulk(&request->bulk, &config, values.data()); }) !=
        0) {
        const int error = errno;
        char text[64];
        const char* const user = error == EBUSY ? holder(request->bulk, count) : nullptr;
        return error_.system(DeviceClass::gpio, name_, "request", error, in_use(text, user));
    }
    request->count = count;
    request_ = std::move(request);
    return {};
}

int Lines::set_values(std::uint32_t levels) {
    const Values values = values_of(levels);
    return gpiod_line_set_value_bulk(&request_->bulk, values.data());
}

int Lines::get_values(std::uint32_t& levels) {
    Values values{};
    const int answer = gpiod_line_get_value_bulk(&request_->bulk, values.data());
    levels = 0;
    for (unsigned i = 0; i < request_->count; ++i)
        levels |= static_cast<std::uint32_t>(values[i] & 1) << i;
    return answer;
}

int Lines::make_outputs(std::uint32_t levels) {
    const Values values = values_of(levels);
    return gpiod_line_set_direction_output_bulk(&request_->bulk, values.data());
}

int Lines::make_inputs() {
    return gpiod_line_set_direction_input_bulk(&request_->bulk);
}

struct EdgeLine::Request {
    gpiod_chip* chip = nullptr;
    gpiod_line* line = nullptr; ///< the line that was requested, or null

    ~Request() {
        if (line != nullptr)
            gpiod_line_release(line);
        if (chip != nullptr)
            gpiod_chip_close(chip);
    }
};

EdgeLine::EdgeLine() = default;
EdgeLine::~EdgeLine() = default;

void EdgeLine::close() {
    request_.reset();
}

Result<void> EdgeLine::open(const LineRef& ref) {
    close();
    const unsigned offsets[] = {ref.offset};
    name_lines(name_, ref.chip, offsets);
    auto request = std::make_unique<Request>();
    request->chip = open_chip(ref.chip);
    if (request->chip == nullptr)
        return failed("open");
    gpiod_line* const line = gpiod_chip_get_line(request->chip, ref.offset);
    if (line == nullptr)
        return failed("find line");
    const int type =
        ref.inverted ? GPIOD_LINE_REQUEST_EVENT_FALLING_EDGE : GPIOD_LINE_REQUEST_EVENT_RISING_EDGE;
    const gpiod_line_request_config config = {line_consumer, type, 0};
    if (retry_interrupted([&] { return gpiod_line_request(line, &config, 0); }) != 0) {
        const int error = errno;
        char text[64];
        const bool taken = error == EBUSY && gpiod_line_update(line) == 0 && gpiod_line_is_used(line);
        return error_.system(DeviceClass::gpio, name_, "request edges", error,
                             in_use(text, taken ? gpiod_line_consumer(line) : nullptr));
    }
    request->line = line;
    request_ = std::move(request);
    return {};
}

int EdgeLine::wait(std::int64_t nanoseconds) {
    const timespec limit{static_cast<std::time_t>(nanoseconds / 1000000000),
                         static_cast<long>(nanoseconds % 1000000000)};
    return gpiod_line_event_wait(request_->line, &limit);
}

int EdgeLine::take(std::uint64_t& time) {
    gpiod_line_event event{};
    const int answer = gpiod_line_event_read(request_->line, &event);
    time = static_cast<std::uint64_t>(event.ts.tv_sec) * 1000000000u +
           static_cast<std::uint64_t>(event.ts.tv_nsec);
    return answer;
}

} // namespace spangle::hal

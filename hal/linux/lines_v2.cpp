// Lines over libgpiod 2.x.
#include <spangle/linux/lines.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <gpiod.h>

#include "hal/linux/line_names.hpp"
#include "hal/linux/persist.hpp"

namespace spangle::hal {
namespace {

template <auto Free> struct FreeDeleter {
    template <class T> void operator()(T* object) const { Free(object); }
};
using Chip = std::unique_ptr<gpiod_chip, FreeDeleter<gpiod_chip_close>>;
using ChipInfo = std::unique_ptr<gpiod_chip_info, FreeDeleter<gpiod_chip_info_free>>;
using LineInfo = std::unique_ptr<gpiod_line_info, FreeDeleter<gpiod_line_info_free>>;
using Settings = std::unique_ptr<gpiod_line_settings, FreeDeleter<gpiod_line_settings_free>>;
using LineConfig = std::unique_ptr<gpiod_line_config, FreeDeleter<gpiod_line_config_free>>;
using RequestConfig = std::unique_ptr<gpiod_request_config, FreeDeleter<gpiod_request_config_free>>;
using LineRequest = std::unique_ptr<gpiod_line_request, FreeDeleter<gpiod_line_request_release>>;
using Events = std::unique_ptr<gpiod_edge_event_buffer, FreeDeleter<gpiod_edge_event_buffer_free>>;
using Values = std::array<gpiod_line_value, Lines::most>;

Chip open_path(const char* path) {
    Chip chip;
    retry_interrupted([&] {
        chip.reset(gpiod_chip_open(path));
        return chip ? 0 : -1;
    });
    return chip;
}

Chip open_label(const char* label) {
    for (int n = 0; n < most_chips; ++n) {
        char path[32];
        name_chip(path, n);
        Chip chip = open_path(path);
        if (!chip && errno != ENOENT)
            return nullptr; // a chip that cannot be read may have the label
        if (!chip)
            continue;
        const ChipInfo info(gpiod_chip_get_info(chip.get()));
        if (info && std::strcmp(gpiod_chip_info_get_label(info.get()), label) == 0)
            return chip;
    }
    errno = ENOENT;
    return nullptr;
}

Chip open_chip(const char* chip) {
    return is_path(chip) ? open_path(chip) : open_label(chip);
}

Values values_of(std::uint32_t levels) {
    Values values;
    for (unsigned i = 0; i < Lines::most; ++i)
        values[i] = (levels >> i & 1) != 0 ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
    return values;
}

enum class Use { input, output, rising_edges, falling_edges };

/// Makes the configuration of lines. Null: there is no memory, or libgpiod refuses it; errno says which.
LineConfig configure(std::span<const unsigned> offsets, Use use, std::uint32_t levels) {
    const Settings settings(gpiod_line_settings_new());
    LineConfig config(gpiod_line_config_new());
    if (!settings || !config)
        return nullptr;
    gpiod_line_settings_set_direction(settings.get(), use == Use::output ? GPIOD_LINE_DIRECTION_OUTPUT
                                                                         : GPIOD_LINE_DIRECTION_INPUT);
    if (use == Use::rising_edges || use == Use::falling_edges)
        gpiod_line_settings_set_edge_detection(
            settings.get(), use == Use::rising_edges ? GPIOD_LINE_EDGE_RISING : GPIOD_LINE_EDGE_FALLING);
    if (gpiod_line_config_add_line_settings(config.get(), offsets.data(), offsets.size(), settings.get()) !=
        0)
        return nullptr;
    const Values values = values_of(levels);
    if (use == Use::output &&
        gpiod_line_config_set_output_values(config.get(), values.data(), offsets.size()) != 0)
        return nullptr;
    return config;
}

LineRequest request_lines(gpiod_chip* chip, gpiod_line_config* lines) {
    const RequestConfig config(gpiod_request_config_new());
    if (!config || lines == nullptr)
        return nullptr;
    gpiod_request_config_set_consumer(config.get(), line_consumer);
    LineRequest request;
    retry_interrupted([&] {
        request.reset(gpiod_chip_request_lines(chip, config.get(), lines));
        return request ? 0 : -1;
    });
    return request;
}

/// Why a request failed with `error`: who holds the first line that is taken, or null.
const char* cause(char (&text)[64], int error, gpiod_chip* chip, std::span<const unsigned> offsets) {
    for (std::size_t i = 0; error == EBUSY && i < offsets.size(); ++i) {
        const LineInfo info(gpiod_chip_get_line_info(chip, offsets[i]));
        if (info && gpiod_line_info_is_used(info.get()))
            return in_use(text, gpiod_line_info_get_consumer(info.get()));
    }
    return nullptr;
}

} // namespace

struct Lines::Request {
    LineRequest lines;
    std::array<unsigned, most> offsets{};
    std::size_t count = 0;

    int reconfigure(Use use, std::uint32_t levels) {
        const LineConfig config = configure({offsets.data(), count}, use, levels);
        return config ? gpiod_line_request_reconfigure_lines(lines.get(), config.get()) : -1;
    }
};

Lines::Lines() = default;
Lines::~Lines() = default;

void Lines::close() {
    request_.reset();
}

Result<void> Lines::open(const char* chip_name, std::span<const unsigned> offsets,
                         const std::uint32_t* levels) {
    const Chip chip = open_chip(chip_name);
    if (!chip)
        return failed("open");
    auto request = std::make_unique<Request>();
    request->count = offsets.size();
    std::copy(offsets.begin(), offsets.end(), request->offsets.begin());
    const LineConfig config =
        configure(offsets, levels != nullptr ? Use::output : Use::input, levels != nullptr ? *levels : 0);
    request->lines = request_lines(chip.get(), config.get());
    if (!request->lines) {
        const int error = errno;
        char text[64];
        return error_.system(DeviceClass::gpio, name_, "request", error,
                             cause(text, error, chip.get(), offsets));
    }
    request_ = std::move(request);
    return {};
}

int Lines::set_values(std::uint32_t levels) {
    const Values values = values_of(levels);
    return gpiod_line_request_set_values(request_->lines.get(), values.data());
}

int Lines::get_values(std::uint32_t& levels) {
    Values values{};
    const int answer = gpiod_line_request_get_values(request_->lines.get(), values.data());
    levels = 0;
    for (unsigned i = 0; i < request_->count; ++i)
        levels |= (values[i] == GPIOD_LINE_VALUE_ACTIVE ? 1u : 0u) << i;
    return answer;
}

int Lines::make_outputs(std::uint32_t levels) {
    return request_->reconfigure(Use::output, levels);
}

int Lines::make_inputs() {
    return request_->reconfigure(Use::input, 0);
}

struct EdgeLine::Request {
    LineRequest line;
    Events events;
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
    const Chip chip = open_chip(ref.chip);
    if (!chip)
        return failed("open");
    auto request = std::make_unique<Request>();
    const LineConfig config = configure(offsets, ref.inverted ? Use::falling_edges : Use::rising_edges, 0);
    request->line = request_lines(chip.get(), config.get());
    if (!request->line) {
        const int error = errno;
        char text[64];
        return error_.system(DeviceClass::gpio, name_, "request edges", error,
                             cause(text, error, chip.get(), offsets));
    }
    request->events.reset(gpiod_edge_event_buffer_new(1));
    if (!request->events)
        return failed("request edges");
    request_ = std::move(request);
    return {};
}

int EdgeLine::wait(std::int64_t nanoseconds) {
    return gpiod_line_request_wait_edge_events(request_->line.get(), nanoseconds);
}

int EdgeLine::take(std::uint64_t& time) {
    const int count = gpiod_line_request_read_edge_events(request_->line.get(), request_->events.get(), 1);
    if (count <= 0)
        return count;
    time = gpiod_edge_event_get_timestamp_ns(gpiod_edge_event_buffer_get_event(request_->events.get(), 0));
    return count;
}

} // namespace spangle::hal

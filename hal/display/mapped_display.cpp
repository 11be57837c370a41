#include <spangle/hal/mapped_display.hpp>

namespace spangle::hal {

std::int32_t MappedDisplay::stride() const {
    return config_.stride != 0 ? config_.stride : config_.width * format_info(config_.format).bytes_per_pixel;
}

DisplayInfo MappedDisplay::info() const {
    return {config_.name, config_.width, config_.height, config_.format, config_.buffers[1] == nullptr};
}

Result<void> MappedDisplay::check() const {
    if (!is_drawable(config_.format) || stored_rows(config_.format, 8) != 8 ||
        format_info(config_.format).bytes_per_pixel == 0)
        return Error{Fault::bad_argument,
                     "memory-mapped display: pixels of whole bytes that this build can draw"};
    if (config_.width <= 0 || config_.height <= 0 || config_.width > INT16_MAX || config_.height > INT16_MAX)
        return Error{Fault::bad_argument, "memory-mapped display: a size of 1 to 32767 pixels each way"};
    if (stride() < config_.width * format_info(config_.format).bytes_per_pixel)
        return Error{Fault::bad_argument, "memory-mapped display: a stride shorter than a row"};
    if (config_.buffers[0] == nullptr || (config_.buffers[1] == nullptr && config_.buffers[2] != nullptr))
        return Error{Fault::bad_argument,
                     "memory-mapped display: one, two or three buffers, the first first"};
    return {};
}

Result<void> MappedDisplay::init() {
    ready_ = false;
    if (const auto r = check(); !r)
        return r;
    count_ = 0;
    for (std::uint8_t* const buffer : config_.buffers)
        count_ = static_cast<std::uint8_t>(count_ + (buffer != nullptr ? 1 : 0));
    const auto bytes = static_cast<std::size_t>(stride()) * static_cast<std::size_t>(config_.height);
    for (std::uint8_t i = 0; i < count_; ++i) {
        for (std::size_t at = 0; at < bytes; ++at)
            config_.buffers[i][at] = 0;
        drawn_in_[i] = 0;
    }
    extents_ = {config_.touched, config_.touched != nullptr ? config_.height : 0, false, 0};
    forget_extents();
    begin_palette();
    port_.clean(config_.buffers[0], bytes);
    port_.show(config_.buffers[0]);
    asked_ = back_ = 0;
    drawing_ = false;
    ready_ = true;
    return {};
}

/// Sets the initial palette. Display controllers that scan out eight bits per pixel look every pixel up in
/// it.
void MappedDisplay::begin_palette() {
    if (format_info(config_.format).bits != 8 || (!is_narrow(config_.format) && !is_indexed(config_.format)))
        return;
    for (std::int32_t i = 0; i < palette_size; ++i)
        port_.palette(i, 1, initial_color(i).c);
}

Result<void> MappedDisplay::set_palette(std::int32_t first, std::int32_t count, const std::uint8_t* rgb) {
    if (!is_indexed(config_.format))
        return Error{Fault::unsupported, "memory-mapped display: its surface is not one of indices"};
    if (!in_palette(first, count))
        return Error{Fault::bad_argument, "memory-mapped display: indices of a palette are 0 to 255"};
    port_.palette(first, count, rgb);
    return {};
}

/// Whether a buffer is neither scanned out nor about to be. A free buffer stays free until it is shown.
bool MappedDisplay::is_free(std::uint8_t buffer) const {
    return buffer != asked_ && port_.scanned() != config_.buffers[buffer];
}

bool MappedDisplay::take_free_buffer() {
    for (std::uint8_t i = 0; i < count_ && !drawing_; ++i) {
        drawing_ = count_ == 1 || is_free(i);
        back_ = i;
    }
    return drawing_;
}

Result<void> MappedDisplay::wait_for_scan() {
    for (const std::uint32_t from = port_.micros(); port_.scanned() != config_.buffers[asked_]; port_.sleep())
        if (port_.micros() - from >= 2 * config_.refresh_us)
            return Error{Fault::timeout, "memory-mapped display: the scan-out does not take the next frame"};
    return {};
}

Result<Frame> MappedDisplay::acquire() {
    if (!ready_)
        return Error{Fault::bad_argument, "memory-mapped display: acquire before init succeeded"};
    if (!take_free_buffer()) {
        if (const auto r = wait_for_scan(); !r)
            return r.error();
        take_free_buffer(); // now all buffers except one are free
    }
    const std::uint32_t age = drawn_in_[back_] == 0 ? 0 : frame_ - drawn_in_[back_] + 1;
    return Frame{config_.buffers[back_], stride(), static_cast<std::int32_t>(age), &extents_};
}

Result<void> MappedDisplay::present() {
    if (!ready_)
        return Error{Fault::bad_argument, "memory-mapped display: present before init succeeded"};
    if (!drawing_)
        return {}; // nothing was acquired since the last present
    if (count_ > 1 && port_.scanned() != config_.buffers[asked_]) {
        if (waits_ && config_.pacing == Pacing::block) {
            if (const auto r = wait_for_scan(); !r)
                return r;
        } else if (config_.pacing == Pacing::drop) {
            drawn_in_[back_] = ++frame_;
            return {};
        }
    }
    clean();
    port_.show(config_.buffers[back_]);
    asked_ = back_;
    drawing_ = false;
    drawn_in_[back_] = ++frame_;
    forget_extents();
    return {};
}

Result<void> MappedDisplay::finish() {
    return ready_ ? wait_for_scan() : Result<void>{};
}

/// Cleans the cache for the rows and columns in which pixels were drawn.
void MappedDisplay::clean() {
    const std::uint8_t* const first = config_.buffers[back_];
    if (extents_.cleared || extents_.rows == nullptr) {
        port_.clean(first, static_cast<std::size_t>(stride()) * static_cast<std::size_t>(config_.height));
        return;
    }
    const std::int32_t bytes = format_info(config_.format).bytes_per_pixel;
    for (std::int32_t y = 0; y < extents_.height; ++y) {
        const RowSpan row = extents_.rows[y];
        if (row.begin < row.end)
            port_.clean(first + static_cast<std::ptrdiff_t>(y) * stride() + row.begin * bytes,
                        static_cast<std::size_t>(row.end - row.begin) * static_cast<std::size_t>(bytes));
    }
}

void MappedDisplay::forget_extents() {
    extents_.cleared = false;
    for (std::int32_t y = 0; y < extents_.height; ++y)
        extents_.rows[y] = RowSpan{};
}

} // namespace spangle::hal

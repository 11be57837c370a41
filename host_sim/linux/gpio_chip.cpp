#include "host_sim/linux/gpio_chip.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <deque>

#include <linux/gpio.h>

namespace spangle::sim {
namespace {

constexpr unsigned gpio_major = 254;

/// The interval at which input lines are sampled for edges: a tenth of the shortest pulse that counts, in ns.
constexpr Time edge_step = 15'000;
/// The events that the kernel keeps of a line nobody reads: 16 in v1, and 16 a line in v2 unless asked
/// otherwise.
constexpr std::size_t event_queue = 16;

void copy_text(char (&to)[GPIO_MAX_NAME_SIZE], const std::string& text) {
    std::snprintf(to, sizeof to, "%s", text.c_str());
}

enum class Edges { none, rising, falling };

} // namespace

/// The lines of one request: a line handle or event of v1, or a line request of v2.
class RequestFile final : public OpenFile {
  public:
    RequestFile(GpioChip& chip, std::vector<unsigned> offsets, Edges edges, bool v2)
        : chip_(chip), offsets_(std::move(offsets)), edges_(edges), is_v2_(v2),
          sampled_until_(chip.kernel_->now()),
          sampled_level_(edges == Edges::none || chip.level(offsets_[0], sampled_until_)) {}
    ~RequestFile() override {
        for (const unsigned line : offsets_)
            chip_.lines_[line].consumer.clear();
    }

    long ioctl(unsigned long request, void* argument, std::size_t) override {
        switch (request) {
        case GPIOHANDLE_SET_LINE_VALUES_IOCTL: {
            const auto& data = *static_cast<const gpiohandle_data*>(argument);
            return set(values_of(data.values), ~std::uint64_t{0});
        }
        case GPIOHANDLE_GET_LINE_VALUES_IOCTL: {
            auto& data = *static_cast<gpiohandle_data*>(argument);
            for (std::size_t i = 0; i < offsets_.size(); ++i)
                data.values[i] = get(i) ? 1 : 0;
            return 0;
        }
        case GPIOHANDLE_SET_CONFIG_IOCTL: {
            const auto& config = *static_cast<const gpiohandle_config*>(argument);
            return configure((config.flags & GPIOHANDLE_REQUEST_OUTPUT) != 0,
                             (config.flags & GPIOHANDLE_REQUEST_INPUT) != 0,
                             values_of(config.default_values));
        }
        case GPIO_V2_LINE_SET_VALUES_IOCTL: {
            const auto& data = *static_cast<const gpio_v2_line_values*>(argument);
            return set(data.bits, data.mask);
        }
        case GPIO_V2_LINE_GET_VALUES_IOCTL: {
            auto& data = *static_cast<gpio_v2_line_values*>(argument);
            data.bits = 0;
            for (std::size_t i = 0; i < offsets_.size(); ++i)
                if ((data.mask >> i & 1) != 0 && get(i))
                    data.bits |= std::uint64_t{1} << i;
            return 0;
        }
        case GPIO_V2_LINE_SET_CONFIG_IOCTL: {
            const auto& config = *static_cast<const gpio_v2_line_config*>(argument);
            return configure((config.flags & GPIO_V2_LINE_FLAG_OUTPUT) != 0,
                             (config.flags & GPIO_V2_LINE_FLAG_INPUT) != 0, values_of(config));
        }
        default:
            return -ENOTTY;
        }
    }

    Time readable(Time until) override {
        Time now = chip_.kernel_->now();
        sample_edges(now);
        while (edge_times_.empty() && now < until)
            sample_edges(now = now + edge_step < until ? now + edge_step : until);
        return edge_times_.empty() ? never : now;
    }

    long read(void* into, std::size_t count) override {
        const std::size_t size = is_v2_ ? sizeof(gpio_v2_line_event) : sizeof(gpioevent_data);
        if (edges_ == Edges::none || count < size)
            return -EINVAL;
        sample_edges(chip_.kernel_->now());
        if (edge_times_.empty())
            return -EAGAIN;
        const Time at = edge_times_.front();
        edge_times_.pop_front();
        if (is_v2_) {
            gpio_v2_line_event event{};
            event.timestamp_ns = at;
            event.id =
                edges_ == Edges::rising ? GPIO_V2_LINE_EVENT_RISING_EDGE : GPIO_V2_LINE_EVENT_FALLING_EDGE;
            event.offset = offsets_[0];
            std::memcpy(into, &event, size);
        } else {
            gpioevent_data event{};
            event.timestamp = at;
            event.id = edges_ == Edges::rising ? GPIOEVENT_EVENT_RISING_EDGE : GPIOEVENT_EVENT_FALLING_EDGE;
            std::memcpy(into, &event, size);
        }
        return static_cast<long>(size);
    }

    static std::uint64_t values_of(const gpio_v2_line_config& config) {
        for (unsigned i = 0; i < config.num_attrs; ++i)
            if (config.attrs[i].attr.id == GPIO_V2_LINE_ATTR_ID_OUTPUT_VALUES)
                return config.attrs[i].attr.values & config.attrs[i].mask;
        return 0;
    }
    template <std::size_t N> static std::uint64_t values_of(const __u8 (&values)[N]) {
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < N; ++i)
            bits |= std::uint64_t{values[i] != 0} << i;
        return bits;
    }

  private:
    GpioChip& chip_;
    std::vector<unsigned> offsets_;
    Edges edges_;
    bool is_v2_;
    Time sampled_until_;
    bool sampled_level_;
    std::deque<Time> edge_times_;

    long set(std::uint64_t values, std::uint64_t mask) {
        if (!chip_.is_output(offsets_[0]))
            return -EPERM;
        chip_.drive(offsets_, values, mask);
        return 0;
    }
    bool get(std::size_t i) { return chip_.level(offsets_[i], chip_.kernel_->now()); }
    long configure(bool output, bool input, std::uint64_t values) {
        if (output == input)
            return -EINVAL;
        chip_.set_direction(offsets_, output);
        if (output)
            chip_.drive(offsets_, values, ~std::uint64_t{0});
        return 0;
    }

    /// Records the edges up to `now`, of the last second at most.
    void sample_edges(Time now) {
        if (edges_ == Edges::none)
            return;
        const Time since = now - sampled_until_ > 1'000'000'000 ? now - 1'000'000'000 : sampled_until_;
        for (Time at = since; at < now;) {
            at = at + edge_step < now ? at + edge_step : now;
            const bool level = chip_.level(offsets_[0], at);
            if (level != sampled_level_ && level == (edges_ == Edges::rising) &&
                edge_times_.size() < event_queue)
                edge_times_.push_back(at);
            sampled_level_ = level;
        }
        sampled_until_ = now;
    }
};

/// The open chip, which tells what it is and takes requests of lines.
class ChipFile final : public OpenFile {
  public:
    explicit ChipFile(GpioChip& chip) : chip_(chip) {}

    long ioctl(unsigned long request, void* argument, std::size_t) override {
        switch (request) {
        case GPIO_GET_CHIPINFO_IOCTL: {
            auto& info = *static_cast<gpiochip_info*>(argument);
            info = {};
            copy_text(info.name, chip_.name_);
            copy_text(info.label, chip_.label_);
            info.lines = chip_.line_count_;
            return 0;
        }
        case GPIO_GET_LINEINFO_IOCTL: {
            auto& info = *static_cast<gpioline_info*>(argument);
            const unsigned offset = info.line_offset;
            if (offset >= chip_.line_count_)
                return -EINVAL;
            info = {};
            info.line_offset = offset;
            info.flags = (chip_.is_requested(offset) ? GPIOLINE_FLAG_KERNEL : 0) |
                         (chip_.is_output(offset) ? GPIOLINE_FLAG_IS_OUT : 0);
            copy_text(info.consumer, chip_.lines_[offset].consumer);
            return 0;
        }
        case GPIO_V2_GET_LINEINFO_IOCTL: {
            auto& info = *static_cast<gpio_v2_line_info*>(argument);
            const unsigned offset = info.offset;
            if (offset >= chip_.line_count_)
                return -EINVAL;
            info = {};
            info.offset = offset;
            info.flags = (chip_.is_requested(offset) ? GPIO_V2_LINE_FLAG_USED : 0) |
                         (chip_.is_output(offset) ? GPIO_V2_LINE_FLAG_OUTPUT : GPIO_V2_LINE_FLAG_INPUT);
            copy_text(info.consumer, chip_.lines_[offset].consumer);
            return 0;
        }
        case GPIO_GET_LINEHANDLE_IOCTL: {
            auto& wanted = *static_cast<gpiohandle_request*>(argument);
            const std::vector<unsigned> offsets(wanted.lineoffsets, wanted.lineoffsets + wanted.lines);
            wanted.fd = static_cast<int>(open_request(offsets, wanted.consumer_label, Edges::none, false,
                                                      (wanted.flags & GPIOHANDLE_REQUEST_OUTPUT) != 0,
                                                      RequestFile::values_of(wanted.default_values)));
            return wanted.fd < 0 ? wanted.fd : 0;
        }
        case GPIO_GET_LINEEVENT_IOCTL: {
            auto& wanted = *static_cast<gpioevent_request*>(argument);
            const Edges edges =
                (wanted.eventflags & GPIOEVENT_REQUEST_RISING_EDGE) != 0 ? Edges::rising : Edges::falling;
            wanted.fd = static_cast<int>(
                open_request({wanted.lineoffset}, wanted.consumer_label, edges, false, false, 0));
            return wanted.fd < 0 ? wanted.fd : 0;
        }
        case GPIO_V2_GET_LINE_IOCTL: {
            auto& wanted = *static_cast<gpio_v2_line_request*>(argument);
            const std::vector<unsigned> offsets(wanted.offsets, wanted.offsets + wanted.num_lines);
            const auto flags = wanted.config.flags;
            const Edges edges = (flags & GPIO_V2_LINE_FLAG_EDGE_RISING) != 0    ? Edges::rising
                                : (flags & GPIO_V2_LINE_FLAG_EDGE_FALLING) != 0 ? Edges::falling
                                                                                : Edges::none;
            wanted.fd = static_cast<int>(open_request(offsets, wanted.consumer, edges, true,
                                                      (flags & GPIO_V2_LINE_FLAG_OUTPUT) != 0,
                                                      RequestFile::values_of(wanted.config)));
            return wanted.fd < 0 ? wanted.fd : 0;
        }
        default:
            return -ENOTTY;
        }
    }

  private:
    GpioChip& chip_;

    long open_request(const std::vector<unsigned>& offsets, const char* consumer, Edges edges, bool v2,
                      bool output, std::uint64_t values) {
        if (offsets.empty() || offsets.size() > GpioChip::most_lines)
            return -EINVAL;
        for (const unsigned line : offsets)
            if (line >= chip_.line_count_)
                return -EINVAL;
        for (const unsigned line : offsets)
            if (chip_.is_requested(line))
                return -EBUSY;
        for (const unsigned line : offsets)
            chip_.lines_[line].consumer = consumer;
        chip_.set_direction(offsets, output);
        if (output)
            chip_.drive(offsets, values, ~std::uint64_t{0});
        return chip_.kernel_->add_open_file(std::make_unique<RequestFile>(chip_, offsets, edges, v2),
                                            chip_.node());
    }
};

GpioChip::GpioChip(std::string label, unsigned lines) : label_(std::move(label)), line_count_(lines) {}

void GpioChip::attach(Kernel& kernel, unsigned number) {
    kernel_ = &kernel;
    name_ = "gpiochip" + std::to_string(number);
    const std::string id = std::to_string(gpio_major) + ":" + std::to_string(number);
    kernel.add_device(path(number), *this, gpio_major, number);
    kernel.add_link("/sys/bus/gpio/devices/" + name_, "/sys/devices/" + name_);
    kernel.add_text("/sys/bus/gpio/devices/" + name_ + "/dev", id + "\n");  // libgpiod 1.x reads this file
    kernel.add_link("/sys/dev/char/" + id + "/subsystem", "/sys/bus/gpio"); // libgpiod 2.x reads this link
}

std::string GpioChip::node() const {
    return "/dev/" + name_;
}

void GpioChip::take_line(unsigned line, const std::string& consumer) {
    lines_[line].consumer = consumer;
}

void GpioChip::vacate(unsigned line) {
    lines_[line].consumer.clear();
}

std::unique_ptr<OpenFile> GpioChip::open() {
    return std::make_unique<ChipFile>(*this);
}

int GpioChip::gone_error() const {
    return ENODEV;
}

std::uint64_t GpioChip::levels() const {
    return levels_ & (output_mask_ | ~pulled_down);
}

bool GpioChip::level(unsigned line, Time now) const {
    if (is_output(line) || !input)
        return (levels() >> line & 1) != 0;
    return input(line, now);
}

void GpioChip::set_direction(const std::vector<unsigned>& offsets, bool output) {
    for (const unsigned line : offsets) {
        const std::uint64_t bit = std::uint64_t{1} << line;
        output_mask_ = output ? output_mask_ | bit : output_mask_ & ~bit;
        if (!output)
            levels_ |= bit;
    }
}

void GpioChip::drive(const std::vector<unsigned>& offsets, std::uint64_t values, std::uint64_t mask) {
    const auto put = [&](std::size_t i) {
        const std::uint64_t bit = std::uint64_t{1} << offsets[i];
        if ((mask >> i & 1) != 0)
            levels_ = (values >> i & 1) != 0 ? levels_ | bit : levels_ & ~bit;
    };
    const auto tell = [&] {
        if (on_change)
            on_change(levels(), kernel_->now());
    };
    for (std::size_t n = 0; n < offsets.size(); ++n) {
        put(settling == Settling::descending ? offsets.size() - 1 - n : n);
        if (settling != Settling::together)
            tell();
    }
    if (settling == Settling::together)
        tell();
}

} // namespace spangle::sim

#include <spangle/linux/gpio_bus.hpp>

#include <array>

#include <spangle/hal/dcs.hpp>

namespace spangle::hal {
namespace {

/// Bits of the control request. CS and RD have none where they are not wired.
enum : std::uint32_t { clock_line = 1u << 0, dc_line = 1u << 1 };

bool reads_memory(std::uint8_t command) {
    return command == dcs::RAMRD || command == dcs::RAMRD + 0x10; // 2Eh and 3Eh (RAMRDC)
}

/// Which bits of the control request CS, RD and the first data line are.
struct Layout {
    std::uint32_t select = 0, read = 0;
    unsigned data_at = 0;
};

Layout layout(const GpioBusConfig& config) {
    const bool parallel = config.wiring == GpioWiring::parallel8 || config.wiring == GpioWiring::parallel16;
    unsigned next = config.wiring == GpioWiring::serial3 ? 1 : 2;
    Layout l;
    if (config.select != GpioBusConfig::none)
        l.select = 1u << next++;
    if (parallel && config.answer != GpioBusConfig::none)
        l.read = 1u << next++;
    l.data_at = next;
    return l;
}

} // namespace

GpioBus::GpioBus(const GpioBusConfig& config)
    : TransferBus(config.pins, config.asynchronous), config_(config) {}

GpioBus::~GpioBus() {
    stop();
}

unsigned GpioBus::width() const {
    return serial() ? 1 : config_.wiring == GpioWiring::parallel16 ? 16 : 8;
}

BusCaps GpioBus::caps() const {
    const bool nine_bits = config_.wiring == GpioWiring::serial3;
    BusCaps caps;
    caps.write_hz = nine_bits ? static_cast<std::uint32_t>(std::uint64_t{config_.cycles_per_second} * 8 / 9)
                              : config_.cycles_per_second;
    caps.read_hz = readable() ? config_.cycles_per_second : 0;
    caps.kind = serial() ? BusKind::spi4 : BusKind::i8080;
    caps.bits_per_cycle = static_cast<std::uint8_t>(width());
    caps.has_te = has_te();
    caps.late_us = late_us;
    return caps;
}

const char* GpioBus::flaw() const {
    if (config_.clock == GpioBusConfig::none)
        return "the clock (WR, SCK) needs a line";
    if (config_.wiring != GpioWiring::serial3 && config_.data_command == GpioBusConfig::none)
        return "D/C needs a line; without one the panel must be strapped to 3-wire";
    if (readable() && config_.select == GpioBusConfig::none)
        return "an answer ends when CS rises: reading needs CS on a line";
    if (config_.cycles_per_second == 0)
        return "without cycles_per_second there are no deadlines";
    return nullptr;
}

Result<void> GpioBus::open() {
    if (busy())
        return Error{Fault::busy, "gpio bus: open while a transfer is under way"};
    if (const char* rule = flaw())
        return error_.say(Fault::bad_argument, "gpio bus", "open", rule);
    control_.close();
    data_.close();
    const Result<void> opened = open_lines();
    if (!opened)
        control_.close();
    return opened;
}

/// Requests all lines at a high level: CS ends what may have been under way.
Result<void> GpioBus::open_lines() {
    std::array<unsigned, 4 + 16> offsets{};
    unsigned count = 0;
    const Layout l = layout(config_);
    offsets[count++] = config_.clock;
    if (config_.wiring != GpioWiring::serial3)
        offsets[count++] = config_.data_command;
    if (l.select != 0)
        offsets[count++] = config_.select;
    if (l.read != 0)
        offsets[count++] = config_.answer;
    const std::span<const unsigned> data(config_.data, width());
    for (std::size_t i = 0; i < data.size() && !turns_round(); ++i)
        offsets[count++] = data[i];
    levels_ = (1u << count) - 1;
    if (const auto r = control_.open_outputs(config_.chip, {offsets.data(), count}, levels_); !r)
        return r;
    word_ = 0;
    floating_ = rests_ = false;
    if (turns_round())
        if (const auto r = data_.open_outputs(config_.chip, data, word_); !r)
            return r;
    if (readable() && config_.wiring == GpioWiring::serial4) {
        const unsigned answer[] = {config_.answer};
        if (const auto r = data_.open_inputs(config_.chip, answer); !r)
            return r;
    }
    return open_pins();
}

const char* GpioBus::refusal(const Op& op) const {
    if (!control_.opened())
        return "gpio bus: the bus was not opened";
    const bool pixels = op.kind == Op::Kind::pixels || op.kind == Op::Kind::repeat;
    const std::uint64_t bytes = std::uint64_t{op.length} * op.rows;
    if (pixels && width() == 16 && bytes % 2 != 0)
        return "gpio bus: an odd number of pixel bytes on 16 lines";
    return nullptr;
}

// --- Lines

Result<void> GpioBus::set_control(std::uint32_t levels) {
    if (levels_known_ && levels == levels_)
        return {};
    levels_known_ = false;
    if (const auto r = control_.set(levels); !r)
        return r;
    levels_ = levels;
    levels_known_ = true;
    return {};
}

Result<void> GpioBus::select(bool selected) {
    const std::uint32_t line = layout(config_).select;
    return set_control(selected ? levels_ & ~line : levels_ | line);
}

/// Sets D/C by a call of its own, as it has a set-up time before the clock falls (8080: tAST).
Result<void> GpioBus::set_data_command(bool data) {
    return set_control(data ? levels_ | dc_line : levels_ & ~std::uint32_t{dc_line});
}

Result<void> GpioBus::set_data(unsigned word) {
    if (word_known_ && word == word_)
        return {};
    word_known_ = false;
    if (const auto r = data_.set(word); !r)
        return r;
    word_ = word;
    word_known_ = true;
    return {};
}

/// Clocks one word. Data change while the clock is low and are taken when it rises. The clock rests high: SPI
/// mode 3.
Result<void> GpioBus::cycle(unsigned word) {
    std::uint32_t low = levels_ & ~std::uint32_t{clock_line};
    if (turns_round()) {
        if (const auto r = set_data(word); !r)
            return r;
    } else {
        const unsigned at = layout(config_).data_at;
        low = (low & ((1u << at) - 1)) | word << at;
    }
    if (const auto r = set_control(low); !r)
        return r;
    return set_control(low | clock_line);
}

Result<void> GpioBus::drive_data() {
    if (!floating_)
        return {};
    if (const auto r = data_.drive(word_); !r)
        return r;
    floating_ = false;
    return {};
}

// --- Writing

/// Begins a list. After one that failed, levels of lines are unknown, and so is how many bits of a byte the
/// controller has. A rising CS makes it forget them.
Result<void> GpioBus::begin() {
    half_word_ = false;
    if (!rests_) {
        levels_known_ = word_known_ = false;
        if (const auto r = drive_data(); !r)
            return r;
        if (const auto r = select(false); !r)
            return r;
    }
    rests_ = false;
    return select(true);
}

Result<void> GpioBus::put(Byte kind, const std::uint8_t* bytes, std::size_t count) {
    const bool data = kind != Byte::command;
    const bool nine_bits = config_.wiring == GpioWiring::serial3;
    if (!nine_bits)
        if (const auto r = set_data_command(data); !r)
            return r;
    for (std::size_t i = 0; i < count; ++i) {
        const bool pair = kind == Byte::pixel && width() == 16;
        if (const auto r = pair ? put_pixel_byte(bytes[i]) : put_byte(data, bytes[i]); !r)
            return r;
    }
    return {};
}

Result<void> GpioBus::put_byte(bool data, unsigned byte) {
    if (!serial())
        return cycle(byte);
    const bool nine_bits = config_.wiring == GpioWiring::serial3;
    const unsigned word = nine_bits && data ? 0x100u | byte : byte;
    for (unsigned bit = nine_bits ? 9 : 8; bit-- != 0;)
        if (const auto r = cycle(word >> bit & 1); !r)
            return r;
    return {};
}

Result<void> GpioBus::put_pixel_byte(unsigned byte) {
    half_word_ = !half_word_;
    if (!half_word_)
        return cycle(upper_byte_ << 8 | byte);
    upper_byte_ = byte;
    return {};
}

Result<void> GpioBus::end() {
    if (const auto r = drive_data(); !r)
        return r;
    if (const auto r = select(false); !r)
        return r;
    rests_ = true;
    return {};
}

// --- Reading

/// Reads an answer. CS rises before, so that the controller counts bits anew, and after, so that it lets go
/// of the line.
Result<void> GpioBus::read(const Op& op) {
    if (const auto r = select(false); !r)
        return r;
    if (const auto r = select(true); !r)
        return r;
    if (const auto r = put(Byte::command, &op.command, 1); !r)
        return r;
    if (turns_round()) {
        if (const auto r = data_.float_lines(); !r)
            return r;
        floating_ = true;
    }
    if (const auto r = read_answer(op); !r)
        return r;
    if (const auto r = select(false); !r)
        return r;
    if (const auto r = drive_data(); !r)
        return r;
    return select(true);
}

Result<void> GpioBus::read_answer(const Op& op) {
    const unsigned dummies = serial() ? op.dummy_bits : op.dummy_bits / 8u;
    for (unsigned i = 0; i < dummies; ++i)
        if (const auto bit = sample(); !bit)
            return bit.error();
    const bool pairs = width() == 16 && reads_memory(op.command);
    for (std::uint32_t i = 0; i < op.length; ++i) {
        const Result<unsigned> unit = read_unit();
        if (!unit)
            return unit.error();
        if (pairs)
            op.into[i++] = static_cast<std::uint8_t>(unit.value() >> 8);
        if (i < op.length)
            op.into[i] = static_cast<std::uint8_t>(unit.value());
    }
    return {};
}

/// Reads a byte of a serial answer, or one cycle of a parallel one.
Result<unsigned> GpioBus::read_unit() {
    if (!serial())
        return sample();
    unsigned byte = 0;
    for (int i = 0; i < 8; ++i) {
        const Result<unsigned> bit = sample();
        if (!bit)
            return bit;
        byte = byte << 1 | bit.value();
    }
    return byte;
}

/// Samples the answer, which is valid while SCK, or RD, is low.
Result<unsigned> GpioBus::sample() {
    const std::uint32_t strobe = serial() ? std::uint32_t{clock_line} : layout(config_).read;
    if (const auto r = set_control(levels_ & ~strobe); !r)
        return r.error();
    const Result<std::uint32_t> value = data_.get();
    if (const auto r = set_control(levels_ | strobe); !r)
        return r.error();
    return value ? Result<unsigned>(static_cast<unsigned>(value.value())) : value.error();
}

} // namespace spangle::hal

#include <spangle/usb/ftdi_bus.hpp>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <initializer_list>

#include "hal/linux/answer.hpp"
#include "hal/usb/ftdi_control.hpp"
#include "hal/usb/mpsse.hpp"

namespace spangle::hal {
namespace {

using namespace mpsse;

constexpr UsbId known_ids[] = {{0x0403, 0x6014}, {0x0403, 0x6010}, {0x0403, 0x6011}};

/// Bytes of a transfer, which bounds bursts, too: those of 64 KB, the most that a command allows, are
/// reported to lose bytes.
constexpr std::size_t stage_bytes = 32768;
constexpr std::size_t burst_header = 3;

/// The time that a command costs at high speed. The stream carries levels, a burst header and a byte for the
/// command, and the same for its parameters. 12 bytes take a third of a microsecond, and the engine needs
/// some time to execute them.
constexpr std::uint32_t command_cost_ns = 500;

/// Every packet begins with two bytes of modem status (AN_135).
constexpr std::size_t status_bytes = 2;

constexpr unsigned clock_pin = 0, mosi_pin = 1, miso_pin = 2;

constexpr unsigned bit_of(std::uint8_t pin) {
    return pin == FtdiPins::none ? 0 : 1u << pin;
}

using Clock = std::chrono::steady_clock;

} // namespace

/// The stream to the chip: bytes that wait to be sent, and the levels that pins were set to.
struct FtdiBus::Engine {
    explicit Engine(const FtdiConfig& c) : config(c) {}
    ~Engine() { control.release(); }

    const FtdiConfig& config;
    UsbLink link{"FTDI adapter"};
    FtdiControl control;
    std::vector<std::uint8_t> stages[2]; ///< commands; one stage is filled while the other is sent
    unsigned filling = 0;
    std::vector<std::uint8_t> packets;
    unsigned outputs = 0, levels = 0; ///< bits of all sixteen pins
    unsigned sent_levels = 0;
    bool lit = true;      ///< true: the backlight is to be on, also after a restart
    bool in_step = false; ///< true: the chip has executed all commands

    std::vector<std::uint8_t>& stage() { return stages[filling]; }

    Result<void> open();
    Result<void> start();
    Result<void> send_stage();
    Result<void> say(std::initializer_list<std::uint8_t> bytes);
    Result<void> set_clock(std::uint32_t hz);
    Result<void> set_levels(unsigned wanted);
    Result<void> address(bool data);
    Result<void> write(const std::uint8_t* bytes, std::size_t count);
    Result<void> answer(std::uint8_t* into, std::size_t count, std::uint32_t micros);
    Result<void> wait_for_wire(std::uint32_t micros = 0);
    std::uint32_t timeout_for(std::size_t bytes) const;
};

// --- The stream

std::uint32_t FtdiBus::Engine::timeout_for(std::size_t bytes) const {
    const std::uint64_t slowest = clock_of(divisor_for(config.write_hz));
    return config.timeout_ms + static_cast<std::uint32_t>(std::uint64_t{bytes} * 8 * 1000 / slowest);
}

/// Sends the stage that was filled. The transfer of the other stage is over when this returns, so that one is
/// filled next.
Result<void> FtdiBus::Engine::send_stage() {
    if (stage().empty())
        return {};
    in_step = false;
    if (const auto r = link.push(stage().data(), stage().size(), timeout_for(2 * stage_bytes)); !r)
        return r;
    filling ^= 1;
    const auto room = link.make_room();
    stage().clear();
    return room;
}

/// Stages a command, which lies whole in one transfer.
Result<void> FtdiBus::Engine::say(std::initializer_list<std::uint8_t> bytes) {
    if (stage_bytes - stage().size() < bytes.size())
        if (const auto r = send_stage(); !r)
            return r;
    stage().insert(stage().end(), bytes);
    return {};
}

Result<void> FtdiBus::Engine::write(const std::uint8_t* bytes, std::size_t count) {
    while (count != 0) {
        if (stage_bytes - stage().size() <= burst_header)
            if (const auto r = send_stage(); !r)
                return r;
        const std::size_t taken = std::min(count, stage_bytes - stage().size() - burst_header);
        const auto last = static_cast<unsigned>(taken - 1);
        if (const auto r =
                say({WRITE_BYTES, static_cast<std::uint8_t>(last), static_cast<std::uint8_t>(last >> 8)});
            !r)
            return r;
        stage().insert(stage().end(), bytes, bytes + taken);
        bytes += taken;
        count -= taken;
    }
    return {};
}

Result<void> FtdiBus::Engine::set_clock(std::uint32_t hz) {
    const unsigned divisor = divisor_for(hz);
    return say({SET_DIVISOR, static_cast<std::uint8_t>(divisor), static_cast<std::uint8_t>(divisor >> 8)});
}

Result<void> FtdiBus::Engine::set_levels(unsigned wanted) {
    levels = wanted;
    const unsigned changed = wanted ^ sent_levels;
    sent_levels = wanted;
    if ((changed & 0xFF) != 0)
        if (const auto r =
                say({SET_LOW, static_cast<std::uint8_t>(wanted), static_cast<std::uint8_t>(outputs)});
            !r)
            return r;
    return (changed & 0xFF00) != 0 ? say({SET_HIGH, static_cast<std::uint8_t>(wanted >> 8),
                                          static_cast<std::uint8_t>(outputs >> 8)})
                                   : Result<void>{};
}

/// Selects the panel, and sets D/C for the bytes that follow.
Result<void> FtdiBus::Engine::address(bool data) {
    const unsigned dc = bit_of(config.pins.data_command), select = bit_of(config.pins.select);
    return set_levels((levels & ~(dc | select)) | (data ? dc : 0));
}

// --- Answers

Result<void> FtdiBus::Engine::answer(std::uint8_t* into, std::size_t count, std::uint32_t micros) {
    const Clock::time_point deadline =
        Clock::now() + std::chrono::milliseconds(timeout_for(count)) + std::chrono::microseconds(micros);
    packets.resize(8 * link.packet_bytes());
    while (count != 0) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
        if (left.count() <= 0)
            return link.say(Fault::timeout, "read", "the engine did not answer in time");
        const auto came =
            link.read_bulk(packets.data(), packets.size(), static_cast<std::uint32_t>(left.count()));
        if (!came)
            return came.error();
        for (std::size_t at = 0; at < came.value(); at += link.packet_bytes()) {
            const std::size_t packet = std::min(link.packet_bytes(), came.value() - at);
            const std::size_t payload = packet > status_bytes ? packet - status_bytes : 0;
            if (payload > count)
                return link.say(Fault::no_answer, "read", "the engine says more than it was asked");
            std::memcpy(into, packets.data() + at + status_bytes, payload);
            into += payload;
            count -= payload;
        }
    }
    return {};
}

/// Returns when the chip has executed everything: its pins then have the levels that were set.
Result<void> FtdiBus::Engine::wait_for_wire(std::uint32_t micros) {
    std::uint8_t pins = 0;
    if (const auto r = say({GET_LOW, SEND_IMMEDIATE}); !r)
        return r;
    if (const auto r = send_stage(); !r)
        return r;
    if (const auto r = link.settle(); !r)
        return r;
    if (const auto r = answer(&pins, 1, micros); !r)
        return r;
    if (((pins ^ levels) & outputs & 0xFF) != 0)
        return link.say(Fault::no_answer, "write",
                        "the pins are not as they were set: the engine lost its step");
    in_step = true;
    return {};
}

// --- The chip

Result<void> FtdiBus::Engine::open() {
    control.release();
    const UsbId own[] = {{config.vendor, config.product}};
    const int interface = config.channel;
    const auto opened = config.device_file != nullptr ? link.open_file(config.device_file, interface)
                        : config.vendor != 0          ? link.open(own, 1, interface)
                                                      : link.open(known_ids, std::size(known_ids), interface);
    if (!opened)
        return opened;
    if (const auto r = control.take_device(link, config.channel); !r)
        return r;
    for (auto& s : stages)
        s.reserve(stage_bytes);
    return start();
}

/// Starts the engine, also after a failure. What the chip still held is dropped, and its pins float high for
/// a moment.
Result<void> FtdiBus::Engine::start() {
    if (link.packet_bytes() <= status_bytes)
        return link.say(Fault::wrong_device, "open", "no bulk input");
    if (const auto r = control.start_mpsse(); !r)
        return r;
    const FtdiPins& pins = config.pins;
    outputs = 1u << clock_pin | 1u << mosi_pin | bit_of(pins.select) | bit_of(pins.data_command) |
              bit_of(pins.reset) | bit_of(pins.backlight);
    levels = bit_of(pins.select) | bit_of(pins.data_command) | bit_of(pins.reset) |
             (lit ? bit_of(pins.backlight) : 0);
    stage().clear();
    if (const auto r = say({BAD_COMMAND, SEND_IMMEDIATE}); !r)
        return r;
    if (const auto r = send_stage(); !r)
        return r;
    std::uint8_t echo[2] = {};
    if (const auto r = answer(echo, 2, 0); !r)
        return r;
    if (echo[0] != ECHO || echo[1] != BAD_COMMAND)
        return link.say(Fault::wrong_device, "open",
                        "no MPSSE answers: FT232H, FT2232H and FT4232H have one");
    if (const auto r = say({FULL_SPEED_BASE, ADAPTIVE_OFF, THREE_PHASE_OFF, LOOPBACK_OFF}); !r)
        return r;
    if (const auto r = set_clock(config.write_hz); !r)
        return r;
    sent_levels = ~levels; // unequal to `levels`, so that set_levels() sends all of them
    if (const auto r = set_levels(levels); !r)
        return r;
    return wait_for_wire();
}

FtdiBus::FtdiBus(const FtdiConfig& config) : TransferBus({}, config.asynchronous), config_(config) {
    engine_ = std::make_unique<Engine>(config_);
}

FtdiBus::~FtdiBus() {
    stop();
}

const char* FtdiBus::flaw() const {
    const FtdiPins& pins = config_.pins;
    unsigned taken =
        1u << clock_pin | 1u << mosi_pin | 1u << miso_pin | (pins.te ? 1u << FtdiPins::te_pin : 0u);
    for (const std::uint8_t pin : {pins.select, pins.data_command, pins.reset, pins.backlight}) {
        if (pin != FtdiPins::none && pin >= 16)
            return "ftdi: pins are 0 to 15: ADBUS0 to 7, ACBUS0 to 7";
        if ((taken & bit_of(pin)) != 0)
            return "ftdi: two signals on one pin (SCK, MOSI and MISO are ADBUS0 to 2, TE is ADBUS5)";
        taken |= bit_of(pin);
    }
    if (pins.select == FtdiPins::none || pins.data_command == FtdiPins::none)
        return "ftdi: select and D/C must be wired";
    if (config_.channel > 1)
        return "ftdi: channels A (0) and B (1) have the engine";
    return config_.write_hz == 0 ? "ftdi: no write clock" : nullptr;
}

Result<void> FtdiBus::open() {
    if (busy())
        return Error{Fault::busy, "ftdi: open while a transfer is under way"};
    if (const char* rule = flaw())
        return Error{Fault::bad_argument, rule};
    const auto opened = engine_->open();
    if (!opened) {
        engine_->control.release();
        engine_->link.close();
    }
    return opened;
}

BusCaps FtdiBus::caps() const {
    BusCaps caps;
    caps.write_hz = clock_of(divisor_for(config_.write_hz));
    caps.read_hz = config_.read_hz != 0 ? clock_of(divisor_for(config_.read_hz)) : 0;
    caps.has_te = has_te();
    caps.late_us = late_us;
    caps.command_cost_ns = command_cost_ns;
    return caps;
}

// --- Lists

const char* FtdiBus::refusal(const Op& op) const {
    if (!engine_->link.opened())
        return "ftdi: the bus was not opened";
    if (op.kind == Op::Kind::read && answer_bytes(op) > 0x10000)
        return "ftdi: a read longer than 65,536 bytes";
    return nullptr;
}

Result<void> FtdiBus::begin() {
    return engine_->in_step ? Result<void>{} : engine_->start();
}

Result<void> FtdiBus::put(Byte kind, const std::uint8_t* bytes, std::size_t count) {
    if (const auto r = engine_->address(kind != Byte::command); !r)
        return r;
    return engine_->write(bytes, count);
}

Result<void> FtdiBus::flush() {
    Engine& e = *engine_;
    if (const auto r = e.set_levels(e.levels | bit_of(config_.pins.select)); !r)
        return r;
    return e.stage().empty() && e.in_step ? Result<void>{} : e.wait_for_wire();
}

/// Reads an answer. The panel is selected from the command to the last bit of the answer. D/C stays low: the
/// controller took it with the command.
Result<void> FtdiBus::read(const Op& op) {
    Engine& e = *engine_;
    std::vector<std::uint8_t> clocked(answer_bytes(op));
    const auto last = static_cast<unsigned>(clocked.size() - 1);
    if (const auto r = e.set_clock(config_.read_hz); !r)
        return r;
    if (const auto r = e.address(false); !r)
        return r;
    if (const auto r = e.write(&op.command, 1); !r)
        return r;
    if (!clocked.empty())
        if (const auto r = e.say({READ_BYTES, static_cast<std::uint8_t>(last),
                                  static_cast<std::uint8_t>(last >> 8), SEND_IMMEDIATE});
            !r)
            return r;
    if (const auto r = e.send_stage(); !r)
        return r;
    if (const auto r = e.link.settle(); !r)
        return r;
    if (const auto r = e.answer(clocked.data(), clocked.size(), 0); !r)
        return r;
    take_answer(op, clocked);
    if (const auto r = e.set_clock(config_.write_hz); !r)
        return r;
    return flush();
}

Result<void> FtdiBus::end() {
    engine_->stage().clear();
    return {};
}

// --- Pins beside the data

Result<void> FtdiBus::set_reset(bool high) {
    Engine& e = *engine_;
    const unsigned pin = bit_of(config_.pins.reset);
    if (const auto r = e.set_levels((e.levels & ~pin) | (high ? pin : 0)); !r)
        return r;
    return flush();
}

Result<void> FtdiBus::set_backlight(bool on) {
    Engine& e = *engine_;
    if (busy())
        return Error{Fault::busy, "ftdi: backlight while a transfer is under way"};
    if (!e.link.opened())
        return Error{Fault::bad_argument, "ftdi: the bus was not opened"};
    e.lit = on;
    if (const auto r = begin(); !r)
        return r;
    const unsigned pin = bit_of(config_.pins.backlight);
    if (const auto r = e.set_levels((e.levels & ~pin) | (on ? pin : 0)); !r)
        return r;
    return flush();
}

/// The chip itself waits for low, then high: no delay of the host comes between the edge and the frame.
Result<std::uint64_t> FtdiBus::await_te(std::uint32_t at_most_micros) {
    Engine& e = *engine_;
    if (const auto r = e.say({WAIT_LOW, WAIT_HIGH}); !r)
        return r.error();
    const auto waited = e.wait_for_wire(at_most_micros);
    if (waited.error().fault == Fault::timeout)
        return e.link.say(Fault::timeout, "wait for edge",
                          "none came in time; is the panel's TE output wired, and TEON (35h) sent?");
    if (!waited)
        return waited.error();
    // The adapter delays each answer by about the same time, so the distance of two edges is right.
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return static_cast<std::uint64_t>(std::chrono::nanoseconds(now).count());
}

} // namespace spangle::hal

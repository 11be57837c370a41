#include <spangle/linux/spidev_bus.hpp>

#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <linux/spi/spidev.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "hal/linux/answer.hpp"
#include "hal/linux/persist.hpp"

namespace spangle::hal {
namespace {

/// spidev copies a message into `bufsiz` bytes, each transfer aligned to the DMA's cache line: 128 bytes at
/// most (arm64). Messages of a multiple of that fit on every kernel.
constexpr std::size_t dma_alignment = 128;
constexpr std::size_t default_bufsiz = 4096, largest_bufsiz = 1 << 20;

std::size_t kernel_bufsiz() {
    unsigned long size = 0;
    const int file = retry_interrupted(
        [] { return ::open("/sys/module/spidev/parameters/bufsiz", O_RDONLY | O_CLOEXEC); });
    if (file < 0)
        return default_bufsiz;
    char text[24] = {};
    if (retry_interrupted([&] { return ::read(file, text, sizeof text - 1); }) > 0)
        std::sscanf(text, "%lu", &size);
    ::close(file);
    const std::size_t whole = size - size % dma_alignment;
    return whole == 0 || whole > largest_bufsiz ? default_bufsiz : whole;
}

std::uint64_t address(const void* memory) {
    return reinterpret_cast<std::uintptr_t>(memory);
}

constexpr std::uint8_t byte_bits = 8, word_bits = 9;
constexpr std::size_t packed_unit = 9; ///< bytes that hold eight 9-bit words

} // namespace

SpidevBus::SpidevBus(const SpidevConfig& config)
    : TransferBus(config.pins, config.asynchronous), config_(config), actual_hz_(config.write_hz) {}

SpidevBus::~SpidevBus() {
    stop();
    close_device();
}

BusCaps SpidevBus::caps() const {
    BusCaps caps;
    caps.kind = config_.start_bytes ? BusKind::spi_start : BusKind::spi4;
    caps.write_hz = three_wire() ? static_cast<std::uint32_t>(std::uint64_t{actual_hz_} * 8 / 9) : actual_hz_;
    caps.read_hz = packed_ || config_.start_bytes ? 0 : config_.read_hz;
    caps.has_te = has_te();
    caps.late_us = late_us;
    caps.command_cost_ns = three_wire() ? 0 : config_.command_cost_ns;
    return caps;
}

Error SpidevBus::failed(const char* operation) {
    return error_.system(DeviceClass::spi, config_.device, operation, errno);
}

void SpidevBus::close_device() {
    if (device_ >= 0)
        ::close(device_);
    device_ = -1;
}

Result<void> SpidevBus::open() {
    if (busy())
        return Error{Fault::busy, "spidev: open while a transfer is under way"};
    if (config_.mode != 0 && config_.mode != 3)
        return Error{Fault::bad_argument, "spidev: display controllers take SPI mode 0 or 3"};
    if (config_.write_hz == 0)
        return Error{Fault::bad_argument, "spidev: no write clock"};
    if (config_.start_bytes && has_dc())
        return Error{Fault::bad_argument, "spidev: start bytes stand for D/C, which has a line too"};
    close_device();
    dc_.close();
    device_ = retry_interrupted([&] { return ::open(config_.device, O_RDWR | O_CLOEXEC); });
    if (device_ < 0)
        return failed("open");
    const Result<void> opened = open_rest();
    if (!opened)
        close_device();
    return opened;
}

Result<void> SpidevBus::open_rest() {
    if (const auto r = configure(); !r)
        return r;
    stage_.assign(kernel_bufsiz(), 0);
    if (packed_)
        stage_.resize(stage_.size() - stage_.size() % packed_unit);
    constexpr std::size_t whole_pixels = 6; // 6 bytes hold whole pixels of two bytes and of three
    longest_ = config_.start_bytes ? 1 + (stage_.size() - 1) / whole_pixels * whole_pixels : stage_.size();
    staged_ = bit_count_ = 0;
    dc_level_ = -1;
    if (has_dc()) {
        const unsigned offsets[] = {config_.dc.offset};
        if (const auto r = dc_.open_outputs(config_.dc.chip, offsets, 0); !r)
            return r;
    }
    return open_pins();
}

Result<void> SpidevBus::configure() {
    std::uint8_t mode = config_.mode == 3 ? SPI_MODE_3 : SPI_MODE_0;
    if (three_wire() && config_.read_hz != 0)
        mode |= SPI_3WIRE;
    std::uint32_t hz = config_.write_hz;
    if (retry_interrupted([&] { return ioctl(device_, SPI_IOC_WR_MODE, &mode); }) < 0)
        return failed("set SPI mode");
    if (const auto r = configure_word(); !r)
        return r;
    if (retry_interrupted([&] { return ioctl(device_, SPI_IOC_WR_MAX_SPEED_HZ, &hz); }) < 0) {
        char operation[48];
        std::snprintf(operation, sizeof operation, "set the clock to %u Hz", static_cast<unsigned>(hz));
        return failed(operation);
    }
    // A controller that cannot go so fast takes its fastest: deadlines follow it.
    actual_hz_ = config_.write_hz;
    if (retry_interrupted([&] { return ioctl(device_, SPI_IOC_RD_MAX_SPEED_HZ, &hz); }) >= 0 && hz != 0 &&
        hz < actual_hz_)
        actual_hz_ = hz;
    return {};
}

/// Sets the bits of a word. Many controllers know bytes only (Raspberry Pi): nine-bit words are then sent
/// packed.
Result<void> SpidevBus::configure_word() {
    std::uint8_t bits = three_wire() ? word_bits : byte_bits;
    packed_ = false;
    if (retry_interrupted([&] { return ioctl(device_, SPI_IOC_WR_BITS_PER_WORD, &bits); }) >= 0)
        return {};
    if (!three_wire() || errno != EINVAL)
        return failed("set bits per word");
    packed_ = true;
    bits = byte_bits;
    if (retry_interrupted([&] { return ioctl(device_, SPI_IOC_WR_BITS_PER_WORD, &bits); }) < 0)
        return failed("set bits per word");
    return {};
}

const char* SpidevBus::refusal(const Op& op) const {
    if (device_ < 0)
        return "spidev: the bus was not opened";
    // The chip is addressed for one message; a read cannot go on in the next one.
    if (op.kind == Op::Kind::read && op.length > stage_.size() - dma_alignment)
        return "spidev: a read longer than one message; raise spidev.bufsiz on the kernel's command line";
    return nullptr;
}

// --- Writing

Result<void> SpidevBus::put(Byte kind, const std::uint8_t* bytes, std::size_t count) {
    const bool data = kind != Byte::command;
    if (config_.start_bytes)
        return put_messages(data, bytes, count);
    return three_wire() ? put_three_wire(data, bytes, count) : put_four_wire(data, bytes, count);
}

/// Operations of one D/C level share a message. Bytes that fill a message are sent without a copy.
Result<void> SpidevBus::put_four_wire(bool data, const std::uint8_t* bytes, std::size_t count) {
    if (data != staged_data_)
        if (const auto r = flush(); !r)
            return r;
    staged_data_ = data;
    while (count != 0) {
        const std::size_t room = stage_.size() - staged_;
        const std::size_t taken = count < room ? count : room;
        if (taken == stage_.size()) {
            if (const auto r = send(data, bytes, taken); !r)
                return r;
        } else {
            std::memcpy(&stage_[staged_], bytes, taken);
            staged_ += taken;
            if (staged_ == stage_.size())
                if (const auto r = flush(); !r)
                    return r;
        }
        bytes += taken;
        count -= taken;
    }
    return {};
}

/// The first byte of a message stands for D/C; an index is a message by itself.
Result<void> SpidevBus::put_messages(bool data, const std::uint8_t* bytes, std::size_t count) {
    constexpr std::uint8_t index = 0x70, value = 0x72;
    if (!data || !staged_data_)
        if (const auto r = flush(); !r)
            return r;
    staged_data_ = data;
    while (count != 0) {
        if (staged_ == 0)
            stage_[staged_++] = data ? value : index;
        const std::size_t room = longest_ - staged_, taken = count < room ? count : room;
        std::memcpy(&stage_[staged_], bytes, taken);
        staged_ += taken;
        if (staged_ == longest_)
            if (const auto r = flush(); !r)
                return r;
        bytes += taken;
        count -= taken;
    }
    return {};
}

/// Whole lists share a message, because the D/C level is in the words.
Result<void> SpidevBus::put_three_wire(bool data, const std::uint8_t* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        stage_word((data ? 0x100u : 0u) | bytes[i]);
        if (staged_ == stage_.size())
            if (const auto r = flush(); !r)
                return r;
    }
    return {};
}

void SpidevBus::stage_word(unsigned nine_bits) {
    if (!packed_) {
        const auto word = static_cast<std::uint16_t>(nine_bits); // in native byte order, as spidev wants it
        std::memcpy(&stage_[staged_], &word, sizeof word);
        staged_ += sizeof word;
        return;
    }
    bits_ = bits_ << word_bits | nine_bits;
    for (bit_count_ += word_bits; bit_count_ >= byte_bits; bit_count_ -= byte_bits)
        stage_[staged_++] = static_cast<std::uint8_t>(bits_ >> (bit_count_ - byte_bits));
}

/// Fewer than nine padding bits follow the last packed word: raising CS drops them (DBI-C).
Result<void> SpidevBus::flush() {
    if (bit_count_ != 0)
        stage_[staged_++] = static_cast<std::uint8_t>(bits_ << (byte_bits - bit_count_));
    bit_count_ = 0;
    const std::size_t count = staged_;
    staged_ = 0;
    return count != 0 ? send(staged_data_, stage_.data(), count) : Result<void>{};
}

Result<void> SpidevBus::send(bool data, const std::uint8_t* bytes, std::size_t count) {
    if (has_dc())
        if (const auto r = set_dc(data); !r)
            return r;
    while (count != 0) {
        spi_ioc_transfer transfer{};
        transfer.tx_buf = address(bytes);
        transfer.len = static_cast<std::uint32_t>(count);
        transfer.speed_hz = config_.write_hz;
        const int sent = retry_interrupted([&] { return ioctl(device_, SPI_IOC_MESSAGE(1), &transfer); });
        if (sent < 0)
            return failed("write");
        const auto taken = static_cast<std::size_t>(sent);
        // With a D/C line, whole bytes may go on in another message. A cut word, or one without its start
        // byte, may not.
        if (taken == 0 || taken > count || (!has_dc() && taken != count))
            return error_.say(Fault::short_write, config_.device, "write", "the message was cut short");
        bytes += taken;
        count -= taken;
    }
    return {};
}

Result<void> SpidevBus::set_dc(bool data) {
    if (dc_level_ == (data ? 1 : 0))
        return {};
    dc_level_ = -1;
    if (const auto r = dc_.set(data != config_.dc.inverted ? 1 : 0); !r)
        return r;
    dc_level_ = data ? 1 : 0;
    return {};
}

Result<void> SpidevBus::end() {
    staged_ = bit_count_ = 0;
    return {};
}

// --- Reading

/// Reads an answer. Command and answer are one message, or the raised CS would end the command. D/C stays
/// low: the controller samples it with the command's last bit.
Result<void> SpidevBus::read(const Op& op) {
    if (!three_wire())
        if (const auto r = set_dc(false); !r)
            return r;
    std::vector<std::uint8_t> answer(answer_bytes(op));
    const std::uint16_t word = op.command; // nine bits, of which D/C is 0
    spi_ioc_transfer transfers[2]{};
    transfers[0].tx_buf = three_wire() ? address(&word) : address(&op.command);
    transfers[0].len = three_wire() ? 2 : 1;
    transfers[0].bits_per_word = three_wire() ? word_bits : byte_bits;
    transfers[1].rx_buf = address(answer.data());
    transfers[1].len = static_cast<std::uint32_t>(answer.size());
    transfers[1].bits_per_word = byte_bits;
    transfers[0].speed_hz = transfers[1].speed_hz = config_.read_hz;
    const int moved = retry_interrupted([&] { return ioctl(device_, SPI_IOC_MESSAGE(2), transfers); });
    if (moved < 0)
        return failed("read");
    if (static_cast<std::uint32_t>(moved) != transfers[0].len + transfers[1].len)
        return error_.say(Fault::no_answer, config_.device, "read", "the answer was cut short");
    take_answer(op, answer);
    return {};
}

} // namespace spangle::hal

#include <spangle/linux/i2c_bus.hpp>

#include <cerrno>
#include <cstdio>

#include <fcntl.h>
#include <linux/i2c-dev.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "hal/linux/persist.hpp"

namespace spangle::hal {
namespace {

/// Control byte: Co = 0, so that only commands, or only data, follow to the end of the message.
constexpr std::uint8_t commands_follow = 0x00, data_follows = 0x40;

/// The kernel's own bound of one write (drivers/i2c/i2c-dev.c).
constexpr std::size_t most_bytes = 8192;

} // namespace

I2cBus::I2cBus(const I2cConfig& config) : TransferBus(config.pins, config.asynchronous), config_(config) {}

I2cBus::~I2cBus() {
    stop();
    close_device();
}

BusCaps I2cBus::caps() const {
    BusCaps caps = i2c_caps(config_.clock_hz);
    caps.has_te = has_te();
    caps.late_us = late_us;
    return caps;
}

void I2cBus::close_device() {
    if (device_ >= 0)
        ::close(device_);
    device_ = -1;
}

Error I2cBus::failed(const char* operation, const char* cause) {
    char device[80];
    std::snprintf(device, sizeof device, "%.60s address %02Xh", config_.device, config_.address);
    return error_.system(DeviceClass::i2c, device, operation, errno, cause);
}

Result<void> I2cBus::open() {
    if (busy())
        return Error{Fault::busy, "i2c: open while a transfer is under way"};
    if (config_.clock_hz == 0 || config_.message_bytes < 2 || config_.message_bytes > most_bytes)
        return Error{Fault::bad_argument, "i2c: a clock, and messages of 2 to 8192 bytes"};
    close_device();
    device_ = retry_interrupted([&] { return ::open(config_.device, O_RDWR | O_CLOEXEC); });
    if (device_ < 0)
        return failed("open");
    if (retry_interrupted(
            [&] { return ioctl(device_, I2C_SLAVE, static_cast<unsigned long>(config_.address)); }) < 0) {
        const bool taken = errno == EBUSY;
        const Error error = failed("address", taken ? "a kernel driver has this device; unbind it" : nullptr);
        close_device();
        return error;
    }
    message_.clear();
    message_.reserve(config_.message_bytes);
    const Result<void> pins = open_pins();
    if (!pins)
        close_device();
    return pins;
}

const char* I2cBus::refusal(const Op&) const {
    return device_ < 0 ? "i2c: the bus was not opened" : nullptr;
}

Result<void> I2cBus::put(Byte kind, const std::uint8_t* bytes, std::size_t count) {
    const bool data = kind != Byte::command;
    if (data != data_)
        if (const auto r = flush(); !r)
            return r;
    data_ = data;
    for (std::size_t i = 0; i < count; ++i) {
        if (message_.empty())
            message_.push_back(data ? data_follows : commands_follow);
        message_.push_back(bytes[i]);
        if (message_.size() == config_.message_bytes)
            if (const auto r = flush(); !r)
                return r;
    }
    return {};
}

/// Sends the message. What was cut off goes on in another message, behind a control byte of its own.
Result<void> I2cBus::flush() {
    while (message_.size() > 1) {
        const auto sent =
            retry_interrupted([&] { return ::write(device_, message_.data(), message_.size()); });
        if (sent < 0)
            return failed("write", errno == ENXIO || errno == EREMOTEIO
                                       ? "no acknowledge; is the address right, and the panel powered?"
                                       : nullptr);
        const auto taken = static_cast<std::size_t>(sent);
        if (taken < 2 || taken > message_.size())
            return error_.say(Fault::short_write, config_.device, "write", "the message was cut short");
        message_.erase(message_.begin() + 1, message_.begin() + sent);
    }
    message_.clear();
    return {};
}

Result<void> I2cBus::end() {
    message_.clear();
    return {};
}

} // namespace spangle::hal

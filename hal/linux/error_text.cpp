#include <spangle/linux/error_text.hpp>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace spangle::hal {
namespace {

Fault fault_of(DeviceClass kind, int error) {
    switch (error) {
    case EACCES:
    case EPERM:
        return Fault::denied;
    case EBUSY:
        return Fault::busy;
    case ETIMEDOUT:
    case EAGAIN:
    // retry_interrupted() repeats calls that end with EAGAIN or EINTR. One that ends so even then took too
    // long.
    case EINTR:
        return Fault::timeout;
    case ENXIO: // means "no acknowledge" from an I2C adapter (Linux, i2c/fault-codes)
        return kind == DeviceClass::i2c ? Fault::no_answer : Fault::gone;
    case ENOENT:
    case ENODEV:
    case ESHUTDOWN:
        return Fault::gone;
    case EINVAL:
    case ENOTTY:
    case EOPNOTSUPP:
    case EMSGSIZE:
        return Fault::unsupported;
    default:
        return Fault::no_answer;
    }
}

const char* permission_hint(DeviceClass kind) {
    switch (kind) {
    case DeviceClass::gpio:
        return "; install the udev rules 60-spangle.rules and join group 'gpio'";
    case DeviceClass::spi:
        return "; install the udev rules 60-spangle.rules and join group 'spi'";
    case DeviceClass::usb:
        return "; install the udev rules 60-spangle.rules and join group 'plugdev'";
    case DeviceClass::i2c:
        break;
    }
    return "; install the udev rules 60-spangle.rules and join group 'i2c'";
}

const char* absence_hint(DeviceClass kind) {
    switch (kind) {
    case DeviceClass::gpio:
        return "; gpiodetect lists the chips";
    case DeviceClass::spi:
        return "; is the bus enabled (Raspberry Pi: dtparam=spi=on in config.txt)?";
    case DeviceClass::usb:
        return "; lsusb lists what is plugged in";
    case DeviceClass::i2c:
        break;
    }
    return "; is the bus enabled (Raspberry Pi: dtparam=i2c_arm=on in config.txt)?";
}

const char* hint(DeviceClass kind, int error) {
    if (error == EACCES || error == EPERM)
        return permission_hint(kind);
    return error == ENOENT ? absence_hint(kind) : "";
}

} // namespace

Error ErrorText::system(DeviceClass kind, const char* device, const char* operation, int errno_value,
                        const char* cause) {
    const std::string words = std::generic_category().message(errno_value);
    std::snprintf(text_.data(), text_.size(), "%s: %s: %s%s", device, operation,
                  cause != nullptr ? cause : words.c_str(), hint(kind, errno_value));
    return {fault_of(kind, errno_value), text_.data(), static_cast<std::uint32_t>(errno_value)};
}

Error ErrorText::say(Fault fault, const char* device, const char* operation, const char* cause) {
    std::snprintf(text_.data(), text_.size(), "%s: %s: %s", device, operation, cause);
    return {fault, text_.data()};
}

} // namespace spangle::hal

// What a Linux device refused, as one sentence: device, operation, cause, and what helps.
#pragma once

#include <array>

#include <spangle/hal/result.hpp>

namespace spangle::hal {

/// Which rule of 60-spangle.rules, group and boot option a hint names.
enum class DeviceClass : std::uint8_t { gpio, spi, i2c, usb };

/// Owns the text its last error points to.
class ErrorText {
  public:
    /// Describes `errno_value` of `operation` on `device`. `cause` replaces the system's words for it.
    Error system(DeviceClass kind, const char* device, const char* operation, int errno_value,
                 const char* cause = nullptr);
    /// An error of `operation` on `device` that is not the system's, with its cause in words. The text stays
    /// until the next call.
    Error say(Fault fault, const char* device, const char* operation, const char* cause);

  private:
    std::array<char, 320> text_{};
};

} // namespace spangle::hal

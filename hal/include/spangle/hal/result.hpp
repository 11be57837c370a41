// Errors are values on every path of the HAL.
#pragma once

#include <cstdint>

#ifndef SPANGLE_MESSAGES
#define SPANGLE_MESSAGES 1 ///< 0 compiles every text out
#endif

namespace spangle::hal {

enum class Fault : std::uint8_t {
    none,
    bad_argument, ///< the call broke a rule of this interface; `rule` names it
    unsupported,  ///< the bus or panel cannot do this
    busy,         ///< nothing was started; try again
    timeout,      ///< a deadline passed
    no_answer,    ///< the device did not acknowledge or returned nothing
    short_write,  ///< fewer bytes went out than were asked for
    gone,         ///< the device was removed
    wrong_device, ///< it answered, but as something else
    denied,       ///< this user may not open the device
};

/// What went wrong and which rule it broke: a string that names device, operation and cause. It is static, or
/// stays until the object that gave it ends, or has failed several more times.
struct Error {
    constexpr Error() = default;
    constexpr Error(Fault what, const char* text, std::uint32_t more = 0)
        : fault(what), rule(SPANGLE_MESSAGES != 0 ? text : ""), detail(more) {}

    Fault fault = Fault::none;
    const char* rule = "";    ///< it stays so in builds without texts
    std::uint32_t detail = 0; ///< wrong_device: the bytes that answered, first byte highest; system
                              ///< errors: errno
};

/// A value or an error. `ok()` must be asked before `value()`.
template <class T> class [[nodiscard]] Result {
  public:
    constexpr Result(T value) : value_(value) {}
    constexpr Result(Error error) : error_(error) {}
    constexpr bool ok() const { return error_.fault == Fault::none; }
    constexpr explicit operator bool() const { return ok(); }
    constexpr const T& value() const { return value_; }
    constexpr T& value() { return value_; }
    constexpr Error error() const { return error_; }

  private:
    T value_{};
    Error error_{};
};

template <> class [[nodiscard]] Result<void> {
  public:
    constexpr Result() = default;
    constexpr Result(Error error) : error_(error) {}
    constexpr bool ok() const { return error_.fault == Fault::none; }
    constexpr explicit operator bool() const { return ok(); }
    constexpr Error error() const { return error_; }

  private:
    Error error_{};
};

} // namespace spangle::hal

// Errors are values on every path of the HAL.
#pragma once

#include <cstdint>

#ifndef SPANGLE_MESSAGES
#define SPANGLE_MESSAGES 1 ///< 0: texts of errors are not compiled in
#endif

namespace spangle::hal {

/// What went wrong, as far as a program may want to react to it. docs/faults.md shows what each transport
/// raises.
enum class Fault : std::uint8_t {
    none,         ///< nothing went wrong
    bad_argument, ///< the call broke a rule of this interface; `rule` names it
    unsupported,  ///< the bus or panel cannot do this
    busy,         ///< nothing was started; try again
    timeout,      ///< a deadline passed
    no_answer,    ///< the device did not acknowledge or returned nothing
    short_write,  ///< fewer bytes went out than were asked for
    gone,         ///< the device was removed
    wrong_device, ///< the device answered, but is another one
    denied,       ///< this user may not open the device
};

/// What went wrong and which rule it broke: a string that names device, operation and cause. It is static, or
/// stays until the object that gave it ends, or has failed several more times.
struct Error {
    /// Makes the value that stands for no error.
    constexpr Error() = default;
    /// An error with its text, which must be static or outlive the error; `more` becomes `detail`.
    constexpr Error(Fault what, const char* text, std::uint32_t more = 0)
        : fault(what), rule(SPANGLE_MESSAGES != 0 ? text : ""), detail(more) {}

    /// The kind of fault.
    Fault fault = Fault::none;
    const char* rule = "";    ///< the broken rule; empty in builds without texts
    std::uint32_t detail = 0; ///< wrong_device: the bytes that answered, first byte highest; system
                              ///< errors: errno
};

/// A value or an error. `ok()` must be asked before `value()`.
template <class T> class [[nodiscard]] Result {
  public:
    /// A result that is a value.
    constexpr Result(T value) : value_(value) {}
    /// A result that is an error; `error.fault` must not be Fault::none.
    constexpr Result(Error error) : error_(error) {}
    /// Whether there is a value.
    constexpr bool ok() const { return error_.fault == Fault::none; }
    /// Does what ok() does.
    constexpr explicit operator bool() const { return ok(); }
    /// The value; where there is an error, a value-initialised T.
    constexpr const T& value() const { return value_; }
    /// The value, which may be changed.
    constexpr T& value() { return value_; }
    /// The error; its fault is Fault::none where there is a value.
    constexpr Error error() const { return error_; }

  private:
    T value_{};
    Error error_{};
};

/// Success or an error.
template <> class [[nodiscard]] Result<void> {
  public:
    /// A result that is a success.
    constexpr Result() = default;
    /// An error; its fault must not be Fault::none.
    constexpr Result(Error error) : error_(error) {}
    /// Whether the result is a success.
    constexpr bool ok() const { return error_.fault == Fault::none; }
    /// Does what ok() does.
    constexpr explicit operator bool() const { return ok(); }
    /// The error; its fault is Fault::none after success.
    constexpr Error error() const { return error_; }

  private:
    Error error_{};
};

} // namespace spangle::hal

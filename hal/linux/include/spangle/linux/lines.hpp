// GPIO lines over libgpiod's C API. Version 1 or 2 was chosen when Spangle was configured.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <spangle/linux/error_text.hpp>

namespace spangle::hal {

/// One line: the chip's device file ("/dev/gpiochip0") or its label ("pinctrl-bcm2711"), and its offset
/// there.
struct LineRef {
    const char* chip = nullptr; ///< the chip's name; null: the line is not wired
    /// The line's number on its chip.
    unsigned offset = 0;
    bool inverted = false; ///< true: a transistor inverts the line on its way to the pin
    /// Whether the line is wired.
    bool wired() const { return chip != nullptr; }
};

/// Lines of one chip requested together: outputs that change in one system call, or inputs. Levels are bit
/// sets, line n of the request in bit n, and physical.
class Lines {
  public:
    /// The most lines of one request.
    static constexpr unsigned most = 32;

    /// A request of no lines.
    Lines();
    /// Gives the lines back.
    ~Lines();
    /// A request is not copied.
    Lines(const Lines&) = delete;
    /// A request is not assigned.
    Lines& operator=(const Lines&) = delete;

    /// Requests outputs at these levels. Fault::denied, Fault::gone, Fault::busy and others: what the kernel
    /// says.
    Result<void> open_outputs(const char* chip, std::span<const unsigned> offsets, std::uint32_t levels);
    /// Requests inputs. Errors are those of open_outputs().
    Result<void> open_inputs(const char* chip, std::span<const unsigned> offsets);
    /// Gives the lines back.
    void close();
    /// Whether lines are requested.
    bool opened() const { return request_ != nullptr; }

    /// Sets all outputs at once.
    Result<void> set(std::uint32_t levels);
    /// Reads the levels of all lines.
    Result<std::uint32_t> get();
    /// Makes all lines outputs, at these levels.
    Result<void> drive(std::uint32_t levels);
    /// Makes all lines inputs.
    Result<void> float_lines();

  private:
    struct Request;
    std::unique_ptr<Request> request_;
    ErrorText error_;
    char name_[96] = "";

    Result<void> open_checked(const char* chip, std::span<const unsigned> offsets,
                              const std::uint32_t* levels);
    /// Requests lines as outputs with `levels` or, where that is null, as inputs. Chip and offsets were
    /// checked, and errors name them.
    Result<void> open(const char* chip, std::span<const unsigned> offsets, const std::uint32_t* levels);
    template <class Call> Result<void> run(const char* operation, Call call);
    Error failed(const char* operation);

    // Each of these functions makes one call of libgpiod. A negative result means that errno holds an error.
    int set_values(std::uint32_t levels);
    int get_values(std::uint32_t& levels);
    int make_outputs(std::uint32_t levels);
    int make_inputs();
};

/// An input whose rising edges the kernel counts and stamps.
class EdgeLine {
  public:
    /// A request of no line.
    EdgeLine();
    /// Gives the line back.
    ~EdgeLine();
    /// A request is not copied.
    EdgeLine(const EdgeLine&) = delete;
    /// A request is not assigned.
    EdgeLine& operator=(const EdgeLine&) = delete;

    /// Requests the line. Errors are those of Lines::open_outputs().
    Result<void> open(const LineRef& line);
    /// Gives the line back.
    void close();
    /// Whether the line is requested.
    bool opened() const { return request_ != nullptr; }

    /// Waits for an edge that comes after this call, and returns the kernel's time of it in nanoseconds. None
    /// in time: Fault::timeout.
    Result<std::uint64_t> next_edge(std::uint32_t timeout_micros);

  private:
    struct Request;
    std::unique_ptr<Request> request_;
    ErrorText error_;
    char name_[96] = "";

    int wait(std::int64_t nanoseconds);
    int take(std::uint64_t& time);
    Error failed(const char* operation);
};

} // namespace spangle::hal

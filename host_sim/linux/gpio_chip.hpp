// A model of a GPIO chip behind its character device, with both uAPIs of the kernel: v1 (libgpiod 1.x) and v2
// (libgpiod 2.x). It is written from include/uapi/linux/gpio.h.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "host_sim/bus/pin_header.hpp"
#include "host_sim/linux/kernel.hpp"

namespace spangle::sim {

class GpioChip final : public Device, public PinHeader {
  public:
    static constexpr unsigned most_lines = 64;

    /// How the values of one request reach the pins. A controller without a set register changes lines one by
    /// one.
    enum class Settling { together, ascending, descending };

    GpioChip(std::string label, unsigned lines);
    /// Makes /dev/gpiochip<number> and the entries of /sys that libgpiod looks up.
    void attach(Kernel& kernel, unsigned number);
    static std::string path(unsigned number) { return "/dev/gpiochip" + std::to_string(number); }

    // --- what hangs on the pins
    Settling settling = Settling::together;
    /// Gives the line to another consumer, so that requests of it fail.
    void take_line(unsigned line, const std::string& consumer);
    void vacate(unsigned line);

    /// The levels of all lines; bit n is the level of line n.
    std::uint64_t levels() const;
    bool is_output(unsigned line) const { return (output_mask_ >> line & 1) != 0; }
    bool is_requested(unsigned line) const { return !lines_[line].consumer.empty(); }

    std::unique_ptr<OpenFile> open() override;
    int gone_error() const override;

  private:
    friend class ChipFile;
    friend class RequestFile;
    struct Line {
        std::string consumer; ///< name of who holds the line; empty: the line is free
    };

    std::string label_, name_;
    Kernel* kernel_ = nullptr;
    unsigned line_count_;
    std::array<Line, most_lines> lines_;
    std::uint64_t output_mask_ = 0;
    std::uint64_t levels_ = ~std::uint64_t{0}; ///< driven levels of outputs; 1 for all other lines

    void drive(const std::vector<unsigned>& offsets, std::uint64_t values, std::uint64_t mask);
    void set_direction(const std::vector<unsigned>& offsets, bool output);
    bool level(unsigned line, Time now) const;
    std::string node() const;
};

} // namespace spangle::sim

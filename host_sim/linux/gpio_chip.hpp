// A GPIO chip behind its character device, in both uAPIs the kernel has: v1 (libgpiod 1.x) and v2 (2.x).
// From include/uapi/linux/gpio.h.
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

    /// How the lines of one request reach their pins: controllers without a set register change them one by
    /// one.
    enum class Settling { together, ascending, descending };

    GpioChip(std::string label, unsigned lines);
    /// Makes /dev/gpiochip<number> and what libgpiod looks up in /sys.
    void attach(Kernel& kernel, unsigned number);
    static std::string path(unsigned number) { return "/dev/gpiochip" + std::to_string(number); }

    // --- the pins' other end
    Settling settling = Settling::together;
    /// Somebody else has this line.
    void occupy(unsigned line, const std::string& consumer);
    void vacate(unsigned line);

    /// Bit n is the level of line n.
    std::uint64_t levels() const;
    bool is_output(unsigned line) const { return (outputs_ >> line & 1) != 0; }
    bool requested(unsigned line) const { return !lines_[line].consumer.empty(); }

    std::unique_ptr<OpenFile> open() override;
    int gone_error() const override;

  private:
    friend class ChipFile;
    friend class RequestFile;
    struct Line {
        std::string consumer; ///< empty: free
    };

    std::string label_, name_;
    Kernel* kernel_ = nullptr;
    unsigned count_;
    std::array<Line, most_lines> lines_;
    std::uint64_t outputs_ = 0;
    std::uint64_t levels_ = ~std::uint64_t{0}; ///< of outputs; all others have a one

    void drive(const std::vector<unsigned>& offsets, std::uint64_t values, std::uint64_t mask);
    void set_direction(const std::vector<unsigned>& offsets, bool output);
    bool level(unsigned line, Time now) const;
    std::string node() const;
};

} // namespace spangle::sim

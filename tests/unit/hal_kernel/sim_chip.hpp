// A GPIO chip of the kernel's gpio-sim: with real gpiolib and a real character device. /sys drives and reads
// the other end of its lines.
#pragma once

#include <string>

namespace kernel_test {

class SimChip {
  public:
    /// A chip with this label starts the machine's buses: SPI on lines 8 to 11, I2C on lines 2 and 3
    /// (board.c).
    static constexpr char header_label[] = "display-header";

    SimChip(const std::string& label, unsigned lines);
    ~SimChip();
    SimChip(const SimChip&) = delete;
    SimChip& operator=(const SimChip&) = delete;

    /// Returns the device file, "/dev/gpiochip0".
    const std::string& path() const { return path_; }
    const std::string& label() const { return label_; }
    /// Returns the number of the chip's first line in the trace.
    unsigned first_number() const;
    /// Returns the level of a line, whoever drives it.
    bool level(unsigned line) const;
    /// Sets what an input line reads; a change is an edge.
    void pull(unsigned line, bool high);
    /// Removes the chip as if its adapter were pulled; open files stay open.
    void remove();

  private:
    std::string label_, path_, lines_folder_;
    bool present_ = true;

    bool has_buses() const { return label_ == header_label; }
};

} // namespace kernel_test

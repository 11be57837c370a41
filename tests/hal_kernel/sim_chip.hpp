// A GPIO chip of the kernel's gpio-sim: real gpiolib, real character device, lines whose other end is in
// /sys.
#pragma once

#include <string>

namespace kernel_test {

class SimChip {
  public:
    /// With this label the machine's buses come to life: SPI on lines 8 to 11, I2C on 2 and 3 (board.c).
    static constexpr char header_label[] = "display-header";

    SimChip(const std::string& label, unsigned lines);
    ~SimChip();
    SimChip(const SimChip&) = delete;
    SimChip& operator=(const SimChip&) = delete;

    /// "/dev/gpiochip0"
    const std::string& path() const { return path_; }
    const std::string& label() const { return label_; }
    /// The number of its first line, as the trace has it.
    unsigned first_number() const;
    /// The level of a line, whoever drives it.
    bool level(unsigned line) const;
    /// What an input line reads; a change is an edge.
    void pull(unsigned line, bool high);
    /// As when its adapter is pulled; what is open stays open.
    void remove();

  private:
    std::string label_, path_, lines_folder_;
    bool present_ = true;

    bool has_buses() const { return label_ == header_label; }
};

} // namespace kernel_test

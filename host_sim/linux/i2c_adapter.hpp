// An I2C adapter behind i2c-dev with one display controller on it, whose messages begin with control bytes
// (SSD1306 datasheet, 8.1.5.2): Co = 1 one byte follows, Co = 0 the rest of the message; D/C says what it is.
#pragma once

#include <string>
#include <vector>

#include "host_sim/linux/kernel.hpp"

namespace spangle::sim {

class I2cAdapter final : public Device {
  public:
    /// What reaches the controller.
    struct Received {
        std::uint8_t byte;
        bool data;
        friend bool operator==(const Received&, const Received&) = default;
    };

    explicit I2cAdapter(unsigned address) : address_(address) {}
    void attach(Kernel& kernel, const std::string& path);

    bool powered = true; ///< else nobody acknowledges
    bool taken = false;  ///< a kernel driver has the address
    std::size_t longest_message = 8192;
    std::uint32_t hz = 400000;

    const std::vector<Received>& received() const { return received_; }
    void forget() { received_.clear(), wrong_.clear(), messages_ = 0; }
    /// Rule 14 of the protocol: what came without its control byte, or with one that says nothing.
    const std::string& wrong() const { return wrong_; }
    std::uint64_t messages() const { return messages_; }

    std::unique_ptr<OpenFile> open() override;
    int gone_error() const override;

  private:
    friend class I2cFile;
    unsigned address_;
    Kernel* kernel_ = nullptr;
    std::vector<Received> received_;
    std::string wrong_;
    std::uint64_t messages_ = 0;

    void take(const std::uint8_t* bytes, std::size_t count);
};

} // namespace spangle::sim

// A model of an I2C adapter behind i2c-dev, with one display controller on its bus.
#pragma once

#include <string>
#include <vector>

#include "host_sim/bus/i2c_target.hpp"
#include "host_sim/linux/kernel.hpp"

namespace spangle::sim {

class I2cAdapter final : public Device {
  public:
    /// A byte that reached the controller, as command or as data.
    struct ReceivedByte {
        std::uint8_t byte;
        bool data;
        friend bool operator==(const ReceivedByte&, const ReceivedByte&) = default;
    };

    /// `panel` is the controller at the address; null: bytes are only recorded.
    explicit I2cAdapter(unsigned address, Controller* panel = nullptr)
        : address_(address), recorder_(panel) {}
    void attach(Kernel& kernel, const std::string& path);

    bool powered = true; ///< false: nobody acknowledges the address
    bool taken = false;  ///< a kernel driver has the address, so that I2C_SLAVE fails
    std::size_t longest_message = 8192;
    std::uint32_t hz = 400000;

    const std::vector<ReceivedByte>& received() const { return recorder_.received; }
    void forget() {
        recorder_.received.clear();
        recorder_.forget_violations();
        messages_ = 0;
    }
    /// The bytes that came without a control byte, or after a control byte without a meaning.
    std::string wrong() const { return recorder_.violations_text(); }
    /// Replaces the controller on the bus; null removes it.
    void replace(Controller* panel) { recorder_.panel = panel; }
    std::uint64_t message_count() const { return messages_; }

    std::unique_ptr<OpenFile> open() override;
    int gone_error() const override;

  private:
    friend class I2cFile;

    /// Records what the controller is sent, and passes it on.
    struct Recorder final : Controller {
        explicit Recorder(Controller* to) : Controller("I2C", {}), panel(to) {}
        Controller* panel;
        std::vector<ReceivedByte> received;

        void reset(bool, Time) override {}
        void select(bool chip_select, Time now) override;
        void write(std::uint8_t byte, bool data, Time now, unsigned period_ns) override;
        std::vector<Rgb666> glass(Time) override { return {}; }
        std::vector<Rgb666> cells() const override { return {}; }
        MemorySize memory_size() const override { return {}; }
        Time line_time() const override { return 1; }
        Time refresh_time() const override { return 0; }
    };

    unsigned address_;
    Kernel* kernel_ = nullptr;
    Recorder recorder_;
    I2cTarget target_{recorder_};
    std::uint64_t messages_ = 0;

    void take(const std::uint8_t* bytes, std::size_t count);
};

} // namespace spangle::sim

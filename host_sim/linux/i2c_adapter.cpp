#include "host_sim/linux/i2c_adapter.hpp"

#include <cerrno>

#include <linux/i2c-dev.h>

namespace spangle::sim {
namespace {

constexpr unsigned i2c_major = 89;

} // namespace

class I2cFile final : public OpenFile {
  public:
    explicit I2cFile(I2cAdapter& adapter) : adapter_(adapter) {}

    long ioctl(unsigned long request, void* argument, std::size_t) override {
        if (request != I2C_SLAVE)
            return -ENOTTY;
        const auto address = reinterpret_cast<std::uintptr_t>(argument);
        if (address > 0x7F)
            return -EINVAL;
        if (adapter_.taken && address == adapter_.address_)
            return -EBUSY;
        addressed_ = address == adapter_.address_;
        return 0;
    }

    long write(const void* from, std::size_t count, std::size_t limit) override {
        if (count > adapter_.longest_message)
            return -EOPNOTSUPP;
        if (!addressed_ || !adapter_.powered)
            return -ENXIO;
        const std::size_t taken = count < limit ? count : limit;
        adapter_.take(static_cast<const std::uint8_t*>(from), taken);
        return static_cast<long>(taken);
    }

  private:
    I2cAdapter& adapter_;
    bool addressed_ = false;
};

void I2cAdapter::attach(Kernel& kernel, const std::string& path) {
    kernel_ = &kernel;
    kernel.add_device(path, *this, i2c_major, 1);
}

void I2cAdapter::Recorder::select(bool chip_select, Time now) {
    if (panel != nullptr)
        panel->select(chip_select, now);
}

void I2cAdapter::Recorder::write(std::uint8_t byte, bool data, Time now, unsigned period_ns) {
    received.push_back({byte, data});
    if (panel != nullptr)
        panel->write(byte, data, now, period_ns);
}

/// Carries a message. The address and each byte take nine clocks.
void I2cAdapter::take(const std::uint8_t* bytes, std::size_t count) {
    const unsigned period = 1'000'000'000u / hz;
    kernel_->advance(Time{9} * period);
    ++messages_;
    target_.start(kernel_->now());
    for (std::size_t i = 0; i < count; ++i) {
        kernel_->advance(Time{9} * period);
        target_.byte(bytes[i], kernel_->now(), period);
    }
    target_.stop(kernel_->now());
}

std::unique_ptr<OpenFile> I2cAdapter::open() {
    return std::make_unique<I2cFile>(*this);
}

int I2cAdapter::gone_error() const {
    return ENODEV;
}

} // namespace spangle::sim

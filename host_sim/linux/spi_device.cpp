#include "host_sim/linux/spi_device.hpp"

#include <cerrno>
#include <cstring>

#include <linux/spi/spidev.h>

namespace spangle::sim {
namespace {

constexpr unsigned spi_major = 153;
constexpr unsigned most_transfers = 64;

template <class T> T& at(std::uint64_t address) {
    return *reinterpret_cast<T*>(static_cast<std::uintptr_t>(address));
}

} // namespace

class SpiFile final : public OpenFile {
  public:
    explicit SpiFile(SpiDevice& device) : device_(device) {}

    long ioctl(unsigned long request, void* argument, std::size_t limit) override {
        if (_IOC_TYPE(request) != SPI_IOC_MAGIC)
            return -ENOTTY;
        if (_IOC_NR(request) == _IOC_NR(SPI_IOC_MESSAGE(1)))
            return message(static_cast<const spi_ioc_transfer*>(argument),
                           _IOC_SIZE(request) / sizeof(spi_ioc_transfer), limit);
        SpiDevice::Settings& s = device_.settings_;
        switch (request) {
        case SPI_IOC_WR_MODE: {
            s.mode = *static_cast<const std::uint8_t*>(argument);
            const std::uint32_t clocking = s.mode & (SPI_CPOL | SPI_CPHA);
            const bool known = clocking == SPI_MODE_0 || clocking == SPI_MODE_3;
            return known && (s.mode & SPI_LSB_FIRST) == 0 ? 0 : -EINVAL;
        }
        case SPI_IOC_WR_BITS_PER_WORD: {
            const std::uint8_t bits = *static_cast<const std::uint8_t*>(argument);
            if (!takes(bits))
                return -EINVAL;
            s.bits = bits;
            return 0;
        }
        case SPI_IOC_WR_MAX_SPEED_HZ:
            s.hz = *static_cast<const std::uint32_t*>(argument);
            if (s.hz < device_.min_hz)
                return -EINVAL;
            s.hz = s.hz < device_.max_hz ? s.hz : device_.max_hz;
            return 0;
        case SPI_IOC_RD_MAX_SPEED_HZ:
            *static_cast<std::uint32_t*>(argument) = s.hz;
            return 0;
        default:
            return -ENOTTY;
        }
    }

  private:
    SpiDevice& device_;
    Time now_ = 0; ///< virtual time inside a message, ns

    bool takes(unsigned bits) const { return bits == 8 || (bits == 9 && device_.nine_bit_words); }

    /// Checks a whole message before its first bit is sent. Returns 0 or negative errno.
    long check(const spi_ioc_transfer* transfers, std::size_t count) const {
        std::size_t total = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const spi_ioc_transfer& t = transfers[i];
            total += (t.len + device_.alignment - 1) / device_.alignment * device_.alignment;
            const unsigned bits = t.bits_per_word != 0 ? t.bits_per_word : device_.settings_.bits;
            if (!takes(bits) || (bits > 8 && t.len % 2 != 0))
                return -EINVAL;
            if ((device_.settings_.mode & SPI_3WIRE) != 0 && t.tx_buf != 0 && t.rx_buf != 0)
                return -EINVAL;
        }
        return count == 0 || count > most_transfers ? -EINVAL : total > device_.bufsiz ? -EMSGSIZE : 0;
    }

    long message(const spi_ioc_transfer* transfers, std::size_t count, std::size_t limit) {
        if (const long refused = check(transfers, count); refused != 0)
            return refused;
        using Pin = SerialPins::Pin;
        Kernel& kernel = *device_.kernel_;
        now_ = kernel.now() + device_.message_ns;
        ++device_.message_count_;
        device_.pins_.set(Pin::clock, (device_.settings_.mode & SPI_CPOL) != 0, now_);
        device_.pins_.set(Pin::select, false, now_);
        std::size_t done = 0;
        for (std::size_t i = 0; i < count; ++i)
            done += transfer(transfers[i], limit - done);
        device_.pins_.set(Pin::select, true, now_);
        device_.largest_message_ = done > device_.largest_message_ ? done : device_.largest_message_;
        kernel.advance(now_ - kernel.now());
        return static_cast<long>(done);
    }

    std::size_t transfer(const spi_ioc_transfer& t, std::size_t limit) {
        const unsigned bits = t.bits_per_word != 0 ? t.bits_per_word : device_.settings_.bits;
        const std::size_t word_bytes = bits > 8 ? 2 : 1;
        std::uint32_t hz = t.speed_hz != 0 ? t.speed_hz : device_.settings_.hz;
        hz = hz < device_.max_hz ? hz : device_.max_hz;
        const std::size_t end = t.len < limit ? t.len : limit / word_bytes * word_bytes;
        for (std::size_t i = 0; i < end; i += word_bytes) {
            const std::uint16_t out = word_bytes == 1 ? sent<std::uint8_t>(t, i) : sent<std::uint16_t>(t, i);
            const unsigned in = word(out, bits, 1'000'000'000u / hz);
            if (t.rx_buf != 0)
                at<std::uint8_t>(t.rx_buf + i) = static_cast<std::uint8_t>(in);
        }
        return end;
    }

    template <class T> static T sent(const spi_ioc_transfer& t, std::size_t i) {
        T value = 0;
        if (t.tx_buf != 0)
            std::memcpy(&value, &at<const std::uint8_t>(t.tx_buf + i), sizeof value);
        return value;
    }

    /// Exchanges one word. Bits change at falling clocks and are taken at rising clocks, in modes 0 and 3
    /// alike.
    unsigned word(unsigned out, unsigned bits, unsigned period) {
        using Pin = SerialPins::Pin;
        SerialPins& pins = device_.pins_;
        const bool rests_high = (device_.settings_.mode & SPI_CPOL) != 0;
        unsigned in = 0;
        for (unsigned bit = bits; bit-- != 0;) {
            pins.set(Pin::clock, false, now_);
            pins.set(Pin::mosi, (out >> bit & 1) != 0, now_);
            now_ += period / 2;
            in = in << 1 | (pins.miso() ? 1u : 0u);
            pins.set(Pin::clock, true, now_);
            now_ += period - period / 2;
            if (!rests_high)
                pins.set(Pin::clock, false, now_);
        }
        return in;
    }
};

void SpiDevice::attach(Kernel& kernel, const std::string& path) {
    kernel_ = &kernel;
    kernel.add_device(path, *this, spi_major, 0);
    kernel.add_text("/sys/module/spidev/parameters/bufsiz", std::to_string(bufsiz) + "\n");
}

std::unique_ptr<OpenFile> SpiDevice::open() {
    return std::make_unique<SpiFile>(*this);
}

int SpiDevice::gone_error() const {
    return ESHUTDOWN;
}

} // namespace spangle::sim

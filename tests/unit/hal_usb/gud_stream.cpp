#include "tests/unit/hal_usb/gud_stream.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <optional>

#include <spangle/usb/gud_display.hpp>

#include "host_sim/linux/kernel.hpp"
#include "host_sim/usb/gud_device.hpp"
#include "host_sim/usb/usbfs.hpp"

namespace gud_test {

using namespace spangle;

namespace {

constexpr char path[] = "/dev/bus/usb/001/003";

/// Reads bytes of the stream, and zeros after its end.
class Script {
  public:
    Script(const std::uint8_t* data, std::size_t bytes) : at_(data), end_(data + bytes) {}
    bool more() const { return at_ != end_; }
    unsigned byte() { return at_ != end_ ? *at_++ : 0u; }
    std::uint16_t word() {
        const unsigned low = byte();
        return static_cast<std::uint16_t>(low | byte() << 8);
    }

  private:
    const std::uint8_t *at_, *end_;
};

/// Returns a size or count near the limits where such numbers often fail.
std::uint16_t size(Script& in) {
    constexpr std::uint16_t odd[] = {0,    1,    2,    3,    7,    8,     255,   256,
                                     2048, 2049, 4095, 4096, 4097, 32767, 32768, 65535};
    const unsigned how = in.byte();
    return how < 160   ? static_cast<std::uint16_t>(1 + how % 80)
           : how < 240 ? odd[how % std::size(odd)]
                       : in.word();
}

/// A device that mostly answers as the model does. A zero of the script is the honest answer, so after the
/// end of its script the device behaves.
class HostileDevice final : public sim::UsbFunction {
  public:
    HostileDevice(Script what, Script answers) : script_(answers) {
        honest_.modes.clear();
        for (unsigned left = what.byte() % 4; left > 0; --left)
            honest_.modes.push_back({1000, size(what), size(what), what.byte() % 2 != 0});
        if (honest_.modes.empty() || what.byte() % 2 == 0)
            honest_.modes.push_back({1000, 40, 30, true});
        honest_.limits = {0, 65535, 0, 65535};
        if (what.byte() % 4 == 0)
            for (std::uint16_t& limit : honest_.limits)
                limit = size(what);
        constexpr std::uint8_t formats[] = {0x40, 0x01, 0x08, 0x20, 0x30, 0x50, 0x80, 0x81, 0x00, 0xFF};
        honest_.formats = {formats[what.byte() % std::size(formats)]};
        const unsigned flags = what.byte();
        honest_.lz4 = (flags & 1) != 0;
        honest_.status_on_set = (flags & 2) != 0;
        honest_.full_update = (flags & 4) != 0;
        honest_.poll_status = (flags & 8) != 0;
        honest_.connected = (flags & 16) == 0;
        honest_.max_buffer_size = (flags & 32) != 0 ? size(what) : 0;
        honest_.connectors = (flags & 64) != 0 ? static_cast<int>(what.byte() % 40) : 1;
        if ((flags & 128) != 0) {
            honest_.modes.clear(); // a device without modes may have an EDID
            honest_.edid.resize(std::min<std::size_t>(size(what), 4096));
            for (std::size_t i = 0; i < honest_.edid.size(); ++i)
                honest_.edid[i] = static_cast<std::uint8_t>(what.byte());
        }
        for (unsigned left = what.byte() % 8; left > 0; --left)
            honest_.properties.push_back({what.word(), what.word()});
        descriptors_ = honest_.descriptors();
        for (unsigned left = what.byte() % 4; left > 0 && !descriptors_.empty(); --left) {
            const std::size_t at = what.byte() % descriptors_.size();
            descriptors_[at] = static_cast<std::uint8_t>(what.byte());
        }
        if (what.byte() % 8 == 7)
            descriptors_.resize(what.byte());
    }

    std::vector<std::uint8_t> descriptors() const override { return descriptors_; }

    bool control(const sim::UsbSetup& setup, const std::uint8_t* out,
                 std::vector<std::uint8_t>& in) override {
        const unsigned how = script_.byte();
        if (how >= 250)
            return false;
        if (!honest_.control(setup, out, in) && how < 200)
            return false;
        if ((setup.type & 0x80) == 0)
            return true;
        if (how >= 64) { // some bytes are changed, missing, or too many
            const unsigned kind = how % 4;
            if (kind == 0)
                in.resize(script_.byte() % (in.size() + 1));
            if (kind == 1)
                in.resize(setup.length);
            for (unsigned left = kind == 3 ? 4 : 1; left > 0 && !in.empty(); --left) {
                const std::size_t at = script_.byte() % in.size();
                in[at] = static_cast<std::uint8_t>(script_.byte());
            }
            if (kind == 2)
                in.clear();
        }
        in.resize(std::min<std::size_t>(in.size(), setup.length)); // the bus cuts longer replies
        return true;
    }
    bool bulk_out(std::uint8_t endpoint, const std::uint8_t* bytes, std::size_t count) override {
        const unsigned how = script_.byte();
        if (how >= 240)
            return false;
        (void)honest_.bulk_out(endpoint, bytes, count); // the device does not tell where this went wrong
        return true;
    }
    bool bulk_in(std::uint8_t, std::size_t, std::vector<std::uint8_t>&) override { return false; }
    void clear_halt() override { honest_.clear_halt(); }

    sim::UsbFate fate() {
        constexpr sim::UsbFate fates[] = {sim::UsbFate::cut, sim::UsbFate::stall, sim::UsbFate::error,
                                          sim::UsbFate::silent, sim::UsbFate::unplug};
        const unsigned how = script_.byte();
        return how < 224 ? sim::UsbFate::normal : fates[how % std::size(fates)];
    }

  private:
    sim::GudDevice honest_;
    std::vector<std::uint8_t> descriptors_;
    Script script_;
};

/// Writes every byte of the frame, and marks all of it touched.
void draw(hal::GudDisplay& display, unsigned seed) {
    const auto frame = display.acquire();
    if (!frame.ok())
        return;
    const hal::DisplayInfo info = display.info();
    const hal::Frame& f = frame.value();
    for (std::int32_t y = 0; y < info.height; ++y) {
        std::memset(f.pixels + std::ptrdiff_t{y} * f.stride,
                    static_cast<int>(seed + static_cast<unsigned>(y)),
                    static_cast<std::size_t>(info.width) * 2);
        const auto begin = static_cast<std::int16_t>(seed % 3 == 0 ? 0 : seed % 40);
        f.extents->rows[y] = {begin, static_cast<std::int16_t>(std::max(begin + 1, info.width))};
    }
    f.extents->cleared = seed % 4 == 0;
    f.extents->clear_value = seed;
}

void expect(bool holds, const char* what) {
    if (holds)
        return;
    std::fprintf(stderr, "GUD stream: %s\n", what);
    std::abort();
}

} // namespace

void run_gud_stream(const std::uint8_t* data, std::size_t bytes) {
    // A third of the stream each is for the device, for its answers, and for what the program does.
    const std::size_t third = bytes / 3;
    HostileDevice device(Script(data, third), Script(data + third, third));
    Script program(data + 2 * third, bytes - 2 * third);
    sim::Kernel& kernel = sim::Kernel::instance();
    sim::UsbfsDevice usb(device);
    usb.fate = [&](std::size_t) { return device.fate(); };
    usb.attach(kernel, path);
    {
        hal::GudConfig config;
        config.device_file = path;
        config.control_timeout_ms = config.bulk_timeout_ms = 5;
        config.poll_ms = 1;
        const unsigned how = program.byte();
        config.compress = (how & 1) == 0;
        config.pacing = static_cast<hal::Pacing>((how >> 1) % 3);
        if ((how & 8) != 0) {
            config.width = size(program);
            config.height = size(program);
        }
        hal::GudDisplay display(config);
        bool up = display.init().ok();
        std::int64_t sent = 0; // about how many pixels; the largest pictures take a second each
        for (int steps = 0; steps < 24 && program.more() && sent < 1 << 22; ++steps) {
            const unsigned what = program.byte();
            const hal::DisplayInfo info = display.info();
            const std::int64_t pixels = std::int64_t{info.width} * info.height;
            expect(info.width >= 0 && info.width <= INT16_MAX && info.height >= 0 && info.height <= 4096 &&
                       pixels <= 1 << 24 && (!up || pixels > 0),
                   "a size that cannot be drawn was taken");
            sent += what % 8 == 0 || what % 8 > 4 ? pixels : 0;
            switch (what % 8) {
            case 0:
                up = display.init().ok();
                break;
            case 1:
                (void)display.finish();
                break;
            case 2:
                usb.unplug();
                break;
            case 3:
                usb.plug();
                break;
            case 4:
                display.swap_interval(static_cast<std::int32_t>(what / 8 % 2));
                break;
            default:
                if (up) {
                    draw(display, what);
                    (void)display.present();
                }
            }
        }
    }
    expect(kernel.open_files() == 0, "files were left open");
    kernel.forget_all();
}

} // namespace gud_test

// Looking for a display, and its coming and going, as the whole machine has them: real libusb, real libudev,
// on the /sys, /dev and usbfs that umockdev shows this process (layer C).
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <mutex>

#include <gtest/gtest.h>
#include <linux/usbdevice_fs.h>
#include <spangle/usb/gud_display.hpp>
#include <sys/ioctl.h>
#include <umockdev.h>
#include <unistd.h>

#include "host_sim/usb/gud_device.hpp"

namespace {

using namespace spangle;
using hal::Fault;

/// A device of the test bed, its usbfs file answered by a UsbFunction.
class PluggedIn {
  public:
    PluggedIn(UMockdevTestbed* bed, sim::UsbFunction& function, int number)
        : bed_(bed), function_(function), number_(number) {
        const auto bytes = function.descriptors();
        std::string hex;
        for (const std::uint8_t byte : bytes) {
            char digits[3];
            std::snprintf(digits, sizeof digits, "%02X", byte);
            hex += digits;
        }
        const std::string n = std::to_string(number), node = "bus/usb/001/00" + n;
        const std::string text =
            "P: /devices/pci0000:00/usb1/1-" + n + "\nN: " + node + "=" + hex +
            "\nE: BUSNUM=001\nE: DEVNUM=00" + n + "\nE: DEVNAME=/dev/" + node +
            "\nE: DEVTYPE=usb_device\nE: MAJOR=189\nE: MINOR=" + n +
            "\nE: SUBSYSTEM=usb\nA: bConfigurationValue=1\\n\nA: busnum=1\\n\nA: devnum=" + n +
            "\\n\nA: speed=480\\n\nH: descriptors=" + hex + "\n\n";
        GError* error = nullptr;
        EXPECT_TRUE(umockdev_testbed_add_from_string(bed, text.c_str(), &error))
            << (error ? error->message : "");
        handler_ = umockdev_ioctl_base_new();
        g_signal_connect(handler_, "handle-ioctl", G_CALLBACK(&PluggedIn::on_ioctl), this);
        EXPECT_TRUE(umockdev_testbed_attach_ioctl(bed, ("/dev/" + node).c_str(), handler_, &error));
    }
    PluggedIn(const PluggedIn&) = delete;
    PluggedIn& operator=(const PluggedIn&) = delete;
    ~PluggedIn() {
        const std::string n = std::to_string(number_), sys = "/sys/devices/pci0000:00/usb1/1-" + n;
        umockdev_testbed_uevent(bed_, sys.c_str(), "remove");
        umockdev_testbed_detach_ioctl(bed_, ("/dev/bus/usb/001/00" + n).c_str(), nullptr);
        umockdev_testbed_remove_device(bed_, sys.c_str());
        g_object_unref(handler_);
    }
    /// The wire is cut: calls fail from now on.
    void pull() {
        const std::lock_guard lock(mutex_);
        pulled_ = true;
    }

  private:
    struct Request {
        UMockdevIoctlData* urb;
        UMockdevIoctlData* buffer;
    };
    UMockdevTestbed* bed_;
    sim::UsbFunction& function_;
    int number_;
    UMockdevIoctlBase* handler_ = nullptr;
    std::mutex mutex_;
    std::deque<Request> requests_;
    bool pulled_ = false;

    static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
        const long answer = static_cast<PluggedIn*>(self)->answer(umockdev_ioctl_client_get_request(client),
                                                                  umockdev_ioctl_client_get_arg(client));
        umockdev_ioctl_client_complete(client, answer < 0 ? -1 : answer,
                                       answer < 0 ? static_cast<int>(-answer) : 0);
        return TRUE;
    }

    long answer(unsigned long request, UMockdevIoctlData* argument) {
        const std::lock_guard lock(mutex_);
        if (pulled_ && request != USBDEVFS_REAPURBNDELAY)
            return -ENODEV;
        switch (request) {
        case USBDEVFS_GET_CAPABILITIES: {
            UMockdevIoctlData* const data = umockdev_ioctl_data_resolve(argument, 0, 4, nullptr);
            std::uint32_t caps = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_BULK_CONTINUATION |
                                 USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
            umockdev_ioctl_data_update(data, 0, reinterpret_cast<guint8*>(&caps), 4);
            return 0;
        }
        case USBDEVFS_GETDRIVER:
            return -ENODATA;
        case USBDEVFS_CLAIMINTERFACE:
        case USBDEVFS_RELEASEINTERFACE:
        case USBDEVFS_DISCONNECT_CLAIM:
        case USBDEVFS_IOCTL:
            return 0;
        case USBDEVFS_CLEAR_HALT:
            function_.clear_halt();
            return 0;
        case USBDEVFS_SUBMITURB:
            return submit(argument);
        case USBDEVFS_REAPURBNDELAY:
            return reap(argument);
        default:
            return request == USBDEVFS_DISCARDURB ? -EINVAL : -ENOTTY;
        }
    }

    long submit(UMockdevIoctlData* argument) {
        UMockdevIoctlData* const data =
            umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_urb), nullptr);
        const auto* const urb = reinterpret_cast<const usbdevfs_urb*>(data->data);
        UMockdevIoctlData* buffer = nullptr;
        if (urb->buffer_length > 0)
            buffer = umockdev_ioctl_data_resolve(data, offsetof(usbdevfs_urb, buffer),
                                                 static_cast<gsize>(urb->buffer_length), nullptr);
        requests_.push_back(
            {static_cast<UMockdevIoctlData*>(g_object_ref(data)),
             buffer != nullptr ? static_cast<UMockdevIoctlData*>(g_object_ref(buffer)) : nullptr});
        return 0;
    }

    long reap(UMockdevIoctlData* argument) {
        if (requests_.empty())
            return pulled_ ? -ENODEV : -EAGAIN;
        const Request r = requests_.front();
        requests_.pop_front();
        auto* const urb = reinterpret_cast<usbdevfs_urb*>(r.urb->data);
        urb->actual_length = 0;
        urb->status = pulled_ ? -ESHUTDOWN : run(*urb, r.buffer);
        umockdev_ioctl_data_update(r.urb, 0, r.urb->data, sizeof *urb);
        umockdev_ioctl_data_set_ptr(umockdev_ioctl_data_resolve(argument, 0, sizeof(void*), nullptr), 0,
                                    r.urb);
        return 0;
    }

    int run(usbdevfs_urb& urb, UMockdevIoctlData* buffer) {
        std::uint8_t* const bytes = buffer->data;
        if (urb.type == USBDEVFS_URB_TYPE_BULK) {
            urb.actual_length = urb.buffer_length;
            return function_.bulk_out(bytes, static_cast<std::size_t>(urb.buffer_length)) ? 0 : -EPIPE;
        }
        const auto word = [&](int at) { return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8); };
        const sim::UsbSetup setup = {bytes[0], bytes[1], word(2), word(4), word(6)};
        std::vector<std::uint8_t> in;
        if (!function_.control(setup, bytes + 8, in))
            return -EPIPE;
        if (!in.empty())
            umockdev_ioctl_data_update(buffer, 8, in.data(), in.size());
        urb.actual_length = static_cast<int>((setup.type & 0x80) != 0 ? in.size() : setup.length);
        return 0;
    }
};

struct Hotplug : testing::Test {
    UMockdevTestbed* bed = umockdev_testbed_new();
    sim::GudDevice device, other;
    hal::GudConfig config;

    Hotplug() {
        device.modes = {{1000, 24, 16, true}};
        device.limits = {24, 24, 16, 16};
        other = device;
        other.vendor = 0x1d6b; // a hub, that happens to have such an interface
        other.product = 0x0002;
    }
    ~Hotplug() override { g_object_unref(bed); }

    static hal::Result<void> show(hal::GudDisplay& display, std::uint8_t value) {
        const auto frame = display.acquire();
        if (!frame)
            return frame.error();
        std::fill(frame.value().pixels, frame.value().pixels + 24 * 16 * 2, value);
        std::fill(frame.value().extents->rows, frame.value().extents->rows + 16, RowSpan{0, 24});
        return display.present();
    }
    static bool shows(const sim::GudDevice& d, std::uint8_t value) {
        const sim::Image glass = d.glass();
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 24; ++x)
                if (glass.at(x, y)[0] != (value >> 3) * 255 / 31)
                    return false;
        return d.violations().empty();
    }
};

TEST_F(Hotplug, FindsADisplayAmongOtherDevices) {
    for (const auto& [vendor, product] : {std::pair{0x1d50, 0x614d}, {0x16d0, 0x10a9}, {0x1209, 0x4fb3}}) {
        device.vendor = static_cast<std::uint16_t>(vendor);
        device.product = static_cast<std::uint16_t>(product);
        PluggedIn hub(bed, other, 1), plugged(bed, device, 2);
        hal::GudDisplay display;
        const auto ready = display.init();
        ASSERT_TRUE(ready.ok()) << ready.error().rule;
        EXPECT_TRUE(show(display, 0xF0).ok());
        EXPECT_TRUE(shows(device, 0xF0));
        EXPECT_EQ(other.counters().requests, 0u) << "nobody asked the other device anything";
    }
}

TEST_F(Hotplug, TakesTheOneThatWasAskedFor) {
    other.vendor = 0x4242;
    PluggedIn first(bed, device, 1), second(bed, other, 2);
    config.vendor = 0x4242;
    config.product = 0x0002;
    hal::GudDisplay display(config);
    ASSERT_TRUE(display.init().ok());
    EXPECT_TRUE(show(display, 0x88).ok());
    EXPECT_TRUE(shows(other, 0x88));
    EXPECT_EQ(device.counters().requests, 0u);
}

TEST_F(Hotplug, PulledAndPluggedAgain) {
    PluggedIn hub(bed, other, 1);
    hal::GudDisplay display;
    const auto none = display.init();
    EXPECT_EQ(none.error().fault, Fault::gone);
    EXPECT_STREQ(none.error().rule, "USB display: open: none is plugged in; lsusb lists what is");
    {
        PluggedIn plugged(bed, device, 2);
        ASSERT_TRUE(display.init().ok());
        ASSERT_TRUE(show(display, 0x18).ok());
        plugged.pull();
        EXPECT_EQ(show(display, 0x28).error().fault, Fault::gone);
        EXPECT_FALSE(display.connected());
    }
    EXPECT_EQ(show(display, 0x38).error().fault, Fault::gone);
    device.power_cycle();
    PluggedIn again(bed, device, 3); // another number, as the bus gives it
    ASSERT_TRUE(display.present().ok());
    EXPECT_TRUE(shows(device, 0x38));
    EXPECT_TRUE(display.connected());
}

} // namespace

/// Under umockdev's wrapper, which must be there before the program is.
int main(int argc, char** argv) {
    const char* const preloaded = std::getenv("LD_PRELOAD");
    if (preloaded == nullptr || std::strstr(preloaded, "umockdev") == nullptr) {
        std::vector<char*> words = {const_cast<char*>("umockdev-wrapper")};
        words.insert(words.end(), argv, argv + argc + 1);
        execvp(words[0], words.data());
        std::perror("umockdev-wrapper");
        return 1;
    }
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}

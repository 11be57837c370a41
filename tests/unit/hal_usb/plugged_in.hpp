// A USB device in the /sys, /dev and usbfs that umockdev shows to this process (layer C). libusb and libudev
// are real.
#pragma once

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <deque>
#include <mutex>
#include <string>

#include <gtest/gtest.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <umockdev.h>

#include "host_sim/usb/usb_function.hpp"

namespace umockdev_test {

using namespace spangle;

/// A device of the test bed; a UsbFunction answers for its usbfs file.
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
        g_signal_handlers_disconnect_by_data(handler_, this); // files may still be open
        g_object_unref(handler_);
    }
    /// Cuts the wire: calls fail from now on.
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
        if (urb.type == USBDEVFS_URB_TYPE_BULK && (urb.endpoint & 0x80) != 0) {
            std::vector<std::uint8_t> in;
            if (!function_.bulk_in(urb.endpoint, static_cast<std::size_t>(urb.buffer_length), in))
                return -EPIPE;
            umockdev_ioctl_data_update(buffer, 0, in.data(), in.size());
            urb.actual_length = static_cast<int>(in.size());
            return 0;
        }
        if (urb.type == USBDEVFS_URB_TYPE_BULK) {
            urb.actual_length = urb.buffer_length;
            return function_.bulk_out(urb.endpoint, bytes, static_cast<std::size_t>(urb.buffer_length))
                       ? 0
                       : -EPIPE;
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

} // namespace umockdev_test

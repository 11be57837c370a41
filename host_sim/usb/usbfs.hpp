// A USB device behind usbfs (/dev/bus/usb/BBB/DDD): what libusb does to it reaches a UsbFunction. From
// include/uapi/linux/usbdevice_fs.h and drivers/usb/core/devio.c. The file is the write end of a small pipe,
// because libusb polls it: room in the pipe means that a transfer is done, a closed pipe that the device
// went.
#pragma once

#include <deque>
#include <functional>

#include "host_sim/linux/kernel.hpp"
#include "host_sim/usb/usb_function.hpp"

struct usbdevfs_urb;

namespace spangle::sim {

class UsbfsFile;

class UsbfsDevice final : public Device {
  public:
    explicit UsbfsDevice(UsbFunction& function) : function_(function) {}
    void attach(Kernel& kernel, const std::string& path);

    using Fate = UsbFate;
    /// Of a transfer of `count` bytes.
    std::function<Fate(std::size_t count)> fate;
    bool kernel_driver = false; ///< somebody has the interface, and is asked to let go
    bool claimed_elsewhere = false;
    int most_under_way = 0; ///< bulk transfers at a time, so far

    /// As when the plug is pulled: open files hang up.
    void unplug();
    void plug();

    std::unique_ptr<OpenFile> open() override;
    int gone_error() const override;

  private:
    friend class UsbfsFile;
    UsbFunction& function_;
    Kernel* kernel_ = nullptr;
    std::string path_;
    std::deque<UsbfsFile*> files_;
};

} // namespace spangle::sim

// A USB device behind usbfs (/dev/bus/usb/BBB/DDD), which passes what libusb does on to a UsbFunction. It is
// written from include/uapi/linux/usbdevice_fs.h and drivers/usb/core/devio.c. The file is the write end of a
// small pipe, because libusb polls it. Room in the pipe means that a transfer is done, and a closed pipe that
// the device is gone.
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
    /// Decides what happens to a transfer of `count` bytes.
    std::function<Fate(std::size_t count)> fate;
    bool kernel_driver = false; ///< a kernel driver has the interface, and is asked to let go
    bool claimed_elsewhere = false;
    int most_under_way = 0; ///< most bulk transfers at the same time, so far

    /// Removes the device as when its plug is pulled: open files hang up.
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

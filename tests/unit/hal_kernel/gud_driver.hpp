// Waits until the kernel's own gud driver has a device, and until it has let go of the device.
#pragma once

#include <string>

#include "tests/unit/hal_kernel/files.hpp"

namespace kernel_test {

inline constexpr char gud_card[] = "/dev/dri/card0";

inline void await_gud_driver() {
    await("bring its gud driver up", [] { return exists(gud_card); });
}

/// `device` is the name of usbcore, "2-1". The driver waits up to three seconds for a transfer under way.
inline void await_no_device(const std::string& device) {
    await(
        "let go of the device",
        [&] { return !exists(gud_card) && !exists("/sys/bus/usb/devices/" + device); },
        std::chrono::seconds(10));
}

/// Unbinds the driver while the device still answers.
inline void dismiss_gud_driver(const std::string& device) {
    if (exists("/sys/bus/usb/drivers/gud/" + device + ":1.0"))
        write_text("/sys/bus/usb/drivers/gud/unbind", device + ":1.0");
}

} // namespace kernel_test

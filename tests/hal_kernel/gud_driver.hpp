// The kernel's own gud driver: when it has a device, and when it has let go of it.
#pragma once

#include <string>

#include "tests/hal_kernel/files.hpp"

namespace kernel_test {

inline constexpr char gud_card[] = "/dev/dri/card0";

inline void await_gud_driver() {
    await("bring its gud driver up", [] { return exists(gud_card); });
}

/// `device`: as usbcore names it, "2-1". The driver waits up to three seconds for a transfer that was under
/// way.
inline void await_no_device(const std::string& device) {
    await(
        "let go of the device",
        [&] { return !exists(gud_card) && !exists("/sys/bus/usb/devices/" + device); },
        std::chrono::seconds(10));
}

/// While the device still answers.
inline void dismiss_gud_driver(const std::string& device) {
    if (exists("/sys/bus/usb/drivers/gud/" + device + ":1.0"))
        write_text("/sys/bus/usb/drivers/gud/unbind", device + ":1.0");
}

} // namespace kernel_test

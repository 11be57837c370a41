// A build without libftdi1: FTDI chips cannot be controlled, and errors say so.
#include "hal/usb/ftdi_control.hpp"

namespace spangle::hal {

FtdiControl::FtdiControl() = default;
FtdiControl::~FtdiControl() {
    release();
}

void FtdiControl::release() {}

Result<void> FtdiControl::take_device(UsbLink& link, std::uint8_t) {
    return link.say(Fault::unsupported, "open", "this build has no libftdi1");
}

Result<void> FtdiControl::start_mpsse() {
    return Error{Fault::unsupported, "this build has no libftdi1"};
}

} // namespace spangle::hal

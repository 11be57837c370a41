#include "hal/usb/ftdi_control.hpp"

#include <ftdi.h>

namespace spangle::hal {
namespace {

/// The latency timer, in milliseconds: after this time the chip sends what waits in it, unless the stream
/// asks for it before (87h).
constexpr unsigned char latency_ms = 1;

} // namespace

FtdiControl::FtdiControl() = default;

FtdiControl::~FtdiControl() {
    release();
}

void FtdiControl::release() {
    if (context_ == nullptr)
        return;
    ftdi_set_usbdev(context_, nullptr);
    ftdi_free(context_);
    context_ = nullptr;
}

Result<void> FtdiControl::take_device(UsbLink& link, std::uint8_t channel) {
    release();
    link_ = &link;
    context_ = ftdi_new();
    if (context_ == nullptr)
        return link.say(Fault::no_answer, "start libftdi", "out of memory");
    ftdi_set_interface(context_, channel == 0 ? INTERFACE_A : INTERFACE_B);
    ftdi_set_usbdev(context_, link.handle());
    return {};
}

Result<void> FtdiControl::start_mpsse() {
    if (ftdi_usb_reset(context_) == 0 && ftdi_tcioflush(context_) == 0 &&
        ftdi_set_latency_timer(context_, latency_ms) == 0 &&
        ftdi_set_bitmode(context_, 0, BITMODE_RESET) == 0 &&
        ftdi_set_bitmode(context_, 0, BITMODE_MPSSE) == 0)
        return {};
    const auto alive = link_->check_alive("set up");
    return alive ? link_->say(Fault::no_answer, "set up", ftdi_get_error_string(context_)) : alive;
}

} // namespace spangle::hal

// Controls an FTDI chip beside its bulk pipes, through libftdi1: reset, latency, mode.
#pragma once

#include <cstdint>
#include <memory>

#include "hal/usb/usb_link.hpp"

struct ftdi_context;

namespace spangle::hal {

class FtdiControl {
  public:
    FtdiControl();
    ~FtdiControl();
    FtdiControl(const FtdiControl&) = delete;
    FtdiControl& operator=(const FtdiControl&) = delete;

    /// Controls the chip behind this link, which keeps owning it: release() must come before the link closes.
    Result<void> take_device(UsbLink& link, std::uint8_t channel);
    void release();
    /// Empties the chip's buffers and puts it into MPSSE mode: all pins inputs, the engine as after power-on.
    Result<void> start_mpsse();

  private:
    ftdi_context* context_ = nullptr;
    UsbLink* link_ = nullptr;
};

} // namespace spangle::hal

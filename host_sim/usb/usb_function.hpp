// A USB device as its firmware sees it: descriptors, control requests and bulk pipes. Other classes carry the
// packets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spangle::sim {

struct UsbSetup {
    std::uint8_t type = 0, request = 0; ///< USB's bmRequestType and bRequest
    std::uint16_t value = 0, index = 0, length = 0;
};

/// What happens to a bulk transfer on its way to a device.
enum class UsbFate {
    normal,
    cut,    ///< half of the transfer arrives, and the controller reports success
    stall,  ///< the endpoint halts
    silent, ///< never done: the timeout of the host ends the transfer
    unplug, ///< the device goes away during the transfer
    error,  ///< the controller reports a protocol error
};

class UsbFunction {
  public:
    virtual ~UsbFunction() = default;
    /// The device descriptor, followed by the only configuration.
    virtual std::vector<std::uint8_t> descriptors() const = 0;
    /// Answers a control request. `out` is the data stage of a request to the device; `in` takes that of a
    /// request from the device, at most `setup.length` bytes. Returns false to stall.
    virtual bool control(const UsbSetup& setup, const std::uint8_t* out, std::vector<std::uint8_t>& in) = 0;
    /// Takes a bulk transfer. Returns false to stall, until the halt is cleared.
    virtual bool bulk_out(std::uint8_t endpoint, const std::uint8_t* bytes, std::size_t count) = 0;
    /// Puts what the device sends now into `in`, at most `most` bytes. Returns false to stall.
    virtual bool bulk_in(std::uint8_t endpoint, std::size_t most, std::vector<std::uint8_t>& in) = 0;
    virtual void clear_halt() = 0;
};

} // namespace spangle::sim

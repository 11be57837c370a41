// A USB device as its firmware sees it: descriptors, control requests, bulk pipes. Nothing of how packets
// travel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spangle::sim {

struct UsbSetup {
    std::uint8_t type = 0, request = 0; ///< bmRequestType, bRequest
    std::uint16_t value = 0, index = 0, length = 0;
};

/// What becomes of a bulk transfer on its way to a device.
enum class UsbFate {
    normal,
    cut,    ///< half of it arrives, and the controller calls that done
    stall,  ///< the endpoint halts
    silent, ///< never done: the host's timeout ends it
    unplug, ///< the device goes, with the transfer under way
    error,  ///< the controller reports a protocol error
};

class UsbFunction {
  public:
    virtual ~UsbFunction() = default;
    /// Device descriptor, then the one configuration.
    virtual std::vector<std::uint8_t> descriptors() const = 0;
    /// `out`: the data stage of a request to the device; `in`: of one from it, at most `setup.length` bytes.
    /// False: STALL.
    virtual bool control(const UsbSetup& setup, const std::uint8_t* out, std::vector<std::uint8_t>& in) = 0;
    /// False: STALL, until the halt is cleared.
    virtual bool bulk_out(std::uint8_t endpoint, const std::uint8_t* bytes, std::size_t count) = 0;
    /// What the device sends now, at most `most` bytes. False: STALL.
    virtual bool bulk_in(std::uint8_t endpoint, std::size_t most, std::vector<std::uint8_t>& in) = 0;
    virtual void clear_halt() = 0;
};

} // namespace spangle::sim

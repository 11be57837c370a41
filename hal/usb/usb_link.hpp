// One interface of a USB device through libusb: control requests, and a bulk pipe with two transfers in
// flight.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/linux/error_text.hpp>

struct libusb_context;
struct libusb_device;
struct libusb_device_handle;

namespace spangle::hal {

struct UsbId {
    std::uint16_t vendor = 0, product = 0;
};

class UsbLink {
  public:
    UsbLink() = default;
    ~UsbLink();
    UsbLink(const UsbLink&) = delete;
    UsbLink& operator=(const UsbLink&) = delete;

    /// The first device of these with a vendor interface and a bulk output that can be claimed; a kernel
    /// driver lets go of it until close().
    Result<void> open(const UsbId* ids, std::size_t count);
    /// The device behind this usbfs file.
    Result<void> open_file(const char* path);
    void close();
    bool opened() const { return handle_ != nullptr; }

    /// Vendor requests to the interface. `name`: what errors call it. The bytes that came.
    Result<std::size_t> get(const char* name, std::uint8_t request, std::uint16_t value, std::uint8_t* into,
                            std::size_t count, std::uint32_t timeout_ms);
    Result<void> set(const char* name, std::uint8_t request, std::uint16_t value, const std::uint8_t* from,
                     std::size_t count, std::uint32_t timeout_ms);
    /// Returns when everything is with the device, or nothing is under way any more.
    Result<void> send(const std::uint8_t* bytes, std::size_t count, std::uint32_t timeout_ms);
    /// The device refused the last request: a STALL.
    bool refused() const { return refused_; }
    Result<void> clear_halt();
    Error say(Fault fault, const char* operation, const char* cause) {
        return error_.say(fault, name_, operation, cause);
    }

  private:
    libusb_context* context_ = nullptr;
    libusb_device_handle* handle_ = nullptr;
    int file_ = -1;
    int interface_ = 0;
    std::uint8_t endpoint_ = 0;
    bool refused_ = false;
    ErrorText error_;
    char name_[48] = "USB display";

    Result<void> start();
    bool find_pipe(libusb_device* device);
    Result<void> claim();
    Error failed(const char* operation, int code);
};

} // namespace spangle::hal

// One interface of a USB device through libusb: control requests, and bulk pipes, the outward one with two
// transfers in flight.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

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
    static constexpr int any_interface = -1;

    /// `noun` is what errors call the device.
    explicit UsbLink(const char* noun = "USB display");
    ~UsbLink();
    UsbLink(const UsbLink&) = delete;
    UsbLink& operator=(const UsbLink&) = delete;

    /// Opens the first device of these IDs that has a vendor interface and a bulk output that can be claimed.
    /// A kernel driver lets go of it until close().
    Result<void> open(const UsbId* ids, std::size_t count, int interface = any_interface);
    /// Opens the device behind this usbfs file.
    Result<void> open_file(const char* path, int interface = any_interface);
    void close();
    bool opened() const { return handle_ != nullptr; }
    libusb_device_handle* handle() const { return handle_; }
    /// Fails if the device is gone. It serves libraries that do not report this.
    Result<void> check_alive(const char* operation);

    /// Vendor requests to the interface. `name`: what errors call the request. get() returns how many bytes
    /// came.
    Result<std::size_t> get(const char* name, std::uint8_t request, std::uint16_t value, std::uint8_t* into,
                            std::size_t count, std::uint32_t timeout_ms);
    Result<void> set(const char* name, std::uint8_t request, std::uint16_t value, const std::uint8_t* from,
                     std::size_t count, std::uint32_t timeout_ms);
    /// Sends bytes. Returns when all are with the device, or after an error when none are under way any more.
    Result<void> send(const std::uint8_t* bytes, std::size_t count, std::uint32_t timeout_ms);

    // send() in steps. An error leaves nothing under way, and may be that of an earlier step.
    /// Hands a piece over. It must stay until settle(), or until make_room() was called after the next piece.
    Result<void> push(const std::uint8_t* bytes, std::size_t count, std::uint32_t timeout_ms);
    /// Returns when another piece can be pushed: all but the last have left.
    Result<void> make_room();
    Result<void> settle();

    /// Receives what the device sends, at most `count` bytes, in whole packets: a packet that is not full
    /// ends it.
    Result<std::size_t> read_bulk(std::uint8_t* into, std::size_t count, std::uint32_t timeout_ms);
    std::size_t packet_bytes() const { return max_packet_bytes_; } ///< bytes of a packet of read_bulk()
    /// Whether the device refused the last request by a STALL.
    bool is_refused() const { return is_refused_; }
    Result<void> clear_halt();
    Error say(Fault fault, const char* operation, const char* cause) {
        return error_.say(fault, name_, operation, cause);
    }

  private:
    struct BulkTransfer;
    const char* device_noun_;
    libusb_context* context_ = nullptr;
    libusb_device_handle* handle_ = nullptr;
    int file_ = -1;
    int interface_ = 0;
    std::uint8_t out_endpoint_ = 0, in_endpoint_ = 0; ///< numbers of the endpoints; 0: there is none
    std::size_t max_packet_bytes_ = 0;
    bool is_refused_ = false;
    std::unique_ptr<BulkTransfer[]> transfers_; ///< two transfers, which take the pieces in turn
    unsigned submitted_count_ = 0, completed_count_ = 0;
    ErrorText error_;
    char name_[48] = "";

    Result<void> start();
    void set_name(libusb_device* device);
    bool find_pipe(libusb_device* device, int interface);
    Result<void> settle_to(unsigned under_way);
    void take_back();
    Error close_after_error(int code);
    Result<void> claim_interface();
    Error failed(const char* operation, int code);
};

} // namespace spangle::hal

#include "hal/usb/usb_link.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>

#include <fcntl.h>
#include <libusb.h>
#include <sys/time.h>
#include <unistd.h>

namespace spangle::hal {
namespace {

/// Bytes of a piece, a multiple of any packet size. Two pieces keep the wire busy while the next is handed
/// over.
constexpr std::size_t piece_bytes = 32768;

/// Not a code of libusb: the device took less than it was sent.
constexpr int cut_short = -1000;

constexpr std::uint8_t to_interface =
    std::uint8_t{LIBUSB_REQUEST_TYPE_VENDOR} | std::uint8_t{LIBUSB_RECIPIENT_INTERFACE};

Fault fault_of(int code) {
    switch (code) {
    case LIBUSB_ERROR_ACCESS:
        return Fault::denied;
    case LIBUSB_ERROR_BUSY:
        return Fault::busy;
    case LIBUSB_ERROR_TIMEOUT:
        return Fault::timeout;
    case cut_short:
        return Fault::short_write;
    case LIBUSB_ERROR_NO_DEVICE: // an unplugged device gives this or LIBUSB_ERROR_IO
    case LIBUSB_ERROR_IO:
    case LIBUSB_ERROR_NOT_FOUND:
        return Fault::gone;
    case LIBUSB_ERROR_PIPE:
    case LIBUSB_ERROR_NOT_SUPPORTED:
    case LIBUSB_ERROR_INVALID_PARAM:
        return Fault::unsupported;
    default:
        return Fault::no_answer;
    }
}

int code_of(libusb_transfer_status status) {
    switch (status) {
    case LIBUSB_TRANSFER_COMPLETED:
        return LIBUSB_SUCCESS;
    case LIBUSB_TRANSFER_TIMED_OUT:
        return LIBUSB_ERROR_TIMEOUT;
    case LIBUSB_TRANSFER_STALL:
        return LIBUSB_ERROR_PIPE;
    case LIBUSB_TRANSFER_NO_DEVICE:
        return LIBUSB_ERROR_NO_DEVICE;
    case LIBUSB_TRANSFER_CANCELLED:
        return LIBUSB_ERROR_INTERRUPTED;
    default:
        return LIBUSB_ERROR_IO;
    }
}

/// The first bulk endpoint of that direction, or null. A device may say that it has more endpoints than it
/// describes, which libusb repeats: then none are there.
const libusb_endpoint_descriptor* bulk_endpoint(const libusb_interface_descriptor& side, int direction) {
    for (int e = 0; side.endpoint != nullptr && e < side.bNumEndpoints; ++e) {
        const libusb_endpoint_descriptor& endpoint = side.endpoint[e];
        if ((endpoint.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) == LIBUSB_TRANSFER_TYPE_BULK &&
            (endpoint.bEndpointAddress & LIBUSB_ENDPOINT_DIR_MASK) == direction)
            return &endpoint;
    }
    return nullptr;
}

} // namespace

/// A transfer of the pipe, used again and again.
struct UsbLink::BulkTransfer {
    libusb_transfer* transfer = libusb_alloc_transfer(0);
    int done = 1;

    BulkTransfer() = default;
    BulkTransfer(const BulkTransfer&) = delete;
    BulkTransfer& operator=(const BulkTransfer&) = delete;
    ~BulkTransfer() { libusb_free_transfer(transfer); }
    static void LIBUSB_CALL finished(libusb_transfer* t) { *static_cast<int*>(t->user_data) = 1; }

    int submit(libusb_device_handle* handle, std::uint8_t endpoint, const std::uint8_t* bytes,
               std::size_t count, std::uint32_t timeout_ms) {
        libusb_fill_bulk_transfer(transfer, handle, endpoint, const_cast<std::uint8_t*>(bytes),
                                  static_cast<int>(count), &finished, &done, timeout_ms);
        done = 0;
        return libusb_submit_transfer(transfer);
    }
    /// Waits until the transfer has ended or timed out.
    int complete(libusb_context* context) {
        while (done == 0) {
            timeval patience{0, 100000};
            libusb_handle_events_timeout_completed(context, &patience, &done);
        }
        const int code = code_of(transfer->status);
        return code == LIBUSB_SUCCESS && transfer->actual_length != transfer->length ? cut_short : code;
    }
};

UsbLink::UsbLink(const char* noun) : device_noun_(noun) {
    std::snprintf(name_, sizeof name_, "%s", noun);
}

UsbLink::~UsbLink() {
    close();
}

void UsbLink::close() {
    take_back();
    transfers_.reset();
    if (handle_ != nullptr) {
        libusb_release_interface(handle_, interface_); // gives the device back to the kernel's driver
        libusb_close(handle_);
    }
    handle_ = nullptr;
    if (context_ != nullptr)
        libusb_exit(context_);
    context_ = nullptr;
    if (file_ >= 0)
        ::close(file_);
    file_ = -1;
}

Error UsbLink::failed(const char* operation, int code) {
    is_refused_ = code == LIBUSB_ERROR_PIPE;
    const char* cause = libusb_strerror(code);
    if (code == LIBUSB_ERROR_ACCESS)
        cause = "permission denied; install the udev rules 60-spangle.rules and join group 'plugdev'";
    if (code == LIBUSB_ERROR_BUSY)
        cause = "another program has the device";
    if (code == cut_short)
        cause = "the device took less than it was sent";
    return error_.say(fault_of(code), name_, operation, cause);
}

// --- Opening

Result<void> UsbLink::start() {
    close();
    const int code = libusb_init(&context_);
    return code == LIBUSB_SUCCESS ? Result<void>{} : failed("start libusb", code);
}

/// Finds a vendor interface with a bulk output.
bool UsbLink::find_pipe(libusb_device* device, int interface) {
    libusb_config_descriptor* config = nullptr;
    if (libusb_get_active_config_descriptor(device, &config) != LIBUSB_SUCCESS)
        return false;
    bool found = false;
    for (int i = 0; i < config->bNumInterfaces && !found; ++i) {
        const libusb_interface_descriptor& side = config->interface[i].altsetting[0];
        if (interface != any_interface && interface != side.bInterfaceNumber)
            continue;
        const libusb_endpoint_descriptor* const out = bulk_endpoint(side, LIBUSB_ENDPOINT_OUT);
        const libusb_endpoint_descriptor* const in = bulk_endpoint(side, LIBUSB_ENDPOINT_IN);
        found = side.bInterfaceClass == LIBUSB_CLASS_VENDOR_SPEC && out != nullptr;
        interface_ = side.bInterfaceNumber;
        out_endpoint_ = out != nullptr ? out->bEndpointAddress : std::uint8_t{0};
        in_endpoint_ = in != nullptr ? in->bEndpointAddress : std::uint8_t{0};
        max_packet_bytes_ = in != nullptr ? in->wMaxPacketSize : std::size_t{0};
    }
    libusb_free_config_descriptor(config);
    return found;
}

void UsbLink::set_name(libusb_device* device) {
    libusb_device_descriptor id{};
    libusb_get_device_descriptor(device, &id);
    std::snprintf(name_, sizeof name_, "%s %04x:%04x", device_noun_, id.idVendor, id.idProduct);
}

Result<void> UsbLink::claim_interface() {
    set_name(libusb_get_device(handle_));
    libusb_set_auto_detach_kernel_driver(handle_, 1);
    int code = libusb_claim_interface(handle_, interface_);
    if (code == LIBUSB_SUCCESS) {
        transfers_ = std::make_unique<BulkTransfer[]>(2);
        submitted_count_ = completed_count_ = 0;
        if (transfers_[0].transfer != nullptr && transfers_[1].transfer != nullptr)
            return {};
        code = LIBUSB_ERROR_NO_MEM;
    }
    const Error error = failed("claim", code);
    close();
    return error;
}

Result<void> UsbLink::open(const UsbId* ids, std::size_t count, int interface) {
    if (const auto r = start(); !r)
        return r;
    libusb_device** devices = nullptr;
    const ssize_t listed = libusb_get_device_list(context_, &devices);
    int code = LIBUSB_ERROR_NOT_FOUND;
    for (ssize_t i = 0; i < listed && handle_ == nullptr; ++i) {
        libusb_device_descriptor id{};
        libusb_get_device_descriptor(devices[i], &id);
        const bool wanted = std::any_of(ids, ids + count, [&](const UsbId& known) {
            return known.vendor == id.idVendor && known.product == id.idProduct;
        });
        if (!wanted || !find_pipe(devices[i], interface))
            continue;
        set_name(devices[i]);
        code = libusb_open(devices[i], &handle_);
    }
    if (listed >= 0)
        libusb_free_device_list(devices, 1);
    if (handle_ != nullptr)
        return claim_interface();
    const Error error = code == LIBUSB_ERROR_NOT_FOUND ? error_.say(Fault::gone, device_noun_, "open",
                                                                    "none is plugged in; lsusb lists what is")
                                                       : failed("open", code);
    close();
    return error;
}

Result<void> UsbLink::open_file(const char* path, int interface) {
    libusb_set_option(nullptr, LIBUSB_OPTION_NO_DEVICE_DISCOVERY);
    if (const auto r = start(); !r)
        return r;
    do
        file_ = ::open(path, O_RDWR | O_CLOEXEC);
    while (file_ < 0 && errno == EINTR);
    if (file_ < 0) {
        const Error error = error_.system(DeviceClass::usb, path, "open", errno);
        close();
        return error;
    }
    const int code = libusb_wrap_sys_device(context_, file_, &handle_);
    if (code == LIBUSB_SUCCESS && find_pipe(libusb_get_device(handle_), interface))
        return claim_interface();
    const Error error = code != LIBUSB_SUCCESS ? failed("open", code)
                                               : error_.say(Fault::wrong_device, path, "open",
                                                            "no vendor interface with a bulk output");
    close();
    return error;
}

// --- Requests

Result<std::size_t> UsbLink::get(const char* name, std::uint8_t request, std::uint16_t value,
                                 std::uint8_t* into, std::size_t count, std::uint32_t timeout_ms) {
    is_refused_ = false;
    const int came = libusb_control_transfer(handle_, std::uint8_t{LIBUSB_ENDPOINT_IN} | to_interface,
                                             request, value, static_cast<std::uint16_t>(interface_), into,
                                             static_cast<std::uint16_t>(count), timeout_ms);
    return came >= 0 ? Result<std::size_t>(static_cast<std::size_t>(came)) : failed(name, came);
}

Result<void> UsbLink::set(const char* name, std::uint8_t request, std::uint16_t value,
                          const std::uint8_t* from, std::size_t count, std::uint32_t timeout_ms) {
    is_refused_ = false;
    const int went = libusb_control_transfer(
        handle_, to_interface, request, value, static_cast<std::uint16_t>(interface_),
        const_cast<std::uint8_t*>(from), static_cast<std::uint16_t>(count), timeout_ms);
    if (went < 0)
        return failed(name, went);
    if (static_cast<std::size_t>(went) != count)
        return error_.say(Fault::short_write, name_, name, "the request was cut short");
    return {};
}

Result<void> UsbLink::clear_halt() {
    const int code = libusb_clear_halt(handle_, out_endpoint_);
    return code == LIBUSB_SUCCESS ? Result<void>{} : failed("clear halt", code);
}

/// Requests GET_STATUS, which every device answers (USB 2.0, 9.4.5).
Result<void> UsbLink::check_alive(const char* operation) {
    std::uint8_t status[2] = {};
    const int came = libusb_control_transfer(handle_, LIBUSB_ENDPOINT_IN, LIBUSB_REQUEST_GET_STATUS, 0, 0,
                                             status, sizeof status, 1000);
    return came >= 0 ? Result<void>{} : failed(operation, came);
}

// --- The pipes

/// Cancels all transfers: then none is under way any more, and the bytes are the caller's again.
void UsbLink::take_back() {
    for (unsigned i = completed_count_; i != submitted_count_; ++i)
        libusb_cancel_transfer(transfers_[i % 2].transfer);
    while (completed_count_ != submitted_count_)
        transfers_[completed_count_++ % 2].complete(context_);
}

Error UsbLink::close_after_error(int code) {
    take_back();
    return failed("send pixels", code);
}

Result<void> UsbLink::settle_to(unsigned under_way) {
    while (submitted_count_ - completed_count_ > under_way)
        if (const int code = transfers_[completed_count_++ % 2].complete(context_); code != LIBUSB_SUCCESS)
            return close_after_error(code);
    return {};
}

Result<void> UsbLink::make_room() {
    return settle_to(1);
}

Result<void> UsbLink::settle() {
    return settle_to(0);
}

Result<void> UsbLink::push(const std::uint8_t* bytes, std::size_t count, std::uint32_t timeout_ms) {
    is_refused_ = false;
    if (const auto r = make_room(); !r)
        return r;
    const int code =
        transfers_[submitted_count_ % 2].submit(handle_, out_endpoint_, bytes, count, timeout_ms);
    if (code != LIBUSB_SUCCESS)
        return close_after_error(code);
    ++submitted_count_;
    return {};
}

Result<void> UsbLink::send(const std::uint8_t* bytes, std::size_t count, std::uint32_t timeout_ms) {
    for (std::size_t sent = 0; sent < count; sent += piece_bytes)
        if (const auto r = push(bytes + sent, std::min(piece_bytes, count - sent), timeout_ms); !r)
            return r;
    return settle();
}

Result<std::size_t> UsbLink::read_bulk(std::uint8_t* into, std::size_t count, std::uint32_t timeout_ms) {
    is_refused_ = false;
    int came = 0;
    const int code =
        libusb_bulk_transfer(handle_, in_endpoint_, into, static_cast<int>(count), &came, timeout_ms);
    if (code != LIBUSB_SUCCESS)
        return failed("read", code);
    return static_cast<std::size_t>(came);
}

} // namespace spangle::hal

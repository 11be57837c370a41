// A USB device at a port of the kernel's virtual host controller (vhci-hcd), over USB/IP through a pair of
// sockets. The real usbcore, its drivers and usbfs reach a UsbFunction. It is written from
// Documentation/usb/usbip_protocol.rst.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "host_sim/usb/usb_function.hpp"

namespace spangle::sim {

class UsbipDevice {
  public:
    using Fate = UsbFate;

    explicit UsbipDevice(UsbFunction& function, bool high_speed = true)
        : function_(function), is_high_speed_(high_speed) {}
    ~UsbipDevice() { unplug(); }
    UsbipDevice(const UsbipDevice&) = delete;
    UsbipDevice& operator=(const UsbipDevice&) = delete;

    /// Plugs the device into the first port, once the device before is gone. Returns false where that fails;
    /// errno says why: there is no vhci-hcd, or the process may not use it.
    bool plug();
    /// Removes the device as when its plug is pulled: transfers under way die.
    void unplug();

    /// Decides what happens to a bulk transfer of `count` bytes to the device.
    std::function<Fate(std::size_t count)> fate;
    /// Keeps the device from doing anything while the lock is held: std::lock_guard lock(device).
    void lock() { mutex_.lock(); }
    void unlock() { mutex_.unlock(); }

  private:
    /// A transfer that the host submitted.
    struct Transfer {
        std::uint32_t sequence = 0, length = 0;
        std::uint8_t endpoint = 0; ///< address of the endpoint, direction included
        bool to_host = false;
        UsbSetup setup;
        std::vector<std::uint8_t> bytes; ///< bytes from the host; then those of the device
    };
    using Packet = std::array<std::uint8_t, 48>;

    UsbFunction& function_;
    bool is_high_speed_;
    int socket_ = -1;
    std::thread thread_;
    std::mutex mutex_;                       ///< guards the function and the members below
    std::deque<Transfer> pending_transfers_; ///< transfers of the bulk pipe, which is worked off in order

    bool attach(int socket);
    void serve_socket();
    bool handle_submit(const Packet& packet);
    bool unlinked(const Packet& packet);
    bool run();
    bool carry(Transfer& transfer, Fate fate);
    int control(Transfer& transfer);
    bool handle_standard_request(const UsbSetup& setup, std::vector<std::uint8_t>& in);
    bool finish(const Transfer& transfer, int status, std::size_t length);
    bool receive(void* into, std::size_t count);
    bool send(const void* from, std::size_t count);
};

} // namespace spangle::sim

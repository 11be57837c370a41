// A USB device as a Linux gadget. FunctionFS hands a UsbFunction what arrives at the machine's device
// controller, and dummy_hcd joins that controller to a host controller of the same machine. It cuts transfers
// short in other ways than vhci-hcd.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <thread>

#include "host_sim/usb/usb_function.hpp"

struct usb_functionfs_event;

namespace kernel_test {

class Gadget {
  public:
    using Fate = spangle::sim::UsbFate;

    /// The function must have a device descriptor, and a first interface with one bulk output.
    explicit Gadget(spangle::sim::UsbFunction& function);
    ~Gadget();
    Gadget(const Gadget&) = delete;
    Gadget& operator=(const Gadget&) = delete;

    void plug();
    void unplug();
    /// Once, after so many more bytes, the device misbehaves: `stall` halts the pipe, `silent` reads nothing
    /// until the next call, `unplug` leaves. With `normal` nothing more happens.
    void misbehave(Fate fate, std::size_t after);

    /// While the gadget is locked the device does nothing: std::lock_guard lock(gadget).
    void lock() { mutex_.lock(); }
    void unlock() { mutex_.unlock(); }

  private:
    spangle::sim::UsbFunction& function_;
    std::mutex mutex_; ///< guards the function and the next members
    Fate fate_ = Fate::normal;
    std::size_t until_fate_ = 0;
    int control_ = -1, pipe_ = -1; ///< descriptors of ep0 and ep1
    std::atomic<bool> plugged_ = false;
    enum class Hand { empty, reads, full }; ///< what the pipe's thread does: has no packet, reads, has one
    std::atomic<Hand> hand_ = Hand::empty;
    std::atomic<int> reader_ = 0; ///< the kernel's number of the pipe's thread
    bool halted_ = false;         ///< whether the function refused the last packet
    std::thread control_thread_, pipe_thread_;

    void describe();
    void serve_control();
    void answer(const usb_functionfs_event& event);
    void serve_pipe();
    void take(const std::uint8_t* packet, std::size_t count);
    void await_packets() const;
    bool behave();
    void leave();
};

} // namespace kernel_test

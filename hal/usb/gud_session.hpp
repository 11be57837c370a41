// One GUD device: how it is set up, takes pixels, and is polled. One thread at a time may use it, except
// where a function says otherwise.
#pragma once

#include <atomic>

#include <spangle/usb/gud_display.hpp>

#include "hal/usb/gud_protocol.hpp"
#include "hal/usb/usb_link.hpp"

namespace spangle::hal {

class GudSession {
  public:
    explicit GudSession(const GudConfig& config) : config_(config) {}

    /// Finds the device and sets its mode. On an error nothing stays open.
    Result<void> connect();
    /// Switches the display off.
    void disable_display();
    /// Sends a rectangle that the device's buffer holds, in its format; compressed where that is less. It is
    /// sent once more after a failure that may pass.
    Result<void> send(gud::Buffer buffer, const std::uint8_t* bytes);
    /// Asks for the connector's status.
    void poll();

    /// Whether the device is there, as far as is known. Any thread may ask.
    bool is_alive() const { return is_alive_; }
    /// Whether a screen is plugged into the device's connector, as it last reported. Any thread may ask.
    bool is_plugged() const { return is_plugged_; }
    bool wants_polls() const { return wants_polls_; }
    const gud::Descriptor& device() const { return device_; }
    const gud::Mode& mode() const { return mode_; }
    std::uint8_t format() const { return format_; }
    Error say(Fault fault, const char* operation, const char* cause) {
        return link_.say(fault, operation, cause);
    }

  private:
    GudConfig config_;
    UsbLink link_;
    gud::Descriptor device_;
    gud::Mode mode_;
    std::uint8_t format_ = 0, connector_ = 0;
    bool wants_polls_ = false;
    bool has_bulk_failed_ = false; ///< true: a device with FULL_UPDATE needs a SET_BUFFER
    std::atomic<bool> is_alive_ = false, is_plugged_ = true;
    gud::Bytes compressed_;

    // Requests, whose errors give the device's reason for a refusal.
    Error explain(const char* name, const Error& error);
    Result<std::size_t> get(std::uint8_t request, std::uint16_t value, gud::Bytes& into, std::size_t most);
    Result<void> set(std::uint8_t request, const gud::Bytes& bytes);

    Result<void> come_up();
    Result<void> choose_format();
    Result<void> choose_connector();
    Result<void> choose_mode();
    Result<void> enable();
    Result<void> transfer(const gud::Buffer& buffer, const std::uint8_t* bytes, std::size_t count);
    Result<void> check(const Result<void>& sent);
};

} // namespace spangle::hal

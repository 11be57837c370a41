// A GUD display (Generic USB Display, include/drm/gud.h) as a Display, from user space through libusb: any
// device that speaks the protocol, found by its IDs. Presents send what changed, compressed where that is
// less, while the next frame is drawn.
#pragma once

#include <cstdint>
#include <memory>

#include <spangle/hal/display.hpp>

namespace spangle::hal {

/// Says which device to use, and how frames are sent to it.
struct GudConfig {
    /// The device's USB IDs; 0: any of the known ones (1d50:614d, 16d0:10a9, 1209:4fb3).
    std::uint16_t vendor = 0, product = 0;
    /// The usbfs file ("/dev/bus/usb/001/002") of a device that a portal or another process found. Null: the
    /// display looks for a device. The text must outlive the display.
    const char* device_file = nullptr;
    /// The wanted size in pixels; 0: the preferred mode.
    std::uint16_t width = 0, height = 0;
    bool compress = true;          ///< compresses by LZ4, where both the device and this build can
    std::uint8_t brightness = 100; ///< brightness in percent, of devices with a backlight property
    /// The longest time of a request and of a piece of a frame, in milliseconds.
    std::uint32_t control_timeout_ms = 1000, bulk_timeout_ms = 3000;
    /// How often devices that ask for it are asked for their connector's status. Without that they take the
    /// host for dead.
    std::uint32_t poll_ms = 10000;
    /// What a present does while the frame before is on its way.
    Pacing pacing = Pacing::block;
};

/// A Display on USB.
class GudDisplay final : public Display {
  public:
    /// Looks for no device; init() does that.
    explicit GudDisplay(const GudConfig& config = {});
    /// Switches the display off.
    ~GudDisplay();
    /// A display is not copied.
    GudDisplay(const GudDisplay&) = delete;
    /// A display is not assigned.
    GudDisplay& operator=(const GudDisplay&) = delete;

    /// Size and format are known after init().
    DisplayInfo info() const override;
    /// Finds the device, sets its mode, and shows black. Errors name device, operation and cause;
    /// docs/faults.md lists them.
    Result<void> init() override;
    Result<Frame> acquire() override;
    /// Returns while the frame is on its way, in memory that only its sender can reach: the buffer is the
    /// program's again, as it was drawn. What became of a frame is reported by the next present, which sends
    /// nothing if it failed, or by finish(). After Fault::gone each present looks for the device again, and
    /// the first that finds it sends the whole picture.
    Result<void> present() override;
    Result<void> finish() override;
    void swap_interval(std::int32_t interval) override;

    /// Whether a screen is plugged into the device's connector, as that last reported.
    bool connected() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace spangle::hal

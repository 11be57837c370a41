// A model of a GUD display (Generic USB Display): the device side of include/drm/gud.h, with the behaviour of
// the Linux gadget and gud-pico. The model is strict: it reports faults that a lenient device would forgive.
#pragma once

#include <array>
#include <string>

#include <spangle/sim/image.hpp>

#include "host_sim/usb/usb_function.hpp"

namespace spangle::sim {

struct GudMode {
    std::uint32_t clock_khz = 0;
    std::uint16_t width = 0, height = 0;
    bool preferred = false;
};

class GudDevice final : public UsbFunction {
  public:
    // --- properties of the device
    std::uint16_t vendor = 0x1d50, product = 0x614d;
    bool high_speed = true;
    bool lz4 = true;
    bool status_on_set = false, full_update = false;
    bool poll_status = false;          ///< true: the host is to send GET_CONNECTOR_STATUS every 10 s
    std::uint32_t max_buffer_size = 0; ///< bytes; 0: any size
    bool tells_by_length = true;       ///< a shorter buffer is taken as compressed, as gud-pico does
    std::vector<std::uint8_t> formats = {0x40};
    std::vector<GudMode> modes = {{6000, 320, 240, true}};
    /// The least and the most width, the least and the most height, in pixels.
    std::array<std::uint16_t, 4> limits = {320, 320, 240, 240};
    std::vector<std::uint8_t> edid; ///< the EDID, which hosts read if `modes` is empty
    struct Property {
        std::uint16_t id;
        std::uint64_t value;
    };
    std::vector<Property> properties, connector_properties = {{12, 100}}; ///< the default is a backlight
    int connectors = 1;
    bool connected = true;

    // --- behaviour
    std::vector<std::uint8_t> descriptors() const override;
    bool control(const UsbSetup& setup, const std::uint8_t* out, std::vector<std::uint8_t>& in) override;
    bool bulk_out(std::uint8_t endpoint, const std::uint8_t* bytes, std::size_t count) override;
    bool bulk_in(std::uint8_t, std::size_t, std::vector<std::uint8_t>&) override { return false; }
    void clear_halt() override { is_halted_ = false, received_bytes_.clear(); }
    void power_cycle();
    /// Makes the next request of this number fail with this GUD status.
    void refuse(std::uint8_t request, std::uint8_t status) {
        refused_request_ = request, refused_status_ = status;
    }
    void stall_bulk() { stalls_bulk_ = true; }
    /// Makes every reply to this request have no bytes.
    void empty(std::uint8_t request) { empty_request_ = request; }
    /// Makes GET_STATUS after this request have no bytes.
    void hide_status_of(std::uint8_t request) { hidden_request_ = request; }
    /// GET_STATUS is refused, as by a device that has failed.
    bool refuses_status = false;

    // --- the picture
    bool enabled() const { return is_controller_enabled_ && is_display_enabled_ && is_committed_; }
    /// The picture on the glass, black unless the display is enabled.
    Image glass() const;
    std::uint64_t value_of(std::uint16_t property) const;
    const std::string& violations() const { return violations_; }
    void forget_violations() { violations_.clear(); }
    struct Counters {
        std::uint64_t requests = 0, buffers = 0, compressed = 0, bulk_bytes = 0, status_polls = 0,
                      flushes = 0;
        std::uint32_t largest_buffer = 0;
    };
    const Counters& counters() const { return counters_; }

  private:
    struct Buffer {
        std::uint32_t x = 0, y = 0, width = 0, height = 0, length = 0, compressed_length = 0;
        bool compressed = false;
    };
    Counters counters_;
    std::string violations_;
    std::uint8_t status_ = 0, format_ = 0, refused_request_ = 0xFF, refused_status_ = 0;
    int empty_request_ = -1, hidden_request_ = -1, last_request_ = -1;
    int connector_ = -1;
    GudMode mode_;
    std::vector<Property> checked_properties_; ///< the properties of the state that was checked last
    bool is_checked_ = false, is_committed_ = false, is_controller_enabled_ = false,
         is_display_enabled_ = false;
    bool is_halted_ = false, stalls_bulk_ = false, has_buffer_ = false;
    Buffer buffer_request_;
    std::vector<std::uint8_t> received_bytes_;
    Image picture_;

    using Bytes = std::vector<std::uint8_t>;
    void add_violation(const std::string& text) { violations_ += text + "\n"; }
    bool handle_standard_request(const UsbSetup& setup, Bytes& in) const;
    bool get(const UsbSetup& setup, Bytes& in);
    std::uint8_t set(const UsbSetup& setup, const std::uint8_t* out);
    std::uint8_t check_state(const std::uint8_t* bytes, std::size_t count);
    std::uint8_t set_buffer(const std::uint8_t* bytes, std::size_t count);
    std::size_t picture_bytes(std::uint32_t width, std::uint32_t height) const;
    void draw(const Bytes& pixels);
    void put_pixel(std::uint32_t x, std::uint32_t y, const Bytes& pixels, std::uint32_t column,
                   std::size_t row);
};

} // namespace spangle::sim

#include "host_sim/usb/gud_device.hpp"

#include <algorithm>
#include <cstring>

#include <lz4.h>

namespace spangle::sim {
namespace {

// Numbers of requests, from include/drm/gud.h.
enum Request : std::uint8_t {
    get_status = 0x00,
    get_descriptor = 0x01,
    get_formats = 0x40,
    get_properties = 0x41,
    get_connectors = 0x50,
    get_connector_properties = 0x51,
    set_force_detect = 0x53,
    get_connector_status = 0x54,
    get_connector_modes = 0x55,
    get_connector_edid = 0x56,
    set_buffer_request = 0x60,
    set_state_check = 0x61,
    set_state_commit = 0x62,
    set_controller_enable = 0x63,
    set_display_enable = 0x64,
};
enum Status : std::uint8_t {
    ok = 0,
    busy = 1,
    not_supported = 2,
    protocol_error = 3,
    invalid_parameter = 4,
    error = 5
};

constexpr std::size_t mode_bytes = 24, state_bytes = mode_bytes + 2, property_bytes = 10, buffer_bytes = 25;
constexpr std::uint32_t preferred_flag = 1u << 10;

using Bytes = std::vector<std::uint8_t>;

void put(Bytes& to, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i)
        to.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

std::uint32_t take(const std::uint8_t* from, int bytes) {
    std::uint32_t value = 0;
    for (int i = 0; i < bytes; ++i)
        value |= static_cast<std::uint32_t>(from[i]) << 8 * i;
    return value;
}

int bits_per_pixel(std::uint8_t format) {
    switch (format) {
    case 0x01:
        return 1;
    case 0x20:
        return 4;
    case 0x08:
    case 0x30:
        return 8;
    case 0x40:
        return 16;
    case 0x50:
        return 24;
    default:
        return 32;
    }
}

/// Writes a display mode without porches, as USB panels report theirs.
void put_mode(Bytes& to, const GudMode& mode) {
    put(to, mode.clock_khz, 4);
    for (int i = 0; i < 4; ++i)
        put(to, mode.width, 2);
    for (int i = 0; i < 4; ++i)
        put(to, mode.height, 2);
    put(to, mode.preferred ? preferred_flag : 0, 4);
}

} // namespace

Bytes GudDevice::descriptors() const {
    const unsigned packet = high_speed ? 512 : 64;
    Bytes d = {18, 1, 0x00, 0x02, 0, 0, 0, 64};
    put(d, vendor, 2);
    put(d, product, 2);
    put(d, 0x0100, 2);
    put(d, 0x01000000, 4); // the device has no strings, and one configuration
    const Bytes configuration = {9,
                                 2,
                                 25,
                                 0,
                                 1,
                                 1,
                                 0,
                                 0x80,
                                 50, // the configuration: one interface, 100 mA
                                 9,
                                 4,
                                 0,
                                 0,
                                 1,
                                 0xFF,
                                 0,
                                 0,
                                 0, // the interface: vendor class, one endpoint
                                 7,
                                 5,
                                 0x01,
                                 2,
                                 static_cast<std::uint8_t>(packet),
                                 static_cast<std::uint8_t>(packet >> 8),
                                 0};
    d.insert(d.end(), configuration.begin(), configuration.end());
    return d;
}

void GudDevice::power_cycle() {
    status_ = ok;
    is_checked_ = is_committed_ = is_controller_enabled_ = is_display_enabled_ = is_halted_ = has_buffer_ =
        false;
    checked_properties_.clear();
    received_bytes_.clear();
    picture_ = Image(0, 0);
}

// --- requests on the control pipe

bool GudDevice::control(const UsbSetup& setup, const std::uint8_t* out, Bytes& in) {
    ++counters_.requests;
    in.clear();
    if ((setup.type & 0x60) == 0)
        return handle_standard_request(setup, in);
    if ((setup.type & 0x7F) != 0x41 || setup.index != 0) {
        add_violation("a request to no interface of this device");
        return false;
    }
    const bool to_host = (setup.type & 0x80) != 0;
    if (to_host && setup.request == empty_request_)
        return true;
    if (setup.request == get_status && to_host) {
        if (last_request_ != hidden_request_)
            in = {status_};
        return !refuses_status;
    }
    last_request_ = setup.request;
    if (setup.request == refused_request_) {
        refused_request_ = 0xFF;
        status_ = refused_status_;
        return !to_host && status_on_set;
    }
    if (to_host) {
        const bool answered = get(setup, in);
        status_ = answered ? ok : not_supported;
        in.resize(std::min<std::size_t>(in.size(), setup.length));
        return answered;
    }
    status_ = set(setup, out);
    // The host asks a device with status_on_set for its status after each such request. The device does not
    // stall.
    return status_ == ok || status_on_set;
}

/// Answers the standard requests that the operating system sends to any device.
bool GudDevice::handle_standard_request(const UsbSetup& setup, Bytes& in) const {
    if ((setup.type & 0x80) != 0 && setup.request == 8) // the standard request GET_CONFIGURATION
        in = {1};
    return setup.request == 8 || setup.request == 9 || setup.request == 11 || setup.request == 1;
}

bool GudDevice::get(const UsbSetup& setup, Bytes& in) {
    const auto put_properties = [&](const std::vector<Property>& list) {
        for (const Property& p : list) {
            put(in, p.id, 2);
            put(in, p.value, 8);
        }
    };
    const bool of_connector =
        setup.request >= get_connector_properties && setup.request <= get_connector_edid;
    if (of_connector && setup.value >= connectors)
        return false;
    switch (setup.request) {
    case get_descriptor:
        put(in, 0x1d50614d, 4);
        put(in, 1, 1);
        put(in, (status_on_set ? 1u : 0u) | (full_update ? 2u : 0u), 4);
        put(in, lz4 ? 1 : 0, 1);
        put(in, max_buffer_size, 4);
        for (const std::uint16_t limit : limits)
            put(in, limit, 4);
        return true;
    case get_formats:
        in = formats;
        return true;
    case get_properties:
        put_properties(properties);
        return true;
    case get_connectors:
        for (int i = 0; i < connectors; ++i) {
            put(in, 0, 1); // the connector is a panel
            put(in, poll_status ? 1 : 0, 4);
        }
        return true;
    case get_connector_properties:
        put_properties(connector_properties);
        return true;
    case get_connector_status:
        ++counters_.status_polls;
        put(in, connected ? 1 : 0, 1);
        return true;
    case get_connector_modes:
        for (const GudMode& mode : modes)
            put_mode(in, mode);
        return true;
    case get_connector_edid:
        in = edid;
        return true;
    default:
        return false;
    }
}

std::uint8_t GudDevice::set(const UsbSetup& setup, const std::uint8_t* out) {
    if (setup.value != 0 && setup.request != set_force_detect)
        add_violation("a request that is not a connector's, with a value");
    switch (setup.request) {
    case set_force_detect:
        return setup.value < connectors ? ok : invalid_parameter;
    case set_buffer_request:
        return set_buffer(out, setup.length);
    case set_state_check:
        return check_state(out, setup.length);
    case set_state_commit:
        if (!is_checked_) {
            add_violation("SET_STATE_COMMIT of a state that was not checked");
            return invalid_parameter;
        }
        is_committed_ = true;
        picture_ = Image(mode_.width, mode_.height);
        for (std::size_t i = 0; i < picture_.rgba.size(); ++i) // noise makes a forgotten frame visible
            picture_.rgba[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(i * 2654435761u >> 24);
        return ok;
    case set_controller_enable:
    case set_display_enable:
        if (setup.length != 1)
            return protocol_error;
        (setup.request == set_controller_enable ? is_controller_enabled_ : is_display_enabled_) = out[0] != 0;
        if (is_display_enabled_ && !is_controller_enabled_)
            add_violation("the display is on and its controller off");
        return ok;
    default:
        return not_supported;
    }
}

/// Checks the state that the host wants: a mode, a format, a connector, and all properties of both lists.
std::uint8_t GudDevice::check_state(const std::uint8_t* bytes, std::size_t count) {
    is_checked_ = false;
    if (count < state_bytes || (count - state_bytes) % property_bytes != 0)
        return protocol_error;
    const GudMode wanted = {take(bytes, 4), static_cast<std::uint16_t>(take(bytes + 4, 2)),
                            static_cast<std::uint16_t>(take(bytes + 12, 2))};
    format_ = bytes[mode_bytes];
    connector_ = bytes[mode_bytes + 1];
    if (wanted.width < limits[0] || wanted.width > limits[1] || wanted.height < limits[2] ||
        wanted.height > limits[3] || connector_ >= connectors)
        return invalid_parameter;
    if (std::find(formats.begin(), formats.end(), format_) == formats.end())
        return invalid_parameter;
    checked_properties_.clear();
    for (std::size_t at = state_bytes; at < count; at += property_bytes)
        checked_properties_.push_back(
            {static_cast<std::uint16_t>(take(bytes + at, 2)), take(bytes + at + 2, 4)});
    for (const auto* list : {&properties, &connector_properties})
        for (const Property& p : *list)
            if (std::none_of(checked_properties_.begin(), checked_properties_.end(),
                             [&](const Property& v) { return v.id == p.id; })) {
                add_violation("SET_STATE_CHECK without property " + std::to_string(p.id));
                return invalid_parameter;
            }
    mode_ = wanted;
    is_checked_ = true;
    return ok;
}

std::uint64_t GudDevice::value_of(std::uint16_t property) const {
    for (const Property& v : checked_properties_)
        if (v.id == property)
            return v.value;
    return ~std::uint64_t{0};
}

// --- pictures on the bulk pipe

std::size_t GudDevice::picture_bytes(std::uint32_t width, std::uint32_t height) const {
    return (std::size_t{width} * static_cast<unsigned>(bits_per_pixel(format_)) + 7) / 8 * height;
}

std::uint8_t GudDevice::set_buffer(const std::uint8_t* bytes, std::size_t count) {
    ++counters_.buffers;
    received_bytes_.clear();
    has_buffer_ = false;
    if (count != buffer_bytes)
        return protocol_error;
    if (!is_committed_ || !is_controller_enabled_) {
        add_violation("SET_BUFFER before a state was committed and the controller enabled");
        return invalid_parameter;
    }
    const Buffer b = {take(bytes, 4),      take(bytes + 4, 4),  take(bytes + 8, 4), take(bytes + 12, 4),
                      take(bytes + 16, 4), take(bytes + 21, 4), bytes[20] != 0};
    counters_.largest_buffer = std::max(counters_.largest_buffer, b.length);
    const std::uint32_t unit = 8 / static_cast<unsigned>(std::min(8, bits_per_pixel(format_)));
    std::string wrong;
    if (b.width == 0 || b.height == 0 || b.x + b.width > mode_.width || b.y + b.height > mode_.height)
        wrong = "outside of the picture";
    else if (b.length != picture_bytes(b.width, b.height) || b.x % unit != 0)
        wrong = "of another length than its pixels, or beginning inside a byte";
    else if (max_buffer_size != 0 && b.length > max_buffer_size)
        wrong = "longer than max_buffer_size";
    else if (b.compressed && (!lz4 || full_update))
        wrong = "compressed, which this device did not offer";
    else if (b.compressed && b.compressed_length >= b.length + (tells_by_length ? 0 : 1))
        wrong = "compressed to no less";
    if (!wrong.empty()) {
        add_violation("SET_BUFFER " + wrong);
        return invalid_parameter;
    }
    counters_.compressed += b.compressed;
    buffer_request_ = b;
    has_buffer_ = true;
    return ok;
}

bool GudDevice::bulk_out(std::uint8_t, const std::uint8_t* bytes, std::size_t count) {
    counters_.bulk_bytes += count;
    if (stalls_bulk_)
        is_halted_ = true;
    stalls_bulk_ = false;
    if (is_halted_)
        return false;
    if (full_update && !has_buffer_ && is_committed_) {
        buffer_request_ = {0,
                           0,
                           mode_.width,
                           mode_.height,
                           static_cast<std::uint32_t>(picture_bytes(mode_.width, mode_.height)),
                           0,
                           false};
        has_buffer_ = true;
    }
    if (!has_buffer_) {
        add_violation("pixels without SET_BUFFER");
        is_halted_ = true;
        return false;
    }
    received_bytes_.insert(received_bytes_.end(), bytes, bytes + count);
    const std::size_t expected =
        buffer_request_.compressed ? buffer_request_.compressed_length : buffer_request_.length;
    if (received_bytes_.size() < expected)
        return true;
    Bytes pixels(buffer_request_.length);
    bool good = received_bytes_.size() == expected;
    if (good && buffer_request_.compressed)
        good = LZ4_decompress_safe(reinterpret_cast<const char*>(received_bytes_.data()),
                                   reinterpret_cast<char*>(pixels.data()), static_cast<int>(expected),
                                   static_cast<int>(pixels.size())) == static_cast<int>(pixels.size());
    else if (good)
        pixels = received_bytes_;
    received_bytes_.clear();
    has_buffer_ = false;
    if (!good) {
        add_violation("a buffer that does not hold what SET_BUFFER said");
        is_halted_ = true;
        return false;
    }
    ++counters_.flushes;
    draw(pixels);
    return true;
}

void GudDevice::draw(const Bytes& pixels) {
    const std::size_t pitch = picture_bytes(buffer_request_.width, 1);
    for (std::uint32_t y = 0; y < buffer_request_.height; ++y)
        for (std::uint32_t x = 0; x < buffer_request_.width; ++x)
            put_pixel(buffer_request_.x + x, buffer_request_.y + y, pixels, x, y * pitch);
}

/// Draws a pixel of the buffer into the picture. Components are widened to a byte. Formats are little-endian
/// words, or packed bits with the left pixel in the high bits.
void GudDevice::put_pixel(std::uint32_t x, std::uint32_t y, const Bytes& pixels, std::uint32_t column,
                          std::size_t row) {
    const auto bits = static_cast<unsigned>(bits_per_pixel(format_));
    const std::uint8_t* const at = pixels.data() + row + std::size_t{column} * bits / 8;
    std::uint32_t word = bits >= 8 ? take(at, static_cast<int>(bits / 8)) : 0;
    if (bits < 8)
        word = static_cast<std::uint32_t>(*at) >> (8 - bits - column * bits % 8) & ((1u << bits) - 1);
    std::uint8_t* const to = picture_.at(static_cast<int>(x), static_cast<int>(y));
    const auto widen = [](std::uint32_t v, unsigned n) {
        return static_cast<std::uint8_t>(v * 255 / ((1u << n) - 1));
    };
    switch (format_) {
    case 0x01:
        to[0] = to[1] = to[2] = word != 0 ? 255 : 0;
        break;
    case 0x08:
        to[0] = to[1] = to[2] = static_cast<std::uint8_t>(word);
        break;
    case 0x20:
        to[0] = widen(word >> 2 & 1, 1), to[1] = widen(word >> 1 & 1, 1), to[2] = widen(word & 1, 1);
        break;
    case 0x30:
        to[0] = widen(word >> 5, 3), to[1] = widen(word >> 2 & 7, 3), to[2] = widen(word & 3, 2);
        break;
    case 0x40:
        to[0] = widen(word >> 11, 5), to[1] = widen(word >> 5 & 63, 6), to[2] = widen(word & 31, 5);
        break;
    default:
        to[0] = static_cast<std::uint8_t>(word >> 16), to[1] = static_cast<std::uint8_t>(word >> 8);
        to[2] = static_cast<std::uint8_t>(word);
    }
}

Image GudDevice::glass() const {
    if (enabled())
        return picture_;
    Image dark(picture_.width, picture_.height);
    for (std::size_t i = 0; i < dark.rgba.size(); ++i)
        dark.rgba[i] = i % 4 == 3 ? 255 : 0;
    return dark;
}

} // namespace spangle::sim

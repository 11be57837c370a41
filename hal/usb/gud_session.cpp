#include "hal/usb/gud_session.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#if SPANGLE_HAS_LZ4
#include <lz4.h>
#endif

#include "hal/usb/gud_frame.hpp"
#include "hal/usb/gud_pixels.hpp"

namespace spangle::hal {
namespace {

using gud::Bytes;

constexpr UsbId known_ids[] = {{0x1d50, 0x614d}, {0x16d0, 0x10a9}, {0x1209, 0x4fb3}};

// Limits of what is believed of a device: no more than what can be drawn and sent.
constexpr std::int32_t most_height = 4096;      ///< the most rows that a WindowPlan takes
constexpr std::uint32_t most_pixels = 1u << 24; ///< a bound, because memory holds the picture several times
constexpr std::uint64_t most_bands = 1u << 14;  ///< a bound, because each band takes 125 us or more

/// Compresses bytes and returns their number where they become fewer, else 0. Equal lengths are no use:
/// devices also tell by the lengths whether bytes are compressed.
std::size_t compress(const std::uint8_t* raw, std::size_t count, Bytes& into) {
#if SPANGLE_HAS_LZ4
    into.resize(count);
    const int fewer =
        LZ4_compress_default(reinterpret_cast<const char*>(raw), reinterpret_cast<char*>(into.data()),
                             static_cast<int>(count), static_cast<int>(count) - 1);
    return fewer > 0 ? static_cast<std::size_t>(fewer) : 0;
#else
    static_cast<void>(raw), static_cast<void>(count), static_cast<void>(into);
    return 0;
#endif
}

} // namespace

// --- Requests

/// Explains an error. A STALL gives no reason, but the device's status does.
Error GudSession::explain(const char* operation, const Error& error) {
    if (!link_.is_refused())
        return error;
    std::uint8_t status = 0;
    const auto word = link_.get("GET_STATUS", gud::GET_STATUS, 0, &status, 1, config_.control_timeout_ms);
    if (!word && !link_.is_refused())
        return word.error();
    if (!word || word.value() != 1)
        return link_.say(error.fault, operation, "the device refused this and gave no reason");
    return link_.say(Fault::unsupported, operation, gud::status_text(status));
}

Result<std::size_t> GudSession::get(std::uint8_t request, std::uint16_t value, Bytes& into,
                                    std::size_t most) {
    const char* const operation = gud::name_of(request);
    into.assign(most, 0);
    const auto came = link_.get(operation, request, value, into.data(), most, config_.control_timeout_ms);
    if (!came)
        return explain(operation, came.error());
    into.resize(came.value());
    return came;
}

Result<void> GudSession::set(std::uint8_t request, const Bytes& bytes) {
    const char* const operation = gud::name_of(request);
    const auto went =
        link_.set(operation, request, 0, bytes.data(), bytes.size(), config_.control_timeout_ms);
    if (!went)
        return explain(operation, went.error());
    if ((device_.flags & gud::STATUS_ON_SET) == 0)
        return {};
    std::uint8_t status = 0;
    const auto came = link_.get("GET_STATUS", gud::GET_STATUS, 0, &status, 1, config_.control_timeout_ms);
    if (!came)
        return came.error();
    if (came.value() != 1)
        return link_.say(Fault::no_answer, operation, "GET_STATUS came back without a status");
    return status == 0 ? Result<void>{} : link_.say(Fault::unsupported, operation, gud::status_text(status));
}

// --- Coming up

Result<void> GudSession::connect() {
    const auto up = come_up();
    if (!up)
        link_.close();
    is_alive_ = up.ok();
    return up;
}

Result<void> GudSession::come_up() {
    const UsbId own[] = {{config_.vendor, config_.product}};
    const auto opened = config_.device_file != nullptr ? link_.open_file(config_.device_file)
                        : config_.vendor != 0          ? link_.open(own, 1)
                                                       : link_.open(known_ids, std::size(known_ids));
    if (!opened)
        return opened;
    device_ = {};
    Bytes bytes;
    if (const auto r = get(gud::GET_DESCRIPTOR, 0, bytes, gud::descriptor_bytes); !r)
        return r.error();
    if (!gud::parse(device_, bytes.data(), bytes.size()))
        return link_.say(Fault::wrong_device, "GET_DESCRIPTOR", "this is no GUD display of version 1");
    if (const auto r = choose_format(); !r)
        return r;
    if (const auto r = choose_connector(); !r)
        return r;
    if (const auto r = choose_mode(); !r)
        return r;
    return enable();
}

Result<void> GudSession::choose_format() {
    Bytes offered;
    if (const auto r = get(gud::GET_FORMATS, 0, offered, gud::most_formats); !r)
        return r.error();
    format_ = gud::best_format(offered.data(), offered.size());
    if (format_ == 0)
        return link_.say(Fault::unsupported, "GET_FORMATS", "none of the device's pixel formats is known");
    return {};
}

/// Chooses the first connector that is connected, or else the first of all.
Result<void> GudSession::choose_connector() {
    Bytes list, status;
    connector_ = 0;
    if (const auto r = get(gud::GET_CONNECTORS, 0, list, gud::connector_bytes * gud::most_connectors); !r)
        return r.error();
    const std::size_t count = list.size() / gud::connector_bytes;
    if (count == 0)
        return link_.say(Fault::wrong_device, "GET_CONNECTORS", "the device has none");
    bool plugged = false;
    for (std::size_t i = 0; i < count && !plugged; ++i) {
        if (const auto r = get(gud::GET_CONNECTOR_STATUS, static_cast<std::uint16_t>(i), status, 1); !r)
            return r.error();
        if (status.empty())
            return link_.say(Fault::no_answer, "GET_CONNECTOR_STATUS", "it came back without a status");
        plugged = (status[0] & 3u) != 0;
        if (plugged)
            connector_ = static_cast<std::uint8_t>(i);
    }
    is_plugged_ = plugged;
    wants_polls_ = (list[connector_ * gud::connector_bytes + 1] & gud::POLL_STATUS) != 0;
    return {};
}

/// Chooses a mode of the size that was asked for, if one was: the preferred mode, else the first. Where there
/// is no list it comes from the EDID.
Result<void> GudSession::choose_mode() {
    Bytes bytes;
    if (const auto r = get(gud::GET_CONNECTOR_MODES, connector_, bytes, gud::mode_bytes * gud::most_modes);
        !r)
        return r.error();
    std::vector<gud::Mode> modes;
    for (std::size_t at = 0; at + gud::mode_bytes <= bytes.size(); at += gud::mode_bytes)
        modes.push_back(gud::parse_mode(bytes.data() + at));
    if (modes.empty()) {
        if (const auto r = get(gud::GET_CONNECTOR_EDID, connector_, bytes, gud::most_edid); !r)
            return r.error();
        modes.push_back(gud::edid_mode(bytes.data(), bytes.size()));
    }
    // Where the device has a mode of the wanted size that is refused, this becomes the reason.
    const char* refusal = "the device has no mode of this size";
    const auto fits = [&](const gud::Mode& m) {
        const std::uint32_t w = m.horizontal[0], h = m.vertical[0];
        const bool wanted =
            (config_.width == 0 || config_.width == w) && (config_.height == 0 || config_.height == h);
        if (!wanted || w == 0 || h == 0 || w < device_.min_width || w > device_.max_width ||
            h < device_.min_height || h > device_.max_height)
            return false;
        if (w > INT16_MAX || h > most_height || w * h > most_pixels) {
            refusal = "the device's modes are too large";
            return false;
        }
        const std::uint64_t bands = bands_of(device_, format_, m.horizontal[0], m.vertical[0]);
        if (bands == 0 || bands > most_bands) {
            refusal = "the device's buffer is too small for its modes";
            return false;
        }
        return true;
    };
    auto chosen = std::find_if(modes.begin(), modes.end(), [&](const gud::Mode& m) {
        return fits(m) && (m.flags & gud::MODE_PREFERRED) != 0;
    });
    if (chosen == modes.end())
        chosen = std::find_if(modes.begin(), modes.end(), fits);
    if (chosen == modes.end())
        return link_.say(Fault::unsupported, "GET_CONNECTOR_MODES", refusal);
    mode_ = *chosen;
    return {};
}

/// Enables the display in the order of the kernel's driver: state check, controller, commit, display.
Result<void> GudSession::enable() {
    std::vector<gud::Property> properties;
    for (const std::uint8_t request : {gud::GET_PROPERTIES, gud::GET_CONNECTOR_PROPERTIES}) {
        Bytes bytes;
        const std::uint16_t of = request == gud::GET_PROPERTIES ? std::uint16_t{0} : connector_;
        if (const auto r = get(request, of, bytes, gud::property_bytes * gud::most_properties); !r)
            return r.error();
        for (std::size_t at = 0; at + gud::property_bytes <= bytes.size(); at += gud::property_bytes)
            properties.push_back(gud::parse_property(bytes.data() + at));
    }
    for (gud::Property& p : properties)
        if (p.id == gud::BACKLIGHT_BRIGHTNESS)
            p.value = config_.brightness;
    if (const auto r = set(gud::SET_STATE_CHECK, gud::state(mode_, format_, connector_, properties)); !r)
        return r;
    if (const auto r = set(gud::SET_CONTROLLER_ENABLE, {1}); !r)
        return r;
    if (const auto r = set(gud::SET_STATE_COMMIT, {}); !r)
        return r;
    return set(gud::SET_DISPLAY_ENABLE, {1});
}

/// Closes the link if the device is gone; connect() looks for it again.
Result<void> GudSession::check(const Result<void>& sent) {
    if (sent.error().fault == Fault::gone) {
        is_alive_ = false;
        link_.close();
    }
    return sent;
}

void GudSession::disable_display() {
    if (!is_alive_)
        return;
    (void)set(gud::SET_DISPLAY_ENABLE, {0});
    (void)set(gud::SET_CONTROLLER_ENABLE, {0});
}

// --- Pixels

Result<void> GudSession::send(gud::Buffer buffer, const std::uint8_t* bytes) {
    if (!is_alive_)
        return link_.say(Fault::gone, "send pixels", "the device was unplugged");
    const bool may_compress = config_.compress && (device_.compression & gud::COMPRESSION_LZ4) != 0 &&
                              (device_.flags & gud::FULL_UPDATE) == 0;
    const std::size_t fewer = may_compress ? compress(bytes, buffer.length, compressed_) : 0;
    buffer.compressed_length = static_cast<std::uint32_t>(fewer);
    const std::uint8_t* const data = fewer != 0 ? compressed_.data() : bytes;
    const std::size_t count = fewer != 0 ? fewer : buffer.length;
    const auto sent = transfer(buffer, data, count);
    if (sent || sent.error().fault == Fault::gone || sent.error().fault == Fault::timeout)
        return check(sent);
    (void)link_.clear_halt(); // tries again: the endpoint was halted, or the device dropped the buffer
    return check(transfer(buffer, data, count));
}

/// Sends a buffer. Devices of full updates get SET_BUFFER only after a buffer that failed.
Result<void> GudSession::transfer(const gud::Buffer& buffer, const std::uint8_t* bytes, std::size_t count) {
    if ((device_.flags & gud::FULL_UPDATE) == 0 || has_bulk_failed_)
        if (const auto r = set(gud::SET_BUFFER, gud::buffer(buffer)); !r)
            return r;
    const auto sent = link_.send(bytes, count, config_.bulk_timeout_ms);
    has_bulk_failed_ = !sent;
    return sent ? sent : explain("send pixels", sent.error());
}

void GudSession::poll() {
    Bytes status;
    const auto came = get(gud::GET_CONNECTOR_STATUS, connector_, status, 1);
    if (came && !status.empty())
        is_plugged_ = (status[0] & 3u) != 0;
    else if (!came)
        (void)check(came.error());
}

} // namespace spangle::hal

#include <spangle/usb/gud_display.hpp>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <thread>
#include <vector>

#if SPANGLE_HAS_LZ4
#include <lz4.h>
#endif

#include "hal/display/window_plan.hpp"
#include "hal/usb/gud_pixels.hpp"
#include "hal/usb/gud_protocol.hpp"
#include "hal/usb/usb_link.hpp"

namespace spangle::hal {
namespace {

using gud::Bytes;

constexpr UsbId known_ids[] = {{0x1d50, 0x614d}, {0x16d0, 0x10a9}, {0x1209, 0x4fb3}};

/// What a rectangle costs beyond its pixels: SET_BUFFER and its two turn-rounds, an eighth of a millisecond
/// at high speed.
constexpr std::uint32_t window_bytes = 2048;

constexpr std::int32_t most_height = 4096; // of a WindowPlan

RowSpan unite(RowSpan a, RowSpan b) {
    return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

RowSpan clip(RowSpan row, std::int16_t width) {
    const RowSpan inside = {std::max(row.begin, std::int16_t{0}), std::min(row.end, width)};
    return inside.begin < inside.end ? inside : RowSpan{};
}

/// Compressed bytes when they are fewer, else 0. Devices tell by the lengths too: equal ones are no use.
std::size_t compress(const Bytes& raw, Bytes& into) {
#if SPANGLE_HAS_LZ4
    into.resize(raw.size());
    const int count =
        LZ4_compress_default(reinterpret_cast<const char*>(raw.data()), reinterpret_cast<char*>(into.data()),
                             static_cast<int>(raw.size()), static_cast<int>(raw.size()) - 1);
    return count > 0 ? static_cast<std::size_t>(count) : 0;
#else
    static_cast<void>(raw), static_cast<void>(into);
    return 0;
#endif
}

} // namespace

struct GudDisplay::State {
    explicit State(const GudConfig& c) : config(c), poller([this] { poll(); }) {}
    ~State();

    GudConfig config;
    mutable std::mutex mutex; ///< the link's, and all that the poller sees
    UsbLink link;

    // --- the device
    gud::Descriptor device;
    gud::Mode mode;
    std::uint8_t format = 0, connector = 0;
    bool wants_polls = false, plugged = true;
    bool bulk_failed = false; ///< a device of full updates then needs one SET_BUFFER
    bool ready = false, gone = false;

    // --- the picture, and what the device does not have of it
    char name[32] = "GUD display";
    std::int32_t width = 0, height = 0;
    Bytes pixels, raw, packed;
    std::vector<RowSpan> touched, content, damage;
    std::vector<std::uint16_t> plan;
    RowExtents extents;
    std::uint32_t clear_value = 0;
    bool presented = false;

    // --- the thread that keeps a device company
    std::condition_variable changed;
    bool stopping = false;
    std::chrono::steady_clock::time_point last_poll;
    std::thread poller;

    // Requests: a refusal says why.
    Error explain(const char* name, const Error& error);
    Result<std::size_t> get(std::uint8_t request, std::uint16_t value, Bytes& into, std::size_t most);
    Result<void> set(std::uint8_t request, const Bytes& bytes);

    Result<void> connect();
    Result<void> choose_format();
    Result<void> choose_connector();
    Result<void> choose_mode();
    Result<void> enable();
    void take_size();
    void collect();
    Result<void> send_damage();
    Result<void> send_rect(Rect r);
    Result<void> send_band(const Rect& r);
    Result<void> transfer(const gud::Buffer& buffer, const Bytes& bytes, std::size_t count);
    Result<void> fail(const Error& error);
    void poll();
};

GudDisplay::GudDisplay(const GudConfig& config) : state_(std::make_unique<State>(config)) {}
GudDisplay::~GudDisplay() = default;

GudDisplay::State::~State() {
    {
        const std::lock_guard lock(mutex);
        stopping = true;
        if (ready && !gone) {
            (void)set(gud::SET_DISPLAY_ENABLE, {0});
            (void)set(gud::SET_CONTROLLER_ENABLE, {0});
        }
    }
    changed.notify_all();
    poller.join();
}

// --- Requests

/// A STALL says no more than "no": the device's status does.
Error GudDisplay::State::explain(const char* operation, const Error& error) {
    if (!link.refused())
        return error;
    std::uint8_t status = 0;
    const auto came = link.get("GET_STATUS", gud::GET_STATUS, 0, &status, 1, config.control_timeout_ms);
    if (!came || came.value() != 1)
        return error;
    return link.say(Fault::unsupported, operation, gud::status_text(status));
}

Result<std::size_t> GudDisplay::State::get(std::uint8_t request, std::uint16_t value, Bytes& into,
                                           std::size_t most) {
    const char* const operation = gud::name_of(request);
    into.assign(most, 0);
    const auto came = link.get(operation, request, value, into.data(), most, config.control_timeout_ms);
    if (!came)
        return explain(operation, came.error());
    into.resize(came.value());
    return came;
}

Result<void> GudDisplay::State::set(std::uint8_t request, const Bytes& bytes) {
    const char* const operation = gud::name_of(request);
    const auto went = link.set(operation, request, 0, bytes.data(), bytes.size(), config.control_timeout_ms);
    if (!went)
        return explain(operation, went.error());
    if ((device.flags & gud::STATUS_ON_SET) == 0)
        return {};
    std::uint8_t status = 0;
    const auto came = link.get("GET_STATUS", gud::GET_STATUS, 0, &status, 1, config.control_timeout_ms);
    if (!came)
        return came.error();
    return status == 0 ? Result<void>{} : link.say(Fault::unsupported, operation, gud::status_text(status));
}

// --- Coming up

Result<void> GudDisplay::State::connect() {
    const UsbId own[] = {{config.vendor, config.product}};
    const auto opened = config.device_file != nullptr ? link.open_file(config.device_file)
                        : config.vendor != 0          ? link.open(own, 1)
                                                      : link.open(known_ids, std::size(known_ids));
    if (!opened)
        return opened;
    device = {};
    Bytes bytes;
    if (const auto r = get(gud::GET_DESCRIPTOR, 0, bytes, gud::descriptor_bytes); !r)
        return r.error();
    if (!gud::parse(device, bytes.data(), bytes.size()))
        return link.say(Fault::wrong_device, "GET_DESCRIPTOR", "this is no GUD display of version 1");
    if (const auto r = choose_format(); !r)
        return r;
    if (const auto r = choose_connector(); !r)
        return r;
    if (const auto r = choose_mode(); !r)
        return r;
    return enable();
}

Result<void> GudDisplay::State::choose_format() {
    Bytes offered;
    if (const auto r = get(gud::GET_FORMATS, 0, offered, gud::most_formats); !r)
        return r.error();
    format = gud::best_format(offered.data(), offered.size());
    if (format == 0)
        return link.say(Fault::unsupported, "GET_FORMATS", "none of the device's pixel formats is known");
    return {};
}

/// The first that is connected, or the first of all.
Result<void> GudDisplay::State::choose_connector() {
    Bytes list, status;
    connector = 0;
    if (const auto r = get(gud::GET_CONNECTORS, 0, list, gud::connector_bytes * gud::most_connectors); !r)
        return r.error();
    const std::size_t count = list.size() / gud::connector_bytes;
    if (count == 0)
        return link.say(Fault::wrong_device, "GET_CONNECTORS", "the device has none");
    wants_polls = plugged = false;
    for (std::size_t i = 0; i < count && !plugged; ++i) {
        if (const auto r = get(gud::GET_CONNECTOR_STATUS, static_cast<std::uint16_t>(i), status, 1); !r)
            return r.error();
        plugged = !status.empty() && (status[0] & 3u) != 0;
        if (plugged)
            connector = static_cast<std::uint8_t>(i);
    }
    wants_polls = (list[connector * gud::connector_bytes + 1] & gud::POLL_STATUS) != 0;
    last_poll = std::chrono::steady_clock::now();
    return {};
}

/// What was asked for, else the preferred mode, else the first; from the EDID where there is no list.
Result<void> GudDisplay::State::choose_mode() {
    Bytes bytes;
    if (const auto r = get(gud::GET_CONNECTOR_MODES, connector, bytes, gud::mode_bytes * gud::most_modes); !r)
        return r.error();
    std::vector<gud::Mode> modes;
    for (std::size_t at = 0; at + gud::mode_bytes <= bytes.size(); at += gud::mode_bytes)
        modes.push_back(gud::parse_mode(bytes.data() + at));
    if (modes.empty()) {
        if (const auto r = get(gud::GET_CONNECTOR_EDID, connector, bytes, gud::most_edid); !r)
            return r.error();
        modes.push_back(gud::edid_mode(bytes.data(), bytes.size()));
    }
    const auto fits = [&](const gud::Mode& m) {
        const std::uint32_t w = m.horizontal[0], h = m.vertical[0];
        const bool wanted =
            (config.width == 0 || config.width == w) && (config.height == 0 || config.height == h);
        return wanted && w != 0 && h != 0 && w >= device.min_width && w <= device.max_width &&
               h >= device.min_height && h <= device.max_height && w <= INT16_MAX && h <= most_height;
    };
    auto chosen = std::find_if(modes.begin(), modes.end(), [&](const gud::Mode& m) {
        return fits(m) && (m.flags & gud::MODE_PREFERRED) != 0;
    });
    if (chosen == modes.end())
        chosen = std::find_if(modes.begin(), modes.end(), fits);
    if (chosen == modes.end())
        return link.say(Fault::unsupported, "GET_CONNECTOR_MODES", "the device has no mode of this size");
    mode = *chosen;
    return {};
}

/// In the order of the kernel's driver: state check, controller, commit, display.
Result<void> GudDisplay::State::enable() {
    std::vector<gud::Property> properties;
    for (const std::uint8_t request : {gud::GET_PROPERTIES, gud::GET_CONNECTOR_PROPERTIES}) {
        Bytes bytes;
        const std::uint16_t of = request == gud::GET_PROPERTIES ? std::uint16_t{0} : connector;
        if (const auto r = get(request, of, bytes, gud::property_bytes * gud::most_properties); !r)
            return r.error();
        for (std::size_t at = 0; at + gud::property_bytes <= bytes.size(); at += gud::property_bytes)
            properties.push_back(gud::parse_property(bytes.data() + at));
    }
    for (gud::Property& p : properties)
        if (p.id == gud::BACKLIGHT_BRIGHTNESS)
            p.value = config.brightness;
    if (const auto r = set(gud::SET_STATE_CHECK, gud::state(mode, format, connector, properties)); !r)
        return r;
    if (const auto r = set(gud::SET_CONTROLLER_ENABLE, {1}); !r)
        return r;
    if (const auto r = set(gud::SET_STATE_COMMIT, {}); !r)
        return r;
    return set(gud::SET_DISPLAY_ENABLE, {1});
}

/// Another mode is another picture; the same one keeps what was drawn.
void GudDisplay::State::take_size() {
    if (width != mode.horizontal[0] || height != mode.vertical[0]) {
        width = mode.horizontal[0];
        height = mode.vertical[0];
        const auto rows = static_cast<std::size_t>(height);
        pixels.assign(std::size_t{2} * static_cast<std::size_t>(width) * rows, 0);
        touched.assign(rows, RowSpan{});
        content.assign(rows, RowSpan{0, static_cast<std::int16_t>(width)});
        plan.resize(rows);
        extents = {touched.data(), height, false, 0};
        presented = false;
    }
    damage.assign(static_cast<std::size_t>(height), RowSpan{0, static_cast<std::int16_t>(width)});
}

Result<void> GudDisplay::State::fail(const Error& error) {
    if (error.fault == Fault::gone) {
        gone = true;
        link.close();
    }
    return error;
}

DisplayInfo GudDisplay::info() const {
    return {state_->name, state_->width, state_->height, PixelFormat::rgb565_le};
}

Result<void> GudDisplay::init() {
    State& s = *state_;
    const std::lock_guard lock(s.mutex);
    s.ready = s.gone = false;
    if (const auto r = s.connect(); !r) {
        s.link.close();
        return r;
    }
    s.take_size();
    if (const auto r = s.send_damage(); !r)
        return s.fail(r.error());
    s.ready = true;
    s.changed.notify_all();
    return {};
}

bool GudDisplay::connected() const {
    const std::lock_guard lock(state_->mutex);
    return state_->ready && !state_->gone && state_->plugged;
}

// --- Frames

Result<Frame> GudDisplay::acquire() {
    State& s = *state_;
    if (!s.ready)
        return Error{Fault::bad_argument, "GUD display: acquire before init succeeded"};
    return Frame{s.pixels.data(), s.width * 2, s.presented ? 1 : 0, &s.extents};
}

Result<void> GudDisplay::present() {
    State& s = *state_;
    const std::lock_guard lock(s.mutex);
    if (!s.ready)
        return Error{Fault::bad_argument, "GUD display: present before init succeeded"};
    if (s.gone) {
        const std::int32_t width = s.width, height = s.height;
        if (const auto r = s.connect(); !r) {
            s.link.close();
            return r;
        }
        s.gone = false;
        if (width != s.mode.horizontal[0] || height != s.mode.vertical[0]) {
            s.ready = false;
            return s.link.say(Fault::wrong_device, "present",
                              "a display of another size came back; init again");
        }
        s.take_size();
    }
    s.collect();
    if (const auto r = s.send_damage(); !r)
        return s.fail(r.error());
    s.presented = true;
    s.extents.cleared = false;
    std::fill(s.touched.begin(), s.touched.end(), RowSpan{});
    return {};
}

/// What was drawn, and after a full clear what had been there. `damage` keeps what a failed present left
/// over.
void GudDisplay::State::collect() {
    const bool everything = extents.cleared && extents.clear_value != clear_value;
    const auto w = static_cast<std::int16_t>(width);
    for (std::size_t y = 0; y < touched.size(); ++y) {
        const RowSpan now = clip(touched[y], w);
        damage[y] = everything ? RowSpan{0, w} : unite(damage[y], now);
        if (extents.cleared)
            damage[y] = unite(damage[y], content[y]);
        content[y] = extents.cleared ? now : unite(content[y], now);
    }
    if (extents.cleared)
        clear_value = extents.clear_value;
}

Result<void> GudDisplay::State::send_damage() {
    if ((device.flags & gud::FULL_UPDATE) != 0) {
        const bool any = std::any_of(damage.begin(), damage.end(), [](RowSpan r) { return r.begin < r.end; });
        if (any)
            if (const auto r = send_band({0, 0, width, height}); !r)
                return r;
    } else {
        const std::uint32_t bytes = std::max<std::uint32_t>(1, gud::bits_per_pixel(format) / 8);
        WindowPlan windows(damage.data(), height, {window_bytes, bytes}, plan.data());
        for (Rect r; windows.next(r);)
            if (const auto sent = send_rect(r); !sent)
                return sent;
    }
    std::fill(damage.begin(), damage.end(), RowSpan{});
    return {};
}

/// Bands of whole rows, or pieces of rows, that fit the device's buffer.
Result<void> GudDisplay::State::send_rect(Rect r) {
    const auto unit = static_cast<std::int32_t>(gud::pixels_per_byte(format));
    r.w += r.x % unit;
    r.x -= r.x % unit;
    const std::size_t most = device.max_buffer_size != 0 ? device.max_buffer_size : SIZE_MAX;
    const auto row = [&](std::int32_t w) { return gud::row_bytes(format, static_cast<std::uint32_t>(w)); };
    std::int32_t columns = r.w;
    while (columns > unit && row(columns) > most)
        columns = (columns / 2 + unit - 1) / unit * unit;
    const auto fitting = static_cast<std::int64_t>(most / row(columns));
    const auto rows = static_cast<std::int32_t>(std::clamp<std::int64_t>(fitting, 1, r.h));
    for (std::int32_t y = r.y; y < r.y + r.h; y += rows)
        for (std::int32_t x = r.x; x < r.x + r.w; x += columns) {
            const Rect band = {x, y, std::min(columns, r.x + r.w - x), std::min(rows, r.y + r.h - y)};
            if (const auto sent = send_band(band); !sent)
                return sent;
        }
    return {};
}

Result<void> GudDisplay::State::send_band(const Rect& r) {
    const std::size_t line = gud::row_bytes(format, static_cast<std::uint32_t>(r.w));
    raw.resize(line * static_cast<std::size_t>(r.h));
    for (std::int32_t y = 0; y < r.h; ++y) {
        const std::size_t first = static_cast<std::size_t>(r.y + y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(r.x);
        gud::convert_row(format, pixels.data() + 2 * first, static_cast<std::uint32_t>(r.w),
                         raw.data() + line * static_cast<std::size_t>(y));
    }
    const auto u = [](std::int32_t v) { return static_cast<std::uint32_t>(v); };
    gud::Buffer buffer = {u(r.x), u(r.y), u(r.w), u(r.h), static_cast<std::uint32_t>(raw.size()), 0};
    const bool may_compress = config.compress && (device.compression & gud::COMPRESSION_LZ4) != 0 &&
                              (device.flags & gud::FULL_UPDATE) == 0;
    const std::size_t fewer = may_compress ? compress(raw, packed) : 0;
    buffer.compressed_length = static_cast<std::uint32_t>(fewer);
    const Bytes& bytes = fewer != 0 ? packed : raw;
    const std::size_t count = fewer != 0 ? fewer : raw.size();
    const auto sent = transfer(buffer, bytes, count);
    if (sent || sent.error().fault == Fault::gone || sent.error().fault == Fault::timeout)
        return sent;
    (void)link.clear_halt(); // once more: a halted endpoint, a buffer the device threw away
    return transfer(buffer, bytes, count);
}

/// Devices of full updates are told of a buffer only after one that failed.
Result<void> GudDisplay::State::transfer(const gud::Buffer& buffer, const Bytes& bytes, std::size_t count) {
    if ((device.flags & gud::FULL_UPDATE) == 0 || bulk_failed)
        if (const auto r = set(gud::SET_BUFFER, gud::buffer(buffer)); !r)
            return r;
    const auto sent = link.send(bytes.data(), count, config.bulk_timeout_ms);
    bulk_failed = !sent;
    return sent ? sent : explain("send pixels", sent.error());
}

// --- The poller

/// Asks for the connector's status as often as the device wants, whatever the program does.
void GudDisplay::State::poll() {
    std::unique_lock lock(mutex);
    const auto period = std::chrono::milliseconds(config.poll_ms);
    while (!stopping) {
        if (!ready || gone || !wants_polls) {
            changed.wait(lock);
            continue;
        }
        if (std::chrono::steady_clock::now() < last_poll + period) {
            changed.wait_until(lock, last_poll + period);
            continue;
        }
        Bytes status;
        const auto came = get(gud::GET_CONNECTOR_STATUS, connector, status, 1);
        if (came && !status.empty())
            plugged = (status[0] & 3u) != 0;
        else if (came.error().fault == Fault::gone)
            (void)fail(came.error());
        last_poll = std::chrono::steady_clock::now();
    }
}

} // namespace spangle::hal

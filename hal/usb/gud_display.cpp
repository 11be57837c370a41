#include <spangle/usb/gud_display.hpp>

#include <algorithm>
#include <utility>
#include <vector>

#include "hal/usb/gud_sender.hpp"

namespace spangle::hal {
namespace {

RowSpan unite(RowSpan a, RowSpan b) {
    return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

RowSpan clip(RowSpan row, std::int16_t width) {
    const RowSpan inside = {std::max(row.begin, std::int16_t{0}), std::min(row.end, width)};
    return inside.begin < inside.end ? inside : RowSpan{};
}

bool any(const std::vector<RowSpan>& rows) {
    return std::any_of(rows.begin(), rows.end(), [](RowSpan r) { return r.begin < r.end; });
}

} // namespace

/// The memory that acquire() hands out for pictures of one size. It stays where it is as long as the display
/// lives: a program that still draws to it after another device was plugged in draws into this memory.
struct Canvas {
    std::int32_t width = 0, height = 0;
    gud::Bytes pixels;
    std::vector<RowSpan> touched;
    RowExtents extents;

    Canvas(std::int32_t w, std::int32_t h)
        : width(w), height(h),
          pixels(std::size_t{2} * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)),
          touched(static_cast<std::size_t>(h)), extents{touched.data(), h, false, 0} {}
    void begin() {
        std::fill(pixels.begin(), pixels.end(), std::uint8_t{0});
        std::fill(touched.begin(), touched.end(), RowSpan{});
        extents = {touched.data(), height, false, 0};
    }
};

struct GudDisplay::State {
    explicit State(const GudConfig& c) : config(c), session(c), sender(session, c.poll_ms) {}

    GudConfig config;
    GudSession session;
    GudSender sender;
    std::unique_ptr<GudFrame> spare = std::make_unique<GudFrame>(); ///< null while the sender has it

    // --- the picture, and what the device does not have of it
    std::vector<std::unique_ptr<Canvas>> canvases; ///< a canvas for each size that the device has had
    Canvas* canvas = nullptr;                      ///< the canvas of the size that the device has now
    std::vector<RowSpan> content, damage;
    std::vector<std::uint16_t> plan;
    std::uint32_t clear_value = 0;
    bool ready = false, presented = false;
    bool owed = false; ///< true: a frame was put off and is still to be sent
    bool waits = true; ///< true: the swap interval is not 0

    Result<void> connect();
    Result<void> connect_again();
    void take_size();
    void take_canvas(std::int32_t width, std::int32_t height);
    bool drawn_since() const { return canvas->extents.cleared || any(canvas->touched); }
    bool put_off() const { return sender.busy() && !(waits && config.pacing == Pacing::block); }
    void accept();
    void collect_damage();
    Result<void> settle();
    void show();
};

GudDisplay::GudDisplay(const GudConfig& config) : state_(std::make_unique<State>(config)) {}

GudDisplay::~GudDisplay() {
    State& s = *state_;
    (void)s.settle();
    if (s.ready)
        (void)s.sender.with_exclusive_session([](GudSession& session) {
            session.disable_display();
            return Result<void>{};
        });
}

// --- Coming up

Result<void> GudDisplay::State::connect() {
    return sender.with_exclusive_session([](GudSession& s) { return s.connect(); });
}

/// Connects to the same display after it was gone; it then holds nothing of the picture.
Result<void> GudDisplay::State::connect_again() {
    if (const auto r = connect(); !r)
        return r;
    const gud::Mode& mode = session.mode();
    if (canvas->width != mode.horizontal[0] || canvas->height != mode.vertical[0]) {
        ready = false;
        return session.say(Fault::wrong_device, "present", "a display of another size came back; init again");
    }
    take_size();
    return {};
}

void GudDisplay::State::take_canvas(std::int32_t width, std::int32_t height) {
    const auto found = std::find_if(canvases.begin(), canvases.end(),
                                    [&](const auto& c) { return c->width == width && c->height == height; });
    canvas = found != canvases.end() ? found->get()
                                     : canvases.emplace_back(std::make_unique<Canvas>(width, height)).get();
    canvas->begin();
}

/// Takes the size of the device's mode. Another size is another picture; with the same size, what was drawn
/// stays.
void GudDisplay::State::take_size() {
    const gud::Mode& mode = session.mode();
    const auto rows = std::size_t{mode.vertical[0]};
    const RowSpan whole = {0, static_cast<std::int16_t>(mode.horizontal[0])};
    if (canvas == nullptr || canvas->width != mode.horizontal[0] || canvas->height != mode.vertical[0]) {
        take_canvas(mode.horizontal[0], mode.vertical[0]);
        content.assign(rows, whole);
        plan.resize(rows);
        presented = false;
    }
    damage.assign(rows, whole);
}

DisplayInfo GudDisplay::info() const {
    const Canvas* const canvas = state_->canvas;
    return {"GUD display", canvas != nullptr ? canvas->width : 0, canvas != nullptr ? canvas->height : 0,
            PixelFormat::rgb565_le, true};
}

Result<void> GudDisplay::init() {
    State& s = *state_;
    (void)s.settle(); // what became of an old frame does not matter any more
    s.ready = s.owed = false;
    if (const auto r = s.connect(); !r)
        return r;
    s.take_size();
    s.show();
    if (const auto r = s.settle(); !r)
        return r;
    s.ready = true;
    return {};
}

bool GudDisplay::connected() const {
    return state_->ready && state_->session.is_alive() && state_->session.is_plugged();
}

// --- Frames

Result<Frame> GudDisplay::acquire() {
    State& s = *state_;
    if (!s.ready)
        return Error{Fault::bad_argument, "GUD display: acquire before init succeeded"};
    return Frame{s.canvas->pixels.data(), s.canvas->width * 2, s.presented ? 1 : 0, &s.canvas->extents};
}

Result<void> GudDisplay::present() {
    State& s = *state_;
    if (!s.ready)
        return Error{Fault::bad_argument, "GUD display: present before init succeeded"};
    if (s.put_off()) {
        s.accept();
        s.owed = s.config.pacing != Pacing::drop;
        return {};
    }
    if (const auto r = s.settle(); !r)
        return r;
    if (!s.session.is_alive())
        if (const auto r = s.connect_again(); !r)
            return r;
    s.accept();
    s.show();
    return {};
}

Result<void> GudDisplay::finish() {
    State& s = *state_;
    if (const auto r = s.settle(); !r)
        return r;
    if (!s.owed || s.drawn_since())
        return {};
    s.show();
    return s.settle();
}

void GudDisplay::swap_interval(std::int32_t interval) {
    state_->waits = interval != 0;
}

/// The frame that was drawn becomes damage; the next one starts with nothing touched.
void GudDisplay::State::accept() {
    collect_damage();
    presented = true;
    canvas->extents.cleared = false;
    std::fill(canvas->touched.begin(), canvas->touched.end(), RowSpan{});
}

/// Collects damage: what was drawn, and after a full clear what had been there. `damage` also keeps what was
/// put off, and what a failed present left over.
void GudDisplay::State::collect_damage() {
    const RowExtents& extents = canvas->extents;
    const bool everything = extents.cleared && extents.clear_value != clear_value;
    const auto w = static_cast<std::int16_t>(canvas->width);
    for (std::size_t y = 0; y < canvas->touched.size(); ++y) {
        const RowSpan now = clip(canvas->touched[y], w);
        damage[y] = everything ? RowSpan{0, w} : unite(damage[y], now);
        if (extents.cleared)
            damage[y] = unite(damage[y], content[y]);
        content[y] = extents.cleared ? now : unite(content[y], now);
    }
    if (extents.cleared)
        clear_value = extents.clear_value;
}

/// Hands what the device lacks to the sender, in a copy: later drawing does not change it.
void GudDisplay::State::show() {
    owed = false;
    std::swap(spare->damage, damage);
    damage.assign(canvas->touched.size(), RowSpan{});
    cut(*spare, {canvas->pixels.data(), canvas->width, canvas->height}, session.device(), session.format(),
        plan.data());
    sender.start(std::move(spare));
}

/// Waits for the frame under way. What did not arrive becomes damage again.
Result<void> GudDisplay::State::settle() {
    GudSender::SentFrame sent = sender.wait();
    if (sent.frame == nullptr)
        return {};
    spare = std::move(sent.frame);
    for (std::size_t y = 0; !sent.outcome && y < damage.size(); ++y)
        damage[y] = unite(damage[y], spare->damage[y]);
    return sent.outcome;
}

} // namespace spangle::hal

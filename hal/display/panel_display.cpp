#include <spangle/hal/panel_display.hpp>

#include "hal/display/frame_plan.hpp"

namespace spangle::hal {
namespace {

/// A transfer is late when it takes twice its time and this.
constexpr std::uint32_t grace_us = 100000;

/// Operations before the first window of a frame that is tear-free.
constexpr std::size_t sync_ops = 2;

std::uint32_t deadline(std::uint32_t expected) {
    return expected < (UINT32_MAX - grace_us) / 2 ? expected * 2 + grace_us : UINT32_MAX;
}

RowSpan unite(RowSpan a, RowSpan b) {
    return {a.begin < b.begin ? a.begin : b.begin, a.end > b.end ? a.end : b.end};
}

/// A window and its pixels go into one list.
constexpr std::size_t least_ops(const CommandSet& set) {
    const std::uint32_t window = window_size(set).commands + 1;
    return window > 8 ? window : 8;
}

/// Calls `append` for each part of the area that one window can name, from the top left.
template <class Append>
Result<void> for_each_window(const Windows& windows, const Rect& area, Append append) {
    const Rect part = windows.first_of(area);
    for (std::int32_t y = 0; y < area.h; y += part.h)
        for (std::int32_t x = 0; x < area.w; x += part.w)
            if (const Result<void> r = append({area.x + x, area.y + y, part.w, part.h}); !r)
                return r;
    return {};
}

/// Three bytes each.
void reverse_pixels(std::uint8_t* rgb, std::int32_t count) {
    for (std::int32_t i = 0, k = count - 1; i < k; ++i, --k)
        for (std::int32_t c = 0; c < 3; ++c) {
            const std::uint8_t left = rgb[3 * i + c];
            rgb[3 * i + c] = rgb[3 * k + c];
            rgb[3 * k + c] = left;
        }
}

} // namespace

PanelDisplay::PanelDisplay(Bus& bus, const PanelConfig& config, const PanelMemory& memory)
    : bus_(bus), config_(config), memory_(memory) {}

DisplayInfo PanelDisplay::info() const {
    const bool described = config_.panel != nullptr;
    const Extent size = described ? picture_size(config_) : Extent{};
    return {described ? config_.panel->name : "",
            size.width,
            size.height,
            config_.format,
            config_.buffers == 1 || (described && turns(config_)),
            config_.wire.converts() ? config_.wire.format : WireFormat::none};
}

// --- Initialisation ---

Result<void> PanelDisplay::check_config() const {
    const PanelDesc& panel = *config_.panel;
    if (const char* rule = flaw(panel))
        return Error{Fault::bad_argument, rule};
    if (caps_.write_hz == 0)
        return Error{Fault::unsupported, "display: the bus has no write clock"};
    if (caps_.max_transfer != 0 && caps_.max_transfer < sizeof(OpParams))
        return Error{Fault::unsupported,
                     "display: the bus cannot carry the four bytes of CASET (2Ah) in one operation"};
    if (!format_code(panel, caps_.kind, wire_format(config_)).taken)
        return Error{Fault::unsupported, "display: the panel does not take this pixel format on this bus"};
    if (config_.wait_te && panel.commands->tearing.empty())
        return Error{Fault::unsupported, "display: waiting for TE, but the controller has no such output"};
    if (caps_.write_hz > fastest_write(panel, caps_.kind))
        return Error{Fault::unsupported,
                     "display: the bus's write clock is faster than this panel is known to take"};
    if (config_.read_back && caps_.read_hz > fastest_read(panel, caps_.kind))
        return Error{Fault::unsupported,
                     "display: the bus's read clock is faster than the panel's datasheet allows"};
    if (config_.wait_te && !caps_.has_te)
        return Error{Fault::unsupported, "display: waiting for TE, but the bus has no tearing-effect line"};
    const Extent size = sent_size(config_);
    if (config_.poll_line && caps_.read_hz == 0)
        return Error{Fault::unsupported, "display: polling the scanned line, but the bus cannot read"};
    if (config_.scan_order && (config_.buffers != 2 || config_.wire.converts()))
        return Error{
            Fault::bad_argument,
            "display: turning frames into the order of the scan takes two buffers, and pixels that travel "
            "as they are"};
    if (turns(config_) && (memory_.turned == nullptr || memory_.turner == nullptr))
        return Error{Fault::bad_argument, "display: the storage has no room for turned frames"};
    if (config_.row_hash && size.width > RowHash::widest)
        return Error{Fault::unsupported, "display: the row hash serves pictures up to 512 columns"};
    if (config_.row_hash && (memory_.hash.code == nullptr || memory_.hash.windows == nullptr))
        return Error{Fault::bad_argument, "display: the storage has no room for the row hash"};
    if (config_.row_hash && memory_.hash.cells < RowHash::cells_of(size.width) * size.height)
        return Error{Fault::bad_argument, "display: the storage has no room for the row hash"};
    if (config_.buffers < 1 || config_.buffers > 2)
        return Error{Fault::bad_argument, "display: a panel display has one or two buffers"};
    if (config_.wire.converts() && config_.buffers != 1)
        return Error{Fault::bad_argument,
                     "display: a picture that is turned into another format needs one buffer"};
    if (memory_.buffers < config_.buffers || memory_.height < book_height(config_) ||
        memory_.op_count < least_ops(*panel.commands))
        return Error{Fault::bad_argument, "display: the storage is smaller than the picture asks for"};
    return {};
}

/// Buffers and books of a display that never was initialised: nobody knows what the panel or the buffers
/// hold.
Result<void> PanelDisplay::take_buffers() {
    const std::size_t size = std::size_t{stride()} * static_cast<std::size_t>(picture_.height);
    for (unsigned i = 0; i < config_.buffers; ++i) {
        if (!buffers_[i].empty())
            continue;
        const Result<Buffer> buffer = bus_.acquire(size);
        if (!buffer)
            return buffer.error();
        if (buffer.value().bytes == nullptr || buffer.value().size < size)
            return Error{Fault::no_answer, "display: the bus gave less memory than one frame"};
        buffers_[i] = BusBuffer(buffer.value());
        for (std::size_t at = 0; at < size; ++at)
            buffer.value().bytes[at] = 0;
        content_[i].rows = memory_.content[i];
        for (std::int32_t y = 0; y < picture_.height; ++y)
            content_[i].rows[y] = {0, picture_.width};
    }
    if (!config_.wire.converts() || !wire_.empty())
        return {};
    // Windows that end inside a byte round up: one a row at most.
    const std::size_t wire_size =
        wire_bytes(placement_.size) + static_cast<std::size_t>(placement_.size.height);
    const Result<Buffer> wire = bus_.acquire(wire_size);
    if (!wire)
        return wire.error();
    if (wire.value().bytes == nullptr || wire.value().size < wire_size)
        return Error{Fault::no_answer, "display: the bus gave less memory than one frame"};
    wire_ = BusBuffer(wire.value());
    return {};
}

Result<void> PanelDisplay::init() {
    if (config_.panel == nullptr)
        return Error{Fault::bad_argument, "display: init without a panel"};
    if (in_flight_)
        (void)complete();
    if (in_flight_)
        return Error{Fault::busy, "display: init while a transfer is still on the wire"};
    caps_ = bus_.caps();
    if (const auto r = check_config(); !r)
        return r;
    turns_ = turns(config_);
    scan_ = scan_order(*config_.panel, config_.orientation);
    placement_ = turns_ ? scan_.placement : place(*config_.panel, config_.orientation);
    picture_ = picture_size(config_);
    pixel_bytes_ = format_info(config_.format).bytes_per_pixel;
    windows_ = Windows(*config_.panel, placement_, wire_format(config_));
    ops_ = OpList(memory_.ops, memory_.params, memory_.op_count);
    ops_.parameters_are_commands(config_.panel->commands->parameters_are_commands);
    if (config_.row_hash)
        hash_ = RowHash(memory_.hash, placement_.size.width, placement_.size.height,
                        static_cast<std::int32_t>(pixel_bytes_));
    if (const auto r = take_buffers(); !r)
        return r;
    ready_ = false; // a present must not succeed on a panel that was left in the middle of this
    if (!opened_) {
        extents_ = {memory_.touched, picture_.height, false, 0};
        forget_extents();
        front_ = static_cast<std::uint8_t>(canvases() - 1);
        back_ = 0;
        opened_ = true;
    }
    for (std::int32_t y = 0; y < picture_.height; ++y)
        memory_.damage[y] = {0, picture_.width};
    suspect_ = true;
    if (const auto r = reset_panel(); !r)
        return r;
    if (const auto r = append_setup(); !r)
        return r;
    if (const auto r = append_registers(); !r)
        return r;
    if (const auto r = append_black(); !r)
        return r;
    if (const auto r = append_program(config_.panel->commands->light); !r)
        return r;
    if (const auto r = start(); !r)
        return r;
    if (const auto r = complete(); !r)
        return r;
    ready_ = true;
    return {};
}

Result<void> PanelDisplay::reset_panel() {
    const PanelTiming& timing = config_.panel->timing;
    if (config_.reset_line)
        ops_.reset(timing.reset_low_us);
    else if (const auto r = append_program(config_.panel->commands->soft_reset); !r)
        return r;
    ops_.delay(timing.reset_wait_us);
    if (const auto r = start(); !r)
        return r;
    if (const auto r = complete(); !r)
        return r;
    if (config_.read_back)
        return check_identity(bus_, *config_.panel, scratch_);
    return {};
}

Result<void> PanelDisplay::append_setup() {
    return append_program(config_.panel->setup);
}

Result<void> PanelDisplay::append_program(Program program) {
    while (!program.empty()) {
        const Program::Step step = program.next();
        if (const auto r = make_room(1); !r)
            return r;
        if (step.delay_micros != 0) {
            ops_.delay(step.delay_micros);
            continue;
        }
        if (step.count > op_limit())
            return Error{Fault::unsupported,
                         "display: a setup command is longer than one operation of the bus"};
        ops_.command(step.command, step.params, step.count);
    }
    return {};
}

Result<void> PanelDisplay::append_registers() {
    const PanelDesc& panel = *config_.panel;
    const CommandSet& set = *panel.commands;
    const FormatCode format = format_code(panel, caps_.kind, wire_format(config_));
    if (const auto r = make_room(set.setting_count); !r)
        return r;
    for (unsigned i = 0; i < set.setting_count; ++i) {
        const Setting& setting = set.settings[i];
        const std::uint8_t value = value_of(setting, placement_.madctl, panel, format);
        if (setting.in_command)
            ops_.command(static_cast<std::uint8_t>(setting.command ^ value));
        else
            ops_.command_byte(setting.command, value);
    }
    if (config_.wait_te)
        if (const auto r = append_program(set.tearing); !r)
            return r;
    if (const auto r = append_program(set.wake); !r)
        return r;
    if (const auto r = make_room(1); !r)
        return r;
    if (panel.timing.sleep_out_wait_us != 0)
        ops_.delay(panel.timing.sleep_out_wait_us);
    return {};
}

/// The display comes on black, not with the noise its memory wakes up with.
Result<void> PanelDisplay::append_black() {
    return for_each_window(windows_, {0, 0, placement_.size.width, placement_.size.height},
                           [this](const Rect& window) { return append_black_window(window); });
}

Result<void> PanelDisplay::append_black_window(const Rect& window) {
    // Whole pixels where a pixel has whole bytes.
    const std::uint32_t unit = wire_bits() % 8 == 0 ? wire_bits() / 8 : 1;
    std::size_t left =
        wire_bytes({static_cast<std::int16_t>(window.w), static_cast<std::int16_t>(window.h)}) / unit;
    const std::uint32_t most = op_limit() / unit;
    if (const auto r = make_room(windows_.commands()); !r)
        return r;
    windows_.open(ops_, window);
    while (left != 0) {
        const std::uint32_t count = left < most ? static_cast<std::uint32_t>(left) : most;
        if (const auto r = make_room(1); !r)
            return r;
        ops_.repeat_black(unit, count);
        left -= count;
    }
    return {};
}

/// Bytes of so many pixels on the wire, rounded up.
std::size_t PanelDisplay::wire_bytes(const Extent& size) const {
    const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    return (pixels * wire_bits() + 7) / 8;
}

// --- Transfers ---

/// The longest operation of the bus in bytes, whole pixels where these have whole bytes.
std::uint32_t PanelDisplay::op_limit() const {
    const std::uint32_t limit = caps_.max_transfer != 0 ? caps_.max_transfer : UINT32_MAX;
    return wire_bits() % 8 == 0 ? limit - limit % (wire_bits() / 8) : limit;
}

/// Sends what the list holds when fewer than `ops` more fit.
Result<void> PanelDisplay::make_room(std::size_t ops) {
    if (ops_.room() >= ops)
        return {};
    if (const auto r = start(); !r)
        return r;
    return complete();
}

Result<void> PanelDisplay::start() {
    if (ops_.size() == 0)
        return {};
    const Result<Token> token = ops_.submit(bus_);
    const std::uint32_t time = ops_.duration(caps_);
    ops_.clear();
    if (!token) {
        windows_.forget();
        return token.error();
    }
    token_ = token.value();
    token_time_ = time;
    in_flight_ = true;
    return {};
}

Result<void> PanelDisplay::complete() {
    const Result<void> done = bus_.wait(token_, deadline(token_time_));
    in_flight_ = !done && !bus_.done(token_);
    late_ = in_flight_;
    if (!done) {
        suspect_ = true;
        windows_.forget();
    }
    return done;
}

Result<void> PanelDisplay::settle() {
    if (!in_flight_)
        return {};
    const bool was_late = late_;
    if (const auto r = complete(); !r)
        return r;
    if (!was_late)
        suspect_ = false;
    return {};
}

Result<void> PanelDisplay::finish() {
    if (const auto r = settle(); !r)
        return r;
    if (!owed_ || drawn_since())
        return {};
    if (const auto r = show(true); !r)
        return r;
    return settle();
}

Result<void> PanelDisplay::poll() {
    if (!owed_ || drawn_since() || (in_flight_ && !bus_.done(token_)))
        return {};
    if (const auto r = settle(); !r)
        return r;
    return show(false);
}

// --- Frames ---

Result<Frame> PanelDisplay::acquire() {
    if (!ready_)
        return Error{Fault::bad_argument, "display: acquire before init succeeded"};
    std::uint8_t* const pixels = buffers_[back_].to_draw(bus_);
    if (pixels == nullptr)
        return Error{Fault::busy, "display: acquire while a late transfer still reads the frame"};
    const std::uint32_t age = drawn_in_[back_] == 0 ? 0 : frame_ - drawn_in_[back_] + 1;
    return Frame{pixels, static_cast<std::int32_t>(stride()), static_cast<std::int32_t>(age), &extents_};
}

Result<void> PanelDisplay::present() {
    if (!ready_)
        return Error{Fault::bad_argument, "display: present before init succeeded"};
    if (put_off())
        return {};
    if (const auto r = settle(); !r)
        return r;
    const std::uint8_t drawn = back_;
    if (const auto r = show(false); !r)
        return r;
    drawn_in_[drawn] = ++frame_;
    return {};
}

/// Sends the frame that was drawn. `in_place`: its buffer is the next one's too.
Result<void> PanelDisplay::show(bool in_place) {
    restore_extents();
    collect_damage();
    if (turns_)
        turn_damage();
    if (hash_.enabled()) // whose reduced damage would not do for a buffer two sends behind
        memory_.hash.code->reduce(hash_, sent_damage(), buffers_[turns_ ? 1 : back_].to_send(),
                                  static_cast<std::int32_t>(sent_stride()), suspect_ || behind_);
    if (const auto r = send(); !r)
        return r;
    if (config_.buffers == 1 && !config_.wire.converts()) {
        if (const auto r = settle(); !r)
            return r;
    }
    accept(in_place);
    return {};
}

/// The frame is taken: the next one starts with nothing touched.
void PanelDisplay::accept(bool in_place) {
    front_ = back_;
    behind_ = in_place && canvases() == 2;
    if (!in_place && canvases() == 2)
        back_ ^= 1;
    forget_extents();
}

// --- Pacing ---

/// The wire is busy and this present need not wait for it.
bool PanelDisplay::put_off() {
    if (!in_flight_ || bus_.done(token_) || (waits_ && config_.pacing == Pacing::block))
        return false;
    drawn_in_[back_] = ++frame_;
    ++counters_.put_off;
    if (config_.pacing != Pacing::drop && memory_.held != nullptr)
        hold_extents();
    return true;
}

/// What the frame touched goes aside, so that it shows whether more is drawn.
void PanelDisplay::hold_extents() {
    restore_extents();
    held_cleared_ = extents_.cleared;
    held_clear_value_ = extents_.clear_value;
    for (std::int32_t y = 0; y < extents_.height; ++y)
        memory_.held[y] = memory_.touched[y];
    forget_extents();
    owed_ = true;
}

void PanelDisplay::restore_extents() {
    if (!owed_)
        return;
    owed_ = false;
    if (extents_.cleared)
        return; // nothing is left of that frame
    extents_.cleared = held_cleared_;
    extents_.clear_value = held_clear_value_;
    for (std::int32_t y = 0; y < extents_.height; ++y)
        memory_.touched[y] = unite(memory_.touched[y], memory_.held[y]);
}

void PanelDisplay::forget_extents() {
    extents_.cleared = false;
    for (std::int32_t y = 0; y < extents_.height; ++y)
        memory_.touched[y] = RowSpan{};
}

bool PanelDisplay::drawn_since() const {
    bool drawn = extents_.cleared;
    for (std::int32_t y = 0; y < extents_.height && !drawn; ++y)
        drawn = memory_.touched[y].begin < memory_.touched[y].end;
    return drawn;
}

// --- Sending ---

Result<void> PanelDisplay::send() {
    widen_damage();
    SpanPlan spans;
    // Rows that share bytes cannot be sent apart.
    const bool apart = hash_.enabled() && windows_.shared().height == 1;
    WindowCost cost = window_cost(caps_, *config_.panel->commands, wire_bits());
    for (;;) {
        if (apart)
            memory_.hash.code->plan(spans, hash_, cost);
        FramePlan plan(WindowPlan(sent_damage(), placement_.size.height, cost, memory_.plan),
                       apart ? &spans : nullptr, memory_.hash.code);
        // Two lists have a gap between them that nobody foresees, and the first is waited for.
        const bool one_list = config_.buffers == 2 || config_.wire.converts() || tear_free();
        if (!one_list || cost.window >= dearest_window || ops_of(plan) + sync_ops <= ops_.capacity())
            return send_windows(plan);
        cost.window = 2 * cost.window + 1; // dearer windows are fewer
    }
}

Result<void> PanelDisplay::send_windows(FramePlan& plan) {
    Rect window;
    if (!plan.next(window))
        return {};
    suspect_ = true; // until the last byte is known to be there
    ops_.clear();
    wire_end_ = 0;
    if (tear_free()) {
        append_sync(plan);
        plan.next(window);
    }
    do {
        if (const auto r = append_windows(window); !r)
            return r;
    } while (plan.next(window));
    if (const auto r = start(); !r)
        return r;
    sent_buffer().lend(token_);
    ++counters_.sent;
    return {};
}

/// Windows end where bytes do: rows that share bytes share the damage.
void PanelDisplay::widen_damage() {
    const Extent shared = windows_.shared();
    if (shared.width == 1 && shared.height == 1)
        return;
    RowSpan* const damage = sent_damage();
    for (std::int32_t y = 0; y < placement_.size.height; y += shared.height) {
        RowSpan all;
        for (std::int32_t i = 0; i < shared.height; ++i)
            all = unite(all, damage[y + i]);
        if (all.begin < all.end)
            all = {static_cast<std::int16_t>(all.begin / shared.width * shared.width),
                   static_cast<std::int16_t>((all.end + shared.width - 1) / shared.width * shared.width)};
        for (std::int32_t i = 0; i < shared.height; ++i)
            damage[y + i] = all;
    }
}

/// Calls `visit` with each window as it will be sent, and the operations that open it.
template <class Visit> void PanelDisplay::rehearse(FramePlan& plan, Visit visit) const {
    constexpr std::size_t most = 16; // of window_size()
    Op ops[most];
    OpParams params[most];
    Windows windows = windows_;
    plan.rewind();
    for (Rect area; plan.next(area);)
        (void)for_each_window(windows_, area, [&](const Rect& window) -> Result<void> {
            OpList opening(ops, params, most);
            windows.open(opening, window);
            visit(window, opening);
            return {};
        });
    plan.rewind();
}

std::size_t PanelDisplay::ops_of(FramePlan& plan) const {
    std::size_t count = 0;
    rehearse(plan,
             [&](const Rect& window, const OpList& opening) { count += opening.size() + pixel_ops(window); });
    return count;
}

/// When the windows may go out without a tear.
SafeStart PanelDisplay::safe_start(FramePlan& plan) const {
    const PanelTiming& timing = config_.panel->timing;
    Refresh refresh;
    if (timing.scan_lines != 0) {
        refresh.line = static_cast<std::int32_t>(std::int64_t{timing.frame_us} * 1000 / timing.scan_lines);
        refresh.lines = timing.scan_lines;
        refresh.porch = timing.porch_lines;
        // An edge is seen, a line is read, within a command or two; never closer than the line itself.
        refresh.jitter = refresh.line + static_cast<std::int32_t>(2 * caps_.command_cost_ns);
    }
    const bool swapped = (placement_.madctl & dcs::MV) != 0, upward = (placement_.madctl & dcs::MY) != 0;
    const auto row_of = [&](std::int32_t along) {
        const std::int32_t row = along + (swapped ? placement_.offset.x : placement_.offset.y);
        return upward ? config_.panel->memory.height - 1 - row : row;
    };
    SafeStart start(refresh);
    std::int64_t at = 0;
    rehearse(plan, [&](const Rect& w, const OpList& opening) {
        at += wire_nanoseconds(caps_, opening.bytes()) +
              static_cast<std::int64_t>(opening.size()) * caps_.command_cost_ns;
        const std::int64_t row = wire_nanoseconds(caps_, wire_bytes({static_cast<std::int16_t>(w.w), 1}));
        const std::int64_t end = at + row * w.h;
        if (swapped) { // every row of the memory is written all the time
            start.write(row_of(w.x), at, end);
            start.write(row_of(w.x + w.w - 1), at, end);
        } else {
            start.write(row_of(w.y), at, at + row);
            start.write(row_of(w.y + w.h - 1), end - row, end);
        }
        at = end;
    });
    return start;
}

/// Leads or lags the beam; where every start would tear, it starts in the blanking, or at once.
void PanelDisplay::append_sync(FramePlan& plan) {
    const SafeStart start = safe_start(plan);
    const PanelTiming& timing = config_.panel->timing;
    const std::uint32_t at_most = 2 * timing.frame_us + grace_us;
    const std::int64_t delay = start.possible() ? start.after_blanking() : 0;
    ++(!start.possible() ? counters_.unsafe : delay == 0 ? counters_.led : counters_.lagged);
    if (config_.wait_te) {
        ops_.wait_te(at_most);
        if (delay != 0)
            ops_.delay(static_cast<std::uint32_t>((delay + 999) / 1000));
    } else if (start.possible()) {
        ops_.wait_line(register_dummy_bits(caps_, *config_.panel), start.first_line(), start.slack_lines(),
                       timing.scan_lines, at_most);
    }
}

Result<void> PanelDisplay::append_windows(const Rect& area) {
    return for_each_window(windows_, area, [this](const Rect& window) { return append_window(window); });
}

/// Turns the window's pixels into the wire's, behind those of the windows before it.
std::size_t PanelDisplay::convert(const Rect& window) {
    const Picture picture = {buffers_[back_].to_send(), static_cast<std::int32_t>(stride()),
                             placement_.size.height, config_.format, (placement_.madctl & dcs::MV) != 0};
    return config_.wire.convert(picture, window, wire_.to_draw(bus_) + wire_end_);
}

Result<void> PanelDisplay::append_window(const Rect& window) {
    if (const auto r = make_room(windows_.commands() + 1); !r)
        return r;
    windows_.open(ops_, window);
    if (config_.wire.converts()) {
        const std::uint8_t* const converted = wire_.to_draw(bus_) + wire_end_;
        const std::size_t bytes = convert(window);
        wire_end_ += bytes;
        return append_pixels(converted, static_cast<std::uint32_t>(bytes), 1);
    }
    const std::uint8_t* data = sent_buffer().to_send() + static_cast<std::size_t>(window.y) * sent_stride() +
                               static_cast<std::size_t>(window.x) * pixel_bytes_;
    const std::uint32_t line = static_cast<std::uint32_t>(window.w) * pixel_bytes_;
    const auto rows = static_cast<std::uint32_t>(window.h);
    return line == sent_stride() ? append_pixels(data, line * rows, 1) : append_pixels(data, line, rows);
}

/// Operations that the window's pixels take, as append_pixels() makes them.
std::size_t PanelDisplay::pixel_ops(const Rect& window) const {
    const auto pieces = [](std::size_t whole, std::size_t part) { return (whole + part - 1) / part; };
    const std::size_t limit = op_limit(), line = static_cast<std::uint32_t>(window.w) * pixel_bytes_;
    const auto rows = static_cast<std::size_t>(window.h);
    if (config_.wire.converts()) // one long row
        return pieces(wire_bytes({static_cast<std::int16_t>(window.w), static_cast<std::int16_t>(window.h)}),
                      limit);
    if (line == sent_stride())
        return pieces(line * rows, limit);
    return line > limit ? pieces(line, limit) * rows : pieces(rows, limit / line);
}

/// Whole rows while they fit one operation of the bus, else pieces of rows.
Result<void> PanelDisplay::append_pixels(const std::uint8_t* data, std::uint32_t row_bytes,
                                         std::uint32_t rows) {
    const std::uint32_t limit = op_limit();
    const std::uint32_t piece = row_bytes < limit ? row_bytes : limit;
    const std::uint32_t rows_at_once = row_bytes <= limit ? limit / row_bytes : 1;
    for (std::uint32_t y = 0; y < rows; y += rows_at_once) {
        const std::uint32_t count = rows - y < rows_at_once ? rows - y : rows_at_once;
        for (std::uint32_t x = 0; x < row_bytes; x += piece) {
            if (const auto r = make_room(1); !r)
                return r;
            const std::uint32_t bytes = row_bytes - x < piece ? row_bytes - x : piece;
            ops_.pixels(data + std::size_t{y} * sent_stride() + x, bytes, count,
                        static_cast<std::int32_t>(sent_stride()));
        }
    }
    return {};
}

// --- Damage ---

namespace {

/// Columns inside the picture; the canonical empty row when none are.
RowSpan clip(RowSpan row, std::int16_t width) {
    const RowSpan inside = {row.begin > 0 ? row.begin : std::int16_t{0}, row.end < width ? row.end : width};
    return inside.begin < inside.end ? inside : RowSpan{};
}

} // namespace

/// What differs between the panel's memory and the frame, by row:
///  - what was drawn now;
///  - after a full clear, what the shown frame held outside its clear value, or everything when that value
///  changed;
///  - without one, two buffers: what the last present changed, since this buffer is one frame older;
///  - what a failed transfer leaves unknown;
///  - what was sent in place, which the other buffer does not have.
void PanelDisplay::collect_damage() {
    const PanelContent& shown = content_[front_];
    PanelContent& drawn = content_[back_];
    const bool cleared = extents_.cleared;
    const bool everything = cleared && extents_.clear_value != shown.clear_value;
    const bool keep = suspect_ || behind_ || (!cleared && canvases() == 2);
    const RowSpan all = {0, picture_.width};
    for (std::int32_t y = 0; y < picture_.height; ++y) {
        const RowSpan now = clip(memory_.touched[y], picture_.width);
        RowSpan damage = keep ? unite(memory_.damage[y], now) : now;
        if (everything)
            damage = all;
        if (cleared)
            damage = unite(damage, shown.rows[y]);
        memory_.damage[y] = damage;
        drawn.rows[y] = cleared ? now : unite(drawn.rows[y], now);
    }
    if (cleared)
        drawn.clear_value = extents_.clear_value;
}

/// What differs, in the order of the scan.
void PanelDisplay::turn_damage() {
    std::uint8_t* const to = buffers_[1].to_draw(bus_);
    memory_.turner(scan_,
                   {buffers_[0].to_send(), static_cast<std::int32_t>(stride()), picture_.height, to,
                    static_cast<std::int32_t>(sent_stride()), static_cast<std::int32_t>(pixel_bytes_)},
                   memory_.damage, memory_.turned);
}

// --- Read-back ---

Result<PanelStatus> PanelDisplay::status() {
    if (!ready_)
        return Error{Fault::bad_argument, "display: status before init succeeded"};
    if (const auto r = settle(); !r)
        return r.error();
    return read_status(bus_, *config_.panel, scratch_);
}

Result<std::uint16_t> PanelDisplay::scanline() {
    if (!ready_)
        return Error{Fault::bad_argument, "display: scanline before init succeeded"};
    if (const auto r = settle(); !r)
        return r.error();
    return read_scanline(bus_, *config_.panel, scratch_);
}

Result<void> PanelDisplay::read_back(const Rect& area, std::uint8_t* rgb) {
    if (!ready_)
        return Error{Fault::bad_argument, "display: read_back before init succeeded"};
    if (const auto r = settle(); !r)
        return r;
    windows_.forget();
    if (!turns_)
        return read_pixels(bus_, *config_.panel, placement_, config_.format, area, rgb, scratch_);
    return read_turned(area, rgb);
}

/// Row by row of the picture, each a column or a row of the memory.
Result<void> PanelDisplay::read_turned(const Rect& area, std::uint8_t* rgb) {
    if (area.x < 0 || area.w <= 0 || area.h < 0 || area.w > picture_.width - area.x || area.y < 0 ||
        area.h > picture_.height - area.y)
        return Error{Fault::bad_argument, "panel: the area to read is not inside the picture"};
    const bool backward = scan_.swapped && scan_.reversed;
    const std::int32_t from = backward ? area.x + area.w - 1 : area.x;
    for (std::int32_t y = area.y; y < area.y + area.h; ++y) {
        const Rect part =
            scan_.swapped ? Rect{y, scan_.row_of(from), 1, area.w} : Rect{area.x, scan_.row_of(y), area.w, 1};
        if (const auto r = read_pixels(bus_, *config_.panel, placement_, config_.format, part, rgb, scratch_);
            !r)
            return r;
        if (backward)
            reverse_pixels(rgb, area.w);
        rgb += std::ptrdiff_t{3} * area.w;
    }
    return {};
}

} // namespace spangle::hal

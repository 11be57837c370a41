#include <spangle/hal/panel_display.hpp>

#include "hal/display/frame_plan.hpp"

namespace spangle::hal {
namespace {

/// A transfer is late when it takes twice its time and this.
constexpr std::uint32_t grace_us = 100000;

/// How far behind the beam a frame follows that takes longer than one refresh.
constexpr std::uint32_t lag_lines = 8;

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

} // namespace

PanelDisplay::PanelDisplay(Bus& bus, const PanelConfig& config, const PanelMemory& memory)
    : bus_(bus), config_(config), memory_(memory) {}

DisplayInfo PanelDisplay::info() const {
    const bool described = config_.panel != nullptr;
    const Extent size = described ? place(*config_.panel, config_.orientation).size : Extent{};
    return {described ? config_.panel->name : "",
            size.width,
            size.height,
            config_.format,
            config_.buffers == 1,
            config_.wire != nullptr ? config_.wire->format : WireFormat::none};
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
    const Extent size = place(panel, config_.orientation).size;
    if (config_.row_hash && size.width > RowHash::widest)
        return Error{Fault::unsupported, "display: the row hash serves pictures up to 512 columns"};
    if (config_.row_hash && memory_.hash.cells < RowHash::cells_of(size.width) * size.height)
        return Error{Fault::bad_argument, "display: the storage has no room for the row hash"};
    if (config_.buffers < 1 || config_.buffers > 2)
        return Error{Fault::bad_argument, "display: a panel display has one or two buffers"};
    if (config_.wire != nullptr && config_.buffers != 1)
        return Error{Fault::bad_argument,
                     "display: a picture that is turned into another format needs one buffer"};
    if (memory_.buffers < config_.buffers || memory_.height < size.height ||
        memory_.op_count < least_ops(*panel.commands))
        return Error{Fault::bad_argument, "display: the storage is smaller than the picture asks for"};
    return {};
}

/// Buffers and books of a display that never was initialised: nobody knows what the panel or the buffers
/// hold.
Result<void> PanelDisplay::take_buffers() {
    const std::size_t size = std::size_t{stride()} * static_cast<std::size_t>(placement_.size.height);
    for (unsigned i = 0; i < config_.buffers; ++i) {
        if (buffers_[i].bytes != nullptr)
            continue;
        const Result<Buffer> buffer = bus_.acquire(size);
        if (!buffer)
            return buffer.error();
        if (buffer.value().bytes == nullptr || buffer.value().size < size)
            return Error{Fault::no_answer, "display: the bus gave less memory than one frame"};
        buffers_[i] = buffer.value();
        for (std::size_t at = 0; at < size; ++at)
            buffers_[i].bytes[at] = 0;
        content_[i].rows = memory_.content[i];
        for (std::int32_t y = 0; y < placement_.size.height; ++y)
            content_[i].rows[y] = {0, placement_.size.width};
    }
    if (config_.wire == nullptr || wire_.bytes != nullptr)
        return {};
    // Windows that end inside a byte round up: one a row at most.
    const std::size_t wire_size =
        wire_bytes(placement_.size) + static_cast<std::size_t>(placement_.size.height);
    const Result<Buffer> wire = bus_.acquire(wire_size);
    if (!wire)
        return wire.error();
    if (wire.value().bytes == nullptr || wire.value().size < wire_size)
        return Error{Fault::no_answer, "display: the bus gave less memory than one frame"};
    wire_ = wire.value();
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
    placement_ = place(*config_.panel, config_.orientation);
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
        extents_ = {memory_.touched, placement_.size.height, false, 0};
        for (std::int32_t y = 0; y < placement_.size.height; ++y)
            memory_.touched[y] = RowSpan{};
        front_ = static_cast<std::uint8_t>(config_.buffers - 1);
        back_ = 0;
        opened_ = true;
    }
    for (std::int32_t y = 0; y < placement_.size.height; ++y)
        memory_.damage[y] = {0, placement_.size.width};
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

Result<void> PanelDisplay::finish() {
    if (!in_flight_)
        return {};
    const bool was_late = late_;
    if (const auto r = complete(); !r)
        return r;
    if (!was_late)
        suspect_ = false;
    return {};
}

// --- Frames ---

Result<Frame> PanelDisplay::acquire() {
    if (!ready_)
        return Error{Fault::bad_argument, "display: acquire before init succeeded"};
    if (late_ && !bus_.done(token_))
        return Error{Fault::busy, "display: acquire while a late transfer still reads the frame"};
    const std::int32_t age = presented_ >= config_.buffers ? config_.buffers : 0;
    return Frame{buffers_[back_].bytes, static_cast<std::int32_t>(stride()), age, &extents_};
}

Result<void> PanelDisplay::present() {
    if (!ready_)
        return Error{Fault::bad_argument, "display: present before init succeeded"};
    if (const auto r = finish(); !r)
        return r;
    collect_damage();
    if (hash_.enabled())
        hash_.reduce(memory_.damage, buffers_[back_].bytes, static_cast<std::int32_t>(stride()), suspect_);
    if (const auto r = send(); !r)
        return r;
    if (config_.buffers == 1 && config_.wire == nullptr) {
        if (const auto r = finish(); !r)
            return r;
    }
    accept();
    return {};
}

/// The frame is taken: the next one starts with nothing touched.
void PanelDisplay::accept() {
    front_ = back_;
    if (config_.buffers == 2)
        back_ ^= 1;
    if (presented_ < 2)
        ++presented_;
    extents_.cleared = false;
    for (std::int32_t y = 0; y < extents_.height; ++y)
        memory_.touched[y] = RowSpan{};
}

Result<void> PanelDisplay::send() {
    widen_damage();
    const WindowCost cost = window_cost(caps_, *config_.panel->commands, wire_bits());
    const Extent size = placement_.size;
    // Rows that share bytes cannot be sent apart.
    const bool apart = hash_.enabled() && windows_.shared().height == 1;
    const SpanPlan spans = apart ? SpanPlan(hash_.changed(), size.width, size.height, cost) : SpanPlan();
    FramePlan plan(WindowPlan(memory_.damage, size.height, cost, memory_.plan), spans);
    Rect window;
    if (!plan.next(window))
        return {};
    suspect_ = true; // until the last byte is known to be there
    ops_.clear();
    wire_end_ = 0;
    if (config_.wait_te)
        append_sync(plan.total() / 8);
    do {
        if (const auto r = append_windows(window); !r)
            return r;
    } while (plan.next(window));
    return start();
}

/// Windows end where bytes do: rows that share bytes share the damage.
void PanelDisplay::widen_damage() {
    const Extent shared = windows_.shared();
    if (shared.width == 1 && shared.height == 1)
        return;
    for (std::int32_t y = 0; y < placement_.size.height; y += shared.height) {
        RowSpan all;
        for (std::int32_t i = 0; i < shared.height; ++i)
            all = unite(all, memory_.damage[y + i]);
        if (all.begin < all.end)
            all = {static_cast<std::int16_t>(all.begin / shared.width * shared.width),
                   static_cast<std::int16_t>((all.end + shared.width - 1) / shared.width * shared.width)};
        for (std::int32_t i = 0; i < shared.height; ++i)
            memory_.damage[y + i] = all;
    }
}

/// A frame shorter than a refresh starts at the TE edge and stays ahead of the beam; a longer one follows it,
/// where rows are written in scan order.
void PanelDisplay::append_sync(std::uint32_t bytes) {
    const PanelTiming& timing = config_.panel->timing;
    ops_.wait_te(2 * timing.frame_us + grace_us);
    const bool along_scan = (placement_.madctl & (dcs::MV | dcs::MY)) == 0;
    if (wire_time(caps_, bytes) <= timing.frame_us || !along_scan || timing.scan_lines == 0)
        return;
    ops_.delay(timing.frame_us / timing.scan_lines * (timing.porch_lines + lag_lines));
}

Result<void> PanelDisplay::append_windows(const Rect& area) {
    return for_each_window(windows_, area, [this](const Rect& window) { return append_window(window); });
}

/// Turns the window's pixels into the wire's, behind those of the windows before it.
std::size_t PanelDisplay::convert(const Rect& window) {
    const Picture picture = {buffers_[back_].bytes, static_cast<std::int32_t>(stride()),
                             placement_.size.height, config_.format, (placement_.madctl & dcs::MV) != 0};
    return config_.wire->convert(picture, window, wire_.bytes + wire_end_);
}

Result<void> PanelDisplay::append_window(const Rect& window) {
    if (const auto r = make_room(windows_.commands() + 1); !r)
        return r;
    windows_.open(ops_, window);
    if (config_.wire != nullptr) {
        const std::uint8_t* const converted = wire_.bytes + wire_end_;
        const std::size_t bytes = convert(window);
        wire_end_ += bytes;
        return append_pixels(converted, static_cast<std::uint32_t>(bytes), 1);
    }
    const std::uint8_t* data = buffers_[back_].bytes + static_cast<std::size_t>(window.y) * stride() +
                               static_cast<std::size_t>(window.x) * pixel_bytes_;
    const std::uint32_t line = static_cast<std::uint32_t>(window.w) * pixel_bytes_;
    const auto rows = static_cast<std::uint32_t>(window.h);
    return line == stride() ? append_pixels(data, line * rows, 1) : append_pixels(data, line, rows);
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
            ops_.pixels(data + std::size_t{y} * stride() + x, bytes, count,
                        static_cast<std::int32_t>(stride()));
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
///  - what a failed transfer leaves unknown.
void PanelDisplay::collect_damage() {
    const PanelContent& shown = content_[front_];
    PanelContent& drawn = content_[back_];
    const bool cleared = extents_.cleared;
    const bool everything = cleared && extents_.clear_value != shown.clear_value;
    const bool keep = suspect_ || (!cleared && config_.buffers == 2);
    const RowSpan all = {0, placement_.size.width};
    for (std::int32_t y = 0; y < placement_.size.height; ++y) {
        const RowSpan now = clip(memory_.touched[y], placement_.size.width);
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

// --- Read-back ---

Result<PanelStatus> PanelDisplay::status() {
    if (!ready_)
        return Error{Fault::bad_argument, "display: status before init succeeded"};
    if (const auto r = finish(); !r)
        return r.error();
    return read_status(bus_, *config_.panel, scratch_);
}

Result<std::uint16_t> PanelDisplay::scanline() {
    if (!ready_)
        return Error{Fault::bad_argument, "display: scanline before init succeeded"};
    if (const auto r = finish(); !r)
        return r.error();
    return read_scanline(bus_, *config_.panel, scratch_);
}

Result<void> PanelDisplay::read_back(const Rect& area, std::uint8_t* rgb) {
    if (!ready_)
        return Error{Fault::bad_argument, "display: read_back before init succeeded"};
    if (const auto r = finish(); !r)
        return r;
    windows_.forget();
    return read_pixels(bus_, *config_.panel, placement_, config_.format, area, rgb, scratch_);
}

} // namespace spangle::hal

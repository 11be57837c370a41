// Initialises a panel, from power-on to a black picture. Descriptions that cannot work are refused first.
#include <spangle/hal/panel_display.hpp>
#include <spangle/hal/panel_rules.hpp>

namespace spangle::hal {
namespace {

/// The least room in the list of operations. A window's commands and its pixels go into one list.
constexpr std::size_t least_ops(const CommandSet& set) {
    const std::uint32_t window = window_size(set).commands + 1;
    return window > 8 ? window : 8;
}

} // namespace

Result<void> check_memory(const PanelConfig& config, const PanelMemory& memory) {
    if (is_indexed(config.format) && memory.palette == nullptr)
        return Error{Fault::bad_argument, "display: the storage has no room for the palette of indices"};
    if (turns(config) && (memory.turned == nullptr || memory.turner == nullptr))
        return Error{Fault::bad_argument, "display: the storage has no room for turned frames"};
    const Extent size = sent_size(config);
    if (config.row_hash && (memory.hash.code == nullptr || memory.hash.windows == nullptr ||
                            memory.hash.cells < RowHash::cells_of(size.width) * size.height))
        return Error{Fault::bad_argument, "display: the storage has no room for the row hash"};
    const bool sent_whole = config.band != 0 && memory.content_height == 0;
    if (memory.buffers < config.buffers || memory.height < book_height(config) ||
        (memory.content_height < picture_size(config).height && !sent_whole) ||
        memory.op_count < least_ops(*config.panel->commands))
        return Error{Fault::bad_argument, "display: the storage is smaller than the picture asks for"};
    return {};
}

/// Checks what a Board was checked for when it was compiled, and the memory, which a BoardDisplay computes.
Result<void> PanelDisplay::check_description(const PanelConfig& config, const PanelMemory& memory) {
    if (const auto r = check_config(config); !r)
        return r;
    return check_memory(config, memory);
}

/// Acquires the buffers and records of a display that was never initialised. The contents of the panel and of
/// the buffers count as unknown.
Result<void> PanelDisplay::take_buffers() {
    const std::size_t size =
        std::size_t{stride()} *
        static_cast<std::size_t>(stored_rows(config_.format, held(config_, picture_).height));
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
        if (memory_.content_height == 0)
            continue;
        content_[i].rows = memory_.content[i];
        for (std::int32_t y = 0; y < picture_.height; ++y)
            content_[i].rows[y] = {0, picture_.width};
    }
    if (!config_.wire.converts() || !wire_.empty())
        return {};
    // A window that ends inside of a byte takes one more byte. There is at most one window per row.
    const Extent most = held(config_, placement_.size);
    const std::size_t wire_size = wire_bytes(most) + static_cast<std::size_t>(most.height);
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
    if (parts_.check != nullptr)
        if (const auto r = parts_.check(config_, memory_); !r)
            return r;
    if (const auto r = check_bus(config_, caps_); !r)
        return r;
    if (!is_drawable(config_.format))
        return Error{Fault::unsupported,
                     "display: this build has no such surfaces (SPANGLE_FEATURE_NARROW_SURFACES, "
                     "SPANGLE_FEATURE_COLOR_INDEX)"};
    turns_ = turns(config_);
    scan_ = scan_order(*config_.panel, config_.orientation);
    placement_ = turns_ ? scan_.placement : place(*config_.panel, config_.orientation);
    picture_ = picture_size(config_);
    windows_ = Windows(*config_.panel, placement_, wire_format(config_));
    ops_ = OpList(memory_.ops, memory_.params, memory_.op_count);
    ops_.parameters_are_commands(config_.panel->commands->parameters_are_commands);
    if (config_.row_hash)
        hash_ = RowHash(memory_.hash, placement_.size.width, placement_.size.height,
                        format_info(config_.format).bits);
    if (const auto r = take_buffers(); !r)
        return r;
    forget_content();
    ready_ = false; // a present must not succeed on a panel that was left in the middle of this
    if (!opened_) {
        extents_ = {memory_.touched, held(config_, picture_).height, false, 0};
        forget_extents();
        if (is_indexed(config_.format))
            begin_palette();
        front_ = static_cast<std::uint8_t>(canvases() - 1);
        back_ = 0;
        opened_ = true;
    }
    for (std::int32_t y = 0; y < extents_.height; ++y)
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
    if (parts_.measure != nullptr)
        if (const auto r = (this->*parts_.measure)(); !r)
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
        return parts_.identify(bus_, *config_.panel, scratch_);
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
        ops_.command(*step.command, step.params, step.count);
    }
    return {};
}

Result<void> PanelDisplay::append_registers() {
    const PanelDesc& panel = *config_.panel;
    const CommandSet& set = *panel.commands;
    const FormatCode format = format_code(panel, caps_.kind, wire_format(config_));
    if (const auto r = make_room(set.setting_count); !r)
        return r;
    append_settings(ops_, panel, placement_, format);
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

/// Appends black pixels, so that the display starts black. Its memory holds noise after power-on.
Result<void> PanelDisplay::append_black() {
    return for_each_window(windows_, {0, 0, placement_.size.width, placement_.size.height},
                           [this](const Rect& window) { return append_black_window(window); });
}

Result<void> PanelDisplay::append_black_window(const Rect& window) {
    // Operations repeat whole pixels where a pixel has whole bytes.
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

/// The bytes that a rectangle of pixels takes on the wire, rounded up.
std::size_t PanelDisplay::wire_bytes(const Extent& size) const {
    const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    return (pixels * wire_bits() + 7) / 8;
}

} // namespace spangle::hal

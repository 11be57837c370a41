// Initialises a panel, from power-on to a black picture. What cannot work is refused first.
#include <spangle/hal/panel_display.hpp>
#include <spangle/hal/panel_rules.hpp>

namespace spangle::hal {
namespace {

/// The least room in the list: a window's commands and its pixels go into one list.
constexpr std::size_t least_ops(const CommandSet& set) {
    const std::uint32_t window = window_size(set).commands + 1;
    return window > 8 ? window : 8;
}

} // namespace

void PanelLayout::resolve() {
    if (hal::turns(config))
        scan = scan_order(*config.panel, config.orientation);
    else
        scan = {place(*config.panel, config.orientation), false, false};
    picture = picture_size(config);
}

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

/// Acquires buffers and records of a display that was never initialised: what the panel and the buffers hold
/// is unknown.
Result<void> PanelDisplay::take_buffers() {
    const PanelConfig& config = layout_.config;
    const std::size_t size =
        std::size_t{layout_.stride()} *
        static_cast<std::size_t>(stored_rows(config.format, held(config, layout_.picture).height));
    for (std::uint8_t i = 0; i < config.buffers; ++i) {
        if (!buffers_[i].empty())
            continue;
        const Result<Buffer> buffer = transfer_.bus().acquire(size);
        if (!buffer)
            return buffer.error();
        if (buffer.value().bytes == nullptr || buffer.value().size < size)
            return Error{Fault::no_answer, "display: the bus gave less memory than one frame"};
        buffers_[i] = BusBuffer(buffer.value());
        for (std::size_t at = 0; at < size; ++at)
            buffer.value().bytes[at] = 0;
        if (book_memory().content_height != 0)
            book_.open_content(i);
    }
    return presenter_.acquire_wire();
}

Result<void> PanelDisplay::init() {
    const PanelConfig& config = layout_.config;
    if (config.panel == nullptr)
        return Error{Fault::bad_argument, "display: init without a panel"};
    (void)settle();
    if (transfer_.in_flight())
        return Error{Fault::busy, "display: init while a transfer is still on the wire"};
    const BusCaps caps = transfer_.bus().caps();
    if (parts_.check != nullptr)
        if (const auto r = parts_.check(config, book_memory()); !r)
            return r;
    if (const auto r = check_bus(config, caps); !r)
        return r;
    if (!is_drawable(config.format))
        return Error{Fault::unsupported,
                     "display: this build has no such surfaces (SPANGLE_FEATURE_NARROW_SURFACES, "
                     "SPANGLE_FEATURE_COLOR_INDEX)"};
    layout_.resolve();
    transfer_.open(caps, OpList(book_memory().ops, book_memory().params, book_memory().op_count));
    if (const auto r = take_buffers(); !r)
        return r;
    bands_.open(in_bands() && book_memory().content_height != 0 ? book_memory().content[0] : nullptr);
    ready_ = false; // if init() fails from here on, presents must fail, too
    if (!opened_) {
        book_.open_buffers(held(config, layout_.picture).height);
        if (is_indexed(config.format))
            book_memory().palette->begin();
        front_ = static_cast<std::uint8_t>(layout_.canvases() - 1);
        back_ = 0;
        opened_ = true;
    }
    book_.open();
    if (const auto r = reset_panel(); !r)
        return r;
    if (const auto r = set_up(); !r)
        return r;
    if (parts_.measure != nullptr)
        if (const auto r = parts_.measure(pacer_); !r)
            return r;
    ready_ = true;
    return {};
}

Result<void> PanelDisplay::reset_panel() {
    const PanelDesc& panel = *layout_.config.panel;
    if (layout_.config.reset_line)
        transfer_.list().reset(panel.timing.reset_low_us);
    else if (const auto r = transfer_.append(panel.commands->soft_reset); !r)
        return r;
    transfer_.list().delay(panel.timing.reset_wait_us);
    if (const auto r = transfer_.run(); !r)
        return r;
    if (layout_.config.read_back)
        return parts_.identify(transfer_.bus(), panel, scratch_);
    return {};
}

/// Sets the panel up and turns it on, black: not with the noise that its memory wakes up with.
Result<void> PanelDisplay::set_up() {
    if (const auto r = transfer_.append(layout_.config.panel->setup); !r)
        return r;
    if (const auto r = append_registers(); !r)
        return r;
    const Extent all = layout_.placement().size;
    const auto black =
        for_each_window(transfer_.windows(), {0, 0, all.width, all.height}, [this](const Rect& w) {
            return transfer_.append_black(w, layout_.wire_bytes(w.w, w.h));
        });
    if (!black)
        return black;
    if (const auto r = transfer_.append(layout_.config.panel->commands->light); !r)
        return r;
    return transfer_.run();
}

Result<void> PanelDisplay::append_registers() {
    const PanelDesc& panel = *layout_.config.panel;
    const CommandSet& set = *panel.commands;
    const FormatCode format = format_code(panel, transfer_.caps().kind, wire_format(layout_.config));
    if (const auto r = transfer_.make_room(set.setting_count); !r)
        return r;
    append_settings(transfer_.list(), panel, layout_.placement(), format);
    if (layout_.config.wait_te)
        if (const auto r = transfer_.append(set.tearing); !r)
            return r;
    if (const auto r = transfer_.append(set.wake); !r)
        return r;
    if (const auto r = transfer_.make_room(1); !r)
        return r;
    if (panel.timing.sleep_out_wait_us != 0)
        transfer_.list().delay(panel.timing.sleep_out_wait_us);
    return {};
}

} // namespace spangle::hal

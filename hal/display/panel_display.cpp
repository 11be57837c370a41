// Frames of a panel: how they are acquired, put off and shown, whole or in bands.
#include <spangle/hal/panel_display.hpp>

namespace spangle::hal {

constexpr PanelDisplay::Parts PanelDisplay::every_part = {
    &PanelDisplay::check_description,
    check_identity,
    [](Pacer& pacer) { return pacer.measure(); },
    Presenter::parts(true, true),
    [](PanelDisplay& d) { return d.acquire_frame(); },
    [](PanelDisplay& d) { return d.present_frame(); },
    [](PanelDisplay& d, bool in_place) { return d.show(in_place); },
    [](PanelDisplay& d, std::int32_t first, std::int32_t rows) { return d.acquire_rows(first, rows); },
    [](PanelDisplay& d) { return d.present_rows(); },
    [](PanelDisplay& d) { return d.send_changed_rows(); },
};

PanelDisplay::PanelDisplay(Bus& bus, const PanelConfig& config, const PanelMemory& memory, const Parts& parts)
    : parts_(parts), layout_(config), transfer_(bus, layout_), book_(layout_, memory), bands_(layout_),
      pacer_(transfer_), presenter_(book_.memory(), transfer_, pacer_) {}

DisplayInfo PanelDisplay::info() const {
    const PanelConfig& config = layout_.config;
    const bool described = config.panel != nullptr;
    const Extent size = described ? picture_size(config) : Extent{};
    return {described ? config.panel->name : "",
            size.width,
            size.height,
            config.format,
            config.buffers == 1 || (described && turns(config)),
            config.wire.converts() ? config.wire.format : WireFormat::none,
            described && config.band > size.height ? size.height : config.band,
            described ? band_unit(config) : 1};
}

// --- What is on the wire ---

/// Waits for what is on the wire. Where it failed, nobody knows which of its rows arrived.
Result<void> PanelDisplay::settle() {
    if (!transfer_.in_flight())
        return {};
    const bool was_late = transfer_.late();
    if (const auto r = transfer_.complete(); !r) {
        book_.doubt();
        bands_.forget(); // the failed transfer may have sent rows of a band
        return r;
    }
    if (!was_late)
        book_.trust();
    return {};
}

/// Notes that rows went out, or failed to: they are in doubt until the last byte is known to have arrived.
Result<void> PanelDisplay::sent(Result<void> outcome) {
    if (!outcome || transfer_.in_flight())
        book_.doubt();
    return outcome;
}

Result<void> PanelDisplay::finish() {
    if (const auto r = settle(); !r)
        return r;
    if (parts_.show == nullptr || !book_.owed() || book_.drawn_since())
        return {};
    if (const auto r = parts_.show(*this, true); !r)
        return r;
    return settle();
}

Result<void> PanelDisplay::poll() {
    if (parts_.show == nullptr || !book_.owed() || book_.drawn_since() || transfer_.busy())
        return {};
    if (const auto r = settle(); !r)
        return r;
    return parts_.show(*this, false);
}

// --- Whole frames ---

Result<Frame> PanelDisplay::acquire() {
    if (!ready_)
        return Error{Fault::bad_argument, "display: acquire before init succeeded"};
    if (in_bands())
        return Error{Fault::unsupported, "display: frames of this display are drawn in bands"};
    return parts_.acquire(*this);
}

Result<Frame> PanelDisplay::acquire_frame() {
    std::uint8_t* const pixels = buffers_[back_].to_draw(transfer_.bus());
    if (pixels == nullptr)
        return Error{Fault::busy, "display: acquire while a late transfer still reads the frame"};
    const std::uint32_t age = drawn_in_[back_] == 0 ? 0 : frame_ - drawn_in_[back_] + 1;
    return Frame{pixels, static_cast<std::int32_t>(layout_.stride()), static_cast<std::int32_t>(age),
                 &book_.extents()};
}

Result<void> PanelDisplay::present() {
    if (!ready_)
        return Error{Fault::bad_argument, "display: present before init succeeded"};
    if (in_bands())
        return Error{Fault::unsupported, "display: frames of this display are drawn in bands"};
    return parts_.present(*this);
}

Result<void> PanelDisplay::present_frame() {
    if (pacer_.puts_off()) {
        drawn_in_[back_] = ++frame_;
        if (layout_.config.pacing != Pacing::drop)
            book_.hold_back();
        return {};
    }
    if (const auto r = settle(); !r)
        return r;
    const std::uint8_t drawn = back_;
    if (const auto r = show(false); !r)
        return r;
    drawn_in_[drawn] = ++frame_;
    return {};
}

/// Sends the frame that was drawn. `in_place`: the next frame is drawn in the same buffer.
Result<void> PanelDisplay::show(bool in_place) {
    const PanelConfig& config = layout_.config;
    book_.collect(front_, back_);
    const std::uint8_t* const drawn = buffers_[back_].to_send();
    const bool recolored = is_indexed(config.format) && book_.collect_recolored(drawn);
    if (layout_.turns())
        book_.turn(buffers_[0].to_send(), buffers_[1].to_draw(transfer_.bus()));
    BusBuffer& buffer = sent_buffer();
    if (book_.hash().enabled())
        book_.reduce(buffer.to_send(), recolored);
    const std::int32_t rows = layout_.placement().size.height;
    book_.widen(layout_.shared(transfer_.windows().shared()), rows);
    if (const auto r =
            sent(presenter_.send({&buffer, 0, rows}, book_.sent_damage(), book_.hash(), parts_.sending));
        !r)
        return r;
    if (config.buffers == 1 && !config.wire.converts()) {
        if (const auto r = settle(); !r)
            return r;
    }
    front_ = back_;
    if (!in_place && layout_.canvases() == 2)
        back_ ^= 1;
    book_.accept(in_place);
    return {};
}

// --- Bands: one is drawn in a buffer of some rows, and sent while the next one is drawn ---

Result<Frame> PanelDisplay::acquire_band(std::int32_t first, std::int32_t rows) {
    if (!ready_)
        return Error{Fault::bad_argument, "display: acquire before init succeeded"};
    if (!in_bands())
        return whole_frames();
    return parts_.acquire_band(*this, first, rows);
}

Result<Frame> PanelDisplay::acquire_rows(std::int32_t first, std::int32_t rows) {
    if (const auto r = bands_.check(first, rows); !r)
        return r.error();
    std::uint8_t* const pixels = buffers_[back_].to_draw(transfer_.bus());
    if (pixels == nullptr)
        return Error{Fault::busy, "display: acquire while a late transfer still reads the band"};
    if (first == 0 && is_indexed(layout_.config.format) && book_memory().palette->any_stale()) {
        // Pixels of an index whose colour has changed were drawn in earlier bands, which no buffer holds any
        // more.
        bands_.forget();
        book_memory().palette->all_fresh();
    }
    bands_.begin(first, rows);
    const std::size_t bytes =
        std::size_t{layout_.stride()} * static_cast<std::size_t>(stored_rows(layout_.config.format, rows));
    for (std::size_t at = 0; at < bytes; ++at)
        pixels[at] = 0;
    book_.begin_band(rows);
    return Frame{pixels, static_cast<std::int32_t>(layout_.stride()), 0, &book_.extents()};
}

Result<void> PanelDisplay::present_band() {
    if (!ready_ || !bands_.acquired())
        return Error{Fault::bad_argument, "display: a band is presented that was not acquired"};
    return parts_.present_band(*this);
}

Result<void> PanelDisplay::present_rows() {
    if (const auto r = settle(); !r)
        return r;
    bands_.hand_over();
    if (const auto r = sent(parts_.send_band(*this)); !r) {
        bands_.forget();
        return r;
    }
    if (bands_.sent())
        ++frame_;
    if (layout_.config.buffers == 2)
        back_ ^= 1;
    else if (!layout_.config.wire.converts())
        return settle();
    return {};
}

Result<void> PanelDisplay::send_changed_rows() {
    bands_.collect(book_.extents(), book_.damage());
    book_.widen(layout_.shared(transfer_.windows().shared()), bands_.rows());
    return presenter_.send({&buffers_[back_], bands_.first(), bands_.rows()}, book_.damage(), book_.hash(),
                           parts_.sending);
}

/// Sends a band whole: nothing records what the panel shows.
Result<void> PanelDisplay::send_all_rows() {
    return presenter_.send_all({&buffers_[back_], bands_.first(), bands_.rows()});
}

// --- Colours ---

Result<void> PanelDisplay::set_palette(std::int32_t first, std::int32_t count, const std::uint8_t* rgb) {
    if (!opened_ || !is_indexed(layout_.config.format))
        return Error{Fault::unsupported,
                     "display: its surface is not one of indices, or before init succeeded"};
    if (!in_palette(first, count))
        return Error{Fault::bad_argument, "display: indices of a palette are 0 to 255"};
    book_memory().palette->set(first, count, rgb);
    return {};
}

} // namespace spangle::hal

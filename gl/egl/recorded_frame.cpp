// Windows in bands whose frames are recorded. The record is replayed to show or to read a band.
#include <new>

#include "gl/context/error.hpp"
#include "gl/egl/objects.hpp"
#include "raster/band/record.hpp"

namespace spangle::egl {

#if SPANGLE_HAS_RECORDS

struct RecordedFrame {
    raster::Record record;
    gl::Recording hooks{};
    gl::ShareGroup* objects = nullptr; ///< objects that the record uses, held while no context is current
    /// True if this frame cannot be shown, because it was drawn with another context's objects.
    bool lost = false;
    /// True if a full record is no error, because spangle::frame then draws band by band.
    bool quiet = false;
    std::int32_t shown = -1; ///< first row, from the top, of the band in memory; -1: none
    std::size_t used = 0;    ///< bytes that the record had when this band was drawn
};

namespace {

/// Replays the record into the band in memory, and returns that band.
raster::Surface replay_frame(Surface& surface, bool count) {
    raster::Surface band = pixels_of(surface);
    surface.band.record->record.replay(band, count);
    return band;
}

/// Gives GL the whole window as its drawable, with no row in memory.
void show_all(Surface& surface) {
    surface.band.first = 0;
    surface.band.rows = surface.height;
    surface.band.record->shown = -1;
    gl::move_drawable(*thread().context->gl, pixels_of(surface), true, &surface.band.record->hooks);
}

/// Drops the recorded frame and begins the next one.
void forget(Surface& surface) {
    RecordedFrame& frame = *surface.band.record;
    frame.record.clear();
    frame.lost = false;
    gl::forget_images(*thread().context->gl);
    show_all(surface);
}

raster::Surface rows_of(std::int32_t y) {
    Surface& surface = *thread().draw;
    RecordedFrame& frame = *surface.band.record;
    const std::int32_t step = surface.band.height, first = (surface.height - 1 - y) / step * step,
                       left = surface.height - first;
    raster::Surface none;
    none.end_row = 0;
    if (frame.record.full())
        return none; // the record is incomplete, so its pixels are unknown
    if (frame.shown != first || frame.used != frame.record.used()) {
        frame.shown = -1; // the value stays -1 if the display gives no buffer
        if (!open_band(*thread().display, surface, first, step < left ? step : left))
            return none;
        raster::resolve(replay_frame(surface, false));
        frame.shown = first;
        frame.used = frame.record.used();
    }
    surface.band.first = first;
    surface.band.rows = step < left ? step : left;
    const raster::Surface band = pixels_of(surface);
    surface.band.first = 0;
    surface.band.rows = surface.height;
    return band;
}

void count_recorded() {
    Surface& surface = *thread().draw;
    RecordedFrame& frame = *surface.band.record;
    if (!frame.record.has_uncounted())
        return;
    (void)each_band(surface, [&](std::int32_t first, std::int32_t rows) {
        if (!open_band(*thread().display, surface, first, rows))
            return false;
        (void)replay_frame(surface, true);
        return true;
    });
    frame.record.mark_counted();
    frame.shown = -1;
    surface.band.first = 0;
    surface.band.rows = surface.height;
}

void too_small() {
    if (!thread().draw->band.record->quiet)
        gl::drawing_error(
            *thread().context->gl, GL_OUT_OF_MEMORY,
            SPANGLE_TEXT("the record of this frame is full (EGL_BAND_RECORD_SPANGLE): it will not be "
                         "shown"));
}

bool send_record(Display& display, Surface& surface) {
    return each_band(surface, [&](std::int32_t first, std::int32_t rows) {
        if (!open_band(display, surface, first, rows))
            return false;
        (void)replay_frame(surface, true);
        return send_band(display, surface);
    });
}

} // namespace

bool make_record(EGLint bytes, Band& band) {
    if (bytes == 0)
        return true;
    constexpr std::size_t header = (sizeof(RecordedFrame) + 7) / 8 * 8;
    void* const memory = arena().allocate(header + static_cast<std::size_t>(bytes));
    if (memory == nullptr)
        return false;
    auto* const frame = new (memory) RecordedFrame;
    frame->record.give(static_cast<std::uint8_t*>(memory) + header, static_cast<std::size_t>(bytes));
    frame->record.on_full = too_small;
    frame->hooks = {&frame->record, rows_of, count_recorded};
    band.record = frame;
    return true;
}

EGLint record_bytes(const Band& band, bool peak) {
    if (band.record == nullptr)
        return 0;
    const raster::Record& record = band.record->record;
    return static_cast<EGLint>(peak ? record.peak() : record.size());
}

void free_record(Band& band) {
    if (band.record != nullptr)
        gl::release_objects(band.record->objects);
    arena().free(band.record);
    band.record = nullptr;
}

bool present_record(Display& display, Surface& surface) {
    const gl::SharedObjects textures(*thread().context->gl);
    RecordedFrame& frame = *surface.band.record;
    const bool whole = !frame.record.full() && !frame.lost;
    const bool shown = whole && send_record(display, surface);
    if (!whole)
        fail(EGL_BAD_ALLOC, SPANGLE_TEXT("the record of this frame is not whole; the panel keeps "
                                         "its picture"));
    forget(surface);
    return shown;
}

bool draw_recorded(Display& display, Surface& surface, void (*draw)(void*), void* data) {
    RecordedFrame& frame = *surface.band.record;
    forget(surface);
    frame.quiet = true;
    draw(data);
    frame.quiet = false;
    begin_call(SPANGLE_TEXT("spangle::frame"));
    if (thread().draw != &surface)
        return fail(EGL_BAD_SURFACE, SPANGLE_TEXT("the window is current no more")) != EGL_FALSE;
    if (in_primitive())
        return fail_in_primitive() != EGL_FALSE;
    if (!frame.record.full())
        return present_record(display, surface);
    frame.record.clear();
    const bool drawn = draw_bands(display, surface, draw, data);
    if (thread().draw == &surface && !in_primitive())
        forget(surface);
    return drawn;
}

void attach_record(Surface& surface) {
    RecordedFrame* const frame = surface.band.record;
    if (frame == nullptr)
        return;
    gl::Context& context = *thread().context->gl;
    if (frame->objects != nullptr && !gl::has_objects(context, *frame->objects)) {
        frame->record.clear(); // the record refers to textures that are not this context's
        frame->lost = true;
    }
    gl::release_objects(frame->objects);
    frame->objects = nullptr;
    show_all(surface);
}

void detach_record(Surface& surface) {
    RecordedFrame* const frame = surface.band.record;
    if (frame == nullptr)
        return;
    {
        const gl::SharedObjects textures(*thread().context->gl);
        count_recorded();
    }
    frame->record.forget_counters();
    if (!frame->record.empty())
        frame->objects = gl::hold_objects(*thread().context->gl);
}

#else

bool make_record(EGLint, Band&) {
    return true;
}
EGLint record_bytes(const Band&, bool) {
    return 0;
}
void free_record(Band&) {}
bool present_record(Display&, Surface&) {
    return false;
}
bool draw_recorded(Display&, Surface&, void (*)(void*), void*) {
    return false;
}
void attach_record(Surface&) {}
void detach_record(Surface&) {}

#endif

} // namespace spangle::egl

// Windows in bands: memory holds one band of rows at a time, and a callback draws each band.
#include <spangle/frame.hpp>

#include <cstring>
#include <new>

#include "gl/context/error.hpp"
#include "gl/egl/objects.hpp"
#include "gl/vertex/engine.hpp"
#include "raster/band/batch_rows.hpp"

namespace spangle {

#if SPANGLE_FEATURE_BANDS

namespace egl {

namespace {

/// Tells GL which rows of the window are in memory. Without an open band, nothing can be drawn or read.
void give_rows(Surface& surface, raster::BatchRows* batches = nullptr) {
    const Thread& t = thread();
    gl::move_drawable(*t.context->gl, pixels_of(surface), t.read == t.draw, nullptr, batches);
}

/// Begins this band in the table of batches. Returns the table, which notes and skips batches, or null.
/// Reference engines have no such table.
raster::BatchRows* begin_batches(const Surface& surface) {
    const Band& band = surface.band;
    if (band.batches == nullptr || thread().context->gl->engine != &gl::fixed_engine)
        return nullptr;
    if (band.first == 0)
        band.batches->begin_frame();
    else
        band.batches->begin_band(surface.height - band.first - band.rows, surface.height - band.first);
    return band.batches;
}

/// Clears depth, stencil, accumulation and samples, so that every band begins with the same contents.
void clear_planes(const Surface& surface, std::int32_t rows) {
    const std::size_t pixels = static_cast<std::size_t>(surface.width) * static_cast<std::size_t>(rows),
                      depth = surface.config.depth == DepthFormat::z16 ? 2 : 4;
    const unsigned samples = surface.config.multisampled ? raster::sample_count : 1;
    for (unsigned i = 0; i < samples && surface.depth != nullptr; ++i)
        std::memset(surface.depth + i * surface.samples.next_depth, 0, pixels * depth);
    if (surface.accum != nullptr)
        std::memset(surface.accum, 0, pixels * 4 * sizeof *surface.accum);
    if (!surface.config.multisampled)
        return;
    std::memset(surface.sample_colors, 0,
                raster::sample_count * static_cast<std::size_t>(surface.samples.next_color));
    for (std::int32_t y = 0; y < rows; ++y)
        surface.unresolved[y] = RowSpan{};
}

/// Marks rows [first, first + rows) of the picture as touched in all columns.
void touch_rows(const Surface& surface, std::int32_t first, std::int32_t rows) {
    for (std::int32_t y = first; y < first + rows; ++y)
        surface.frame.extents->rows[y] = {0, static_cast<std::int16_t>(surface.width)};
}

} // namespace

bool open_band(Display& display, Surface& surface, std::int32_t first, std::int32_t rows) {
    Band& band = surface.band;
    const gl::LockGuard held(display.native_lock);
    if (surface.cut_off)
        return fail_cut_off();
    if (band.colors) {
        surface.frame = {}; // acquire_band() may take the last band's buffer back
        const hal::Result<hal::Frame> frame = native_of(display, surface).acquire_band(first, rows);
        if (!frame.ok())
            return fail(EGL_BAD_NATIVE_WINDOW, frame.error().rule) != EGL_FALSE;
        if (!take(display, surface, frame.value()))
            return false;
    } else if (first == 0 && !next_frame(display, surface)) {
        return false;
    }
    const RowExtents* const all = surface.frame.extents;
    if (all != nullptr && all->rows != nullptr && !band.colors)
        band.extents = {all->rows + first, rows, false, 0};
    band.first = first;
    band.rows = rows;
    clear_planes(surface, rows);
    return true;
}

namespace {

/// Adds the extents of a band to those of the frame. The frame counts as cleared if all its bands were
/// cleared to the same value. Otherwise, cleared bands count as touched.
void gather_extents(Surface& surface) {
    Band& band = surface.band;
    RowExtents* const all = surface.frame.extents;
    if (all == nullptr || all->rows == nullptr)
        return;
    const bool cleared = band.extents.cleared;
    if (band.first == 0) {
        band.cleared = cleared;
    } else if (band.cleared && !(cleared && band.extents.clear_value == band.clear_value)) {
        touch_rows(surface, 0, band.first);
        band.cleared = false;
    }
    band.clear_value = band.extents.clear_value;
    if (cleared && !band.cleared)
        touch_rows(surface, band.first, band.rows);
    if (band.cleared && band.first + band.rows == surface.height) {
        all->cleared = true;
        all->clear_value = band.clear_value;
    }
}

} // namespace

bool send_band(Display& display, Surface& surface) {
    const gl::LockGuard held(display.native_lock);
    if (surface.cut_off)
        return fail_cut_off();
    raster::resolve(pixels_of(surface));
    if (!surface.band.colors) {
        gather_extents(surface);
        return true;
    }
    const hal::Result<void> sent = native_of(display, surface).present_band();
    surface.frame = {}; // present_band() has taken the band's buffer back
    return sent.ok() || fail(EGL_BAD_NATIVE_WINDOW, sent.error().rule) != EGL_FALSE;
}

namespace {

bool present_whole(Display& display, Surface& surface) {
    const gl::LockGuard held(display.native_lock);
    if (surface.cut_off)
        return fail_cut_off();
    const hal::Result<void> shown = native_of(display, surface).present();
    if (!shown.ok())
        return fail(EGL_BAD_NATIVE_WINDOW, shown.error().rule) != EGL_FALSE;
    surface.frame = {}; // present() has taken the frame's buffer back
    return true;
}

/// Draws and sends every band until one fails.
bool draw_each(Display& display, Surface& surface, void (*draw)(void*), void* data) {
    const bool drawn = each_band(surface, [&](std::int32_t first, std::int32_t rows) {
        if (!open_band(display, surface, first, rows))
            return false;
        give_rows(surface, begin_batches(surface));
        draw(data);
        begin_call(SPANGLE_TEXT("spangle::frame"));
        if (thread().draw != &surface)
            return fail(EGL_BAD_SURFACE, SPANGLE_TEXT("the window is current no more")) != EGL_FALSE;
        if (in_primitive())
            return fail_in_primitive() != EGL_FALSE;
        return send_band(display, surface);
    });
    return drawn && (surface.band.colors || present_whole(display, surface));
}

} // namespace

void make_batches(std::int32_t height, Band& band) {
    if (band.height == 0 || band.height >= height || band.record != nullptr)
        return;
    void* const memory = arena().allocate(sizeof(raster::BatchRows));
    if (memory != nullptr)
        band.batches = new (memory) raster::BatchRows(height);
}

EGLint choose_band(const hal::DisplayInfo& info, EGLint wish, Band& band) {
    if (wish < 0)
        return EGL_BAD_PARAMETER;
    band.colors = info.band_height != 0;
    if (band.colors && wish > info.band_height)
        return EGL_BAD_MATCH; // the display's buffer holds no higher band
    const std::int32_t unit = band.colors ? info.band_unit : 1, most = info.height + unit - 1;
    // Rows that share bytes are counted from the bottom, and bands from the top. The height must therefore be
    // a multiple of the rows per byte, or bands would begin within a byte.
    if (band.colors && info.height % format_info(info.format).rows != 0)
        return EGL_BAD_MATCH;
    const std::int32_t rows = wish != 0 ? (wish < most ? wish : most) : info.band_height;
    band.height = (rows + unit - 1) / unit * unit;
    return EGL_SUCCESS;
}

void show_band(Surface& surface, raster::Surface& out) {
    Band& band = surface.band;
    out.end_row = surface.height - band.first;
    out.first_row = out.end_row - band.rows;
    if (band.rows == 0)
        out.end_row = out.first_row = 0;
    if (out.accum != nullptr) // the accumulation buffer begins with the band's lowest row
        out.accum -= std::ptrdiff_t{4} * surface.width * out.first_row;
#if SPANGLE_EXTENTS
    if (out.touched != nullptr && band.colors)
        out.touched -= band.first;
    if (out.extents != nullptr && !band.colors)
        out.extents = &band.extents;
#endif
}

bool draw_bands(Display& display, Surface& surface, void (*draw)(void*), void* data) {
    const bool drawn = draw_each(display, surface, draw, data);
    if (thread().draw == &surface && in_primitive())
        return drawn; // the open primitive keeps drawing into this band until glEnd
    surface.band.first = surface.band.rows = 0;
    if (thread().draw == &surface)
        give_rows(surface);
    return drawn;
}

} // namespace egl

#else

EGLint egl::choose_band(const hal::DisplayInfo& info, EGLint, Band&) {
    return info.band_height == 0 ? EGL_SUCCESS : EGL_BAD_MATCH;
}
void egl::show_band(Surface&, raster::Surface&) {}
void egl::make_batches(std::int32_t, Band&) {}

#endif

#if SPANGLE_FEATURE_BANDS

namespace egl {

namespace {

/// Keeps the window alive while its frame is drawn, even if the program destroys it meanwhile.
class FrameGuard {
  public:
    FrameGuard(Display& display, Surface& surface) : display_(display), surface_(surface) {
        const Registry registry;
        ++surface_.frames;
    }
    ~FrameGuard() {
        const Registry registry;
        --surface_.frames;
        if (display_.free_unused_objects != nullptr)
            display_.free_unused_objects(display_);
    }
    FrameGuard(const FrameGuard&) = delete;
    FrameGuard& operator=(const FrameGuard&) = delete;

  private:
    Display& display_;
    Surface& surface_;
};

bool draw_frame(Display& display, Surface& surface, void (*draw)(void*), void* data) {
    if (surface.frames != 0)
        return fail(EGL_BAD_ACCESS, SPANGLE_TEXT("not inside of spangle::frame")) != EGL_FALSE;
    const FrameGuard hold(display, surface);
    return (surface.band.record == nullptr ? draw_bands(display, surface, draw, data)
                                           : draw_recorded(display, surface, draw, data)) &&
           end_call() != EGL_FALSE;
}

} // namespace

} // namespace egl

#endif

bool frame(EGLDisplay handle, void (*draw)(void*), void* data) {
    egl::begin_call(SPANGLE_TEXT("spangle::frame"));
    egl::Display* display = nullptr;
    {
        const egl::Registry registry;
        display = egl::find_display(handle);
    }
    if (display == nullptr)
        return false;
    egl::Surface* const surface = egl::thread().draw;
    if (surface == nullptr || !surface->window || egl::thread().display != display)
        return egl::fail(EGL_BAD_SURFACE, SPANGLE_TEXT("a window of this display must be current")) !=
               EGL_FALSE;
    if (egl::in_primitive())
        return egl::fail_in_primitive() != EGL_FALSE;
#if SPANGLE_FEATURE_BANDS
    if (surface->in_bands())
        return egl::draw_frame(*display, *surface, draw, data);
#endif
    draw(data);
    return eglSwapBuffers(handle, surface) != EGL_FALSE;
}

} // namespace spangle

#include "tests/system/streams/egl_stream.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/frame.hpp>
#include <spangle/native.hpp>

#include "tests/gl/api/command_table.hpp"
#include "tests/system/streams/stream_client.hpp"
#include "tests/system/streams/stream_panel.hpp"
#include "tests/system/streams/stream_scenes.hpp"

namespace spangle::test {
namespace {

constexpr unsigned panel_count = 4; ///< with displays without a panel, one more than EGL's entries
StreamPanel panels[panel_count];

constexpr std::int32_t sides[] = {1,    2,    3,    7,    8,    16,   17,   31,  33,  48,
                                  64,   65,   100,  128,  240,  255,  256,  320, 511, 1023,
                                  1024, 1627, 1628, 1629, 2047, 2048, 2049, 4096};
constexpr PixelFormat formats[] = {PixelFormat::rgb565_be, PixelFormat::rgba8888, PixelFormat::rgb565_le,
                                   PixelFormat::rgb888,    PixelFormat::rgb666,   PixelFormat::rgb444,
                                   PixelFormat::rgb332,    PixelFormat::grey4,    PixelFormat::mono,
                                   PixelFormat::index8};

struct Size {
    std::int32_t width, height;
};

/// Surfaces with large sides are mostly narrow, because drawing on all of the largest takes a second.
Size size_of(Bytes& in) {
    Size size = {pick(in, sides), pick(in, sides)};
    const bool large = in.byte() % 32 == 0;
    if (!large && size.width * size.height > 1 << 16)
        (in.byte() % 2 != 0 ? size.width : size.height) = 1 + in.byte() % 16;
    return size;
}

/// A handle of EGL, and the display that it belongs to.
struct Made {
    EGLDisplay display = EGL_NO_DISPLAY;
    void* handle = nullptr;
};

class World {
  public:
    World(const std::uint8_t* data, std::size_t bytes) : next_(data), end_(data + bytes) {}

    void play() {
        const std::size_t before = memory_use().used;
        read_step();
        set_up();
        while (read_step() && spent_ < most_pixels)
            step();
        tear_down();
        if (memory_use().used != before) {
            std::fprintf(stderr, "egl stream: %zu bytes are left over\n", memory_use().used - before);
            std::abort();
        }
    }

  private:
    static constexpr std::int64_t most_pixels = 1 << 23; ///< about how many pixels a run may touch
    static constexpr std::size_t most_made = 8;

    // --- Steps

    /// Returns false at the end of the stream.
    bool read_step() {
        if (next_ == end_)
            return false;
        const auto count = std::min<std::size_t>(stream_step, static_cast<std::size_t>(end_ - next_));
        std::uint32_t lot = 0x9E3779B9;
        for (std::size_t i = 0; i < step_.size(); ++i) {
            if (i < count)
                step_[i] = next_[i];
            else
                step_[i] = static_cast<std::uint8_t>(lot >> 24);
            lot = (lot ^ step_[i]) * 0x01000193 + 0x7F4A7C15;
        }
        next_ += count;
        in_ = Bytes(step_.data(), step_.size());
        return true;
    }

    void step() {
        const unsigned what = in_.byte();
        if (what < 100) {
            for (unsigned left = 1 + what % 4; left > 0; --left) {
                const unsigned low = in_.byte();
                calls_.one(low | in_.byte() * 256u);
                spend(2);
            }
        } else if (what < 210) {
            const Size size = drawn_size();
            scenes_.resize(size.width, size.height);
            spend(scenes_.one(what - 100));
        } else {
            egl(what - 210);
        }
    }

    /// Returns the size of the current draw surface, as a program knows the size of its window.
    static Size drawn_size() {
        EGLint width = 64, height = 48;
        const EGLDisplay display = eglGetCurrentDisplay();
        const EGLSurface surface = eglGetCurrentSurface(EGL_DRAW);
        if (surface != EGL_NO_SURFACE) {
            eglQuerySurface(display, surface, EGL_WIDTH, &width);
            eglQuerySurface(display, surface, EGL_HEIGHT, &height);
        }
        return {width, height};
    }
    void spend(int times) {
        const Size size = drawn_size();
        spent_ += std::int64_t{size.width} * size.height * times / 2 + 1000;
    }

    // --- Displays

    void set_up() {
        for (StreamPanel& panel : panels) {
            panel.fail(0);
            change(panel);
        }
        home_format_ =
            in_.byte() % 2 != 0 ? formats[0] : pick(in_, formats); // often the format that most panels have
        home_ = {64, 48};
        if (in_.byte() % 2 != 0)
            home_ = size_of(in_);
        // A quarter of the panels hold bands of rows, which are drawn from a record or by callback.
        const std::int32_t band = in_.byte() % 4 == 0 ? 1 + in_.byte() % 64 : 0;
        panels[0].become(home_format_, home_.width, home_.height, band, in_.byte() % 2 != 0);
        precision_ = EGL_PRECISION_EXACT_SPANGLE + static_cast<EGLint>(pick(in_, 3));
        depth_ = pick(in_, {24, 16, 0, 16});
        samples_ = in_.byte() % 8 == 0 ? 4 : 0;
        const bool window = in_.byte() % 2 != 0;
        open(0);
        if (window)
            make_window();
        if (surfaces_.empty()) // perhaps the wish before was refused
            make_pbuffer(home_);
        if (surfaces_.empty())
            make_pbuffer({64, 48});
        make_context(false);
        setting_up_ = false;
        if (!surfaces_.empty() && !contexts_.empty())
            eglMakeCurrent(surfaces_[0].display, surfaces_[0].handle, surfaces_[0].handle,
                           contexts_[0].handle);
    }
    void change(StreamPanel& panel) {
        const Size size = size_of(in_);
        const std::int32_t band = in_.byte() % 4 == 0 ? 1 + in_.byte() % 64 : 0;
        panel.become(in_.byte() % 2 != 0 ? home_format_ : pick(in_, formats), size.width, size.height, band,
                     in_.byte() % 2 != 0);
    }
    void open(unsigned which) {
        const EGLDisplay display =
            eglGetDisplay(which < panel_count ? native(panels[which]) : EGL_DEFAULT_DISPLAY);
        if (display == EGL_NO_DISPLAY)
            return;
        EGLint version = 0;
        eglInitialize(display, &version, in_.byte() % 2 != 0 ? &version : nullptr);
        if (std::find(displays_.begin(), displays_.end(), display) == displays_.end())
            displays_.push_back(display);
        display_ = display;
    }
    EGLDisplay some_display() {
        const unsigned how = setting_up_ ? 0 : in_.byte();
        if (how < 200 || displays_.empty())
            return display_;
        return how < 250 ? displays_[how % displays_.size()] : number<EGLDisplay>();
    }
    /// Returns a handle that EGL never gave.
    template <class T> T number() { return reinterpret_cast<T>(static_cast<std::uintptr_t>(in_.word())); }

    // --- Configurations, surfaces and contexts

    /// Returns a config, mostly that of the stream, which all surfaces and contexts can share.
    EGLConfig config(EGLDisplay display) {
        const unsigned how = setting_up_ ? 0 : in_.byte();
        EGLConfig found = nullptr;
        EGLint count = 0;
        if (how >= 250)
            return number<EGLConfig>();
        if (how >= 215) {
            EGLConfig all[1200];
            eglGetConfigs(display, all, 1200, &count);
            return count > 0 ? all[(how * 256u + in_.byte()) % static_cast<unsigned>(count)] : nullptr;
        }
        const bool indexed = home_format_ == PixelFormat::index8;
        EGLint wish[] = {EGL_RENDERABLE_TYPE,
                         EGL_OPENGL_BIT,
                         EGL_SURFACE_TYPE,
                         EGL_WINDOW_BIT,
                         EGL_DEPTH_SIZE,
                         depth_,
                         EGL_SAMPLES,
                         indexed ? 0 : samples_,
                         EGL_PRECISION_SPANGLE,
                         precision_,
                         EGL_COLOR_BUFFER_TYPE,
                         indexed ? EGL_INDEX_BUFFER_SPANGLE : EGL_RGB_BUFFER,
                         EGL_NONE};
        eglChooseConfig(display, wish, &found, 1, &count);
        if (count == 0) { // no window has this format, so take a pbuffer
            wish[3] = EGL_PBUFFER_BIT;
            eglChooseConfig(display, wish, &found, 1, &count);
        }
        return found;
    }
    template <class T> static void remember(std::vector<Made>& list, EGLDisplay display, T handle) {
        if (handle == nullptr)
            return;
        if (list.size() == most_made)
            list.erase(list.begin());
        list.push_back({display, handle});
    }
    /// Returns an object that was made and perhaps destroyed, or none, or a garbage handle.
    Made some(const std::vector<Made>& list) {
        const unsigned how = in_.byte();
        if (list.empty() || how >= 252)
            return {display_, how % 2 != 0 ? nullptr : number<void*>()};
        return how < 160 ? list.back() : list[how % list.size()];
    }

    /// Makes a window with random attributes. A record of bands has 1 MB, or so few bytes that little fits.
    void make_window() {
        EGLint list[9];
        int n = 0;
        const auto add = [&](EGLint name, EGLint value) {
            list[n++] = name;
            list[n++] = value;
        };
        if (in_.byte() % 4 == 0)
            add(EGL_RENDER_BUFFER, in_.byte() % 2 != 0 ? EGL_SINGLE_BUFFER : EGL_BACK_BUFFER);
        if (in_.byte() % 4 == 0)
            add(EGL_ACCUM_SIZE_SPANGLE, in_.byte() % 18);
        if (in_.byte() % 3 == 0)
            add(EGL_BAND_HEIGHT_SPANGLE, in_.byte() % 70);
        const bool in_bands = panels[0].info().band_height != 0;
        if (in_.byte() % (in_bands ? 2 : 16) == 0)
            add(EGL_BAND_RECORD_SPANGLE, in_.byte() % 2 != 0 ? 1 << 20 : in_.byte() * 16);
        list[n] = EGL_NONE;
        const EGLDisplay display = some_display();
        remember(surfaces_, display,
                 eglCreateWindowSurface(display, config(display), in_.byte() >= 250 ? in_.word() : 0, list));
    }
    void make_pbuffer(Size size) {
        const unsigned how = in_.byte();
        const EGLint list[] = {EGL_WIDTH,
                               how == 255 ? static_cast<EGLint>(in_.word()) : size.width,
                               EGL_HEIGHT,
                               size.height,
                               EGL_LARGEST_PBUFFER,
                               how % 16 == 0,
                               how % 4 == 0 ? EGL_ACCUM_SIZE_SPANGLE : EGL_NONE,
                               16,
                               EGL_NONE};
        const EGLDisplay display = some_display();
        remember(surfaces_, display, eglCreatePbufferSurface(display, config(display), list));
    }
    void make_context(bool shared) {
        const EGLDisplay display = some_display();
        const EGLConfig c = config(display);
        remember(contexts_, display,
                 eglCreateContext(display, c, shared ? some(contexts_).handle : EGL_NO_CONTEXT, nullptr));
    }
    void make_current() {
        const unsigned how = in_.byte();
        if (how % 32 == 0) {
            eglMakeCurrent(some_display(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            return;
        }
        const Made draw = some(surfaces_), read = how % 4 == 0 ? some(surfaces_) : draw;
        eglMakeCurrent(draw.display, draw.handle, read.handle, some(contexts_).handle);
    }

    // --- Calls of EGL

    void egl(unsigned what) {
        switch (what) {
        case 0:
        case 1:
        case 2:
            return make_pbuffer(in_.byte() % 2 != 0 ? home_ : size_of(in_));
        case 3:
        case 4:
        case 5:
            return make_window();
        case 6:
        case 7:
            return make_context(in_.byte() % 4 != 0);
        case 8:
        case 9:
        case 10:
        case 11:
        case 12:
        case 13:
        case 14:
        case 15:
        case 16:
            return make_current();
        case 17: {
            const Made made = some(surfaces_);
            eglDestroySurface(made.display, made.handle);
            return;
        }
        case 18: {
            const Made made = some(contexts_);
            eglDestroyContext(made.display, made.handle);
            return;
        }
        case 19:
        case 20:
        case 21:
        case 22:
        case 23: {
            const EGLSurface current = eglGetCurrentSurface(EGL_DRAW);
            const Made made = in_.byte() % 8 != 0 && current != EGL_NO_SURFACE
                                  ? Made{eglGetCurrentDisplay(), current}
                                  : some(surfaces_);
            spend(2);
            eglSwapBuffers(made.display, made.handle);
            return;
        }
        case 24:
        case 25:
        case 26:
            return draw_frame();
        case 27:
            in_.byte() % 2 != 0 ? eglWaitClient() : eglWaitGL();
            return;
        case 28: {
            const Made made = some(surfaces_);
            EGLint value = 0;
            eglQuerySurface(made.display, made.handle,
                            pick(in_, {EGL_BAND_RECORD_PEAK_SPANGLE, EGL_BAND_HEIGHT_SPANGLE,
                                       EGL_BUFFER_AGE_EXT, EGL_CONFIG_ID, EGL_RENDER_BUFFER,
                                       EGL_SWAP_BEHAVIOR, static_cast<EGLint>(in_.word() % 0x4000)}),
                            in_.byte() % 16 != 0 ? &value : nullptr);
            return;
        }
        case 29: {
            const Made made = some(contexts_);
            EGLint value = 0;
            eglQueryContext(
                made.display, made.handle,
                pick(in_, {EGL_CONFIG_ID, EGL_RENDER_BUFFER, static_cast<EGLint>(in_.word() % 0x4000)}),
                in_.byte() % 16 != 0 ? &value : nullptr);
            return;
        }
        case 30: {
            const EGLDisplay display = some_display();
            eglTerminate(display);
            if (in_.byte() % 4 != 0)
                eglInitialize(display, nullptr, nullptr);
            return;
        }
        case 31:
        case 32:
            return open(pick(in_, panel_count + 1));
        case 33:
            eglSwapInterval(some_display(),
                            in_.byte() % 8 != 0 ? in_.byte() % 3 : static_cast<EGLint>(in_.word()));
            return;
        case 34:
        case 35:
            return set_palette();
        case 36: {
            const Made made = some(surfaces_);
            switch (pick(in_, 4)) {
            case 0:
                eglSurfaceAttrib(made.display, made.handle,
                                 pick(in_, {EGL_SWAP_BEHAVIOR, EGL_MIPMAP_LEVEL, EGL_MULTISAMPLE_RESOLVE}),
                                 static_cast<EGLint>(in_.word()));
                return;
            case 1:
                eglCopyBuffers(made.display, made.handle, in_.byte() % 4);
                return;
            case 2:
                eglBindTexImage(made.display, made.handle, EGL_BACK_BUFFER);
                return;
            default:
                eglReleaseTexImage(made.display, made.handle, EGL_BACK_BUFFER);
                return;
            }
        }
        case 37:
            eglReleaseThread();
            return;
        case 38:
            return ask_configs();
        case 39:
        case 40:
            return panels[pick(in_, panel_count)].fail(in_.byte() % 2 != 0 ? 0 : in_.byte());
        case 41: { // another display takes the place of this one
            StreamPanel& panel = panels[pick(in_, panel_count)];
            return change(panel);
        }
        case 42:
            eglGetProcAddress(pick(in_, {"glBegin", "eglSwapBuffers", "glNoSuchCommand", ""}));
            eglQueryString(some_display(), static_cast<EGLint>(EGL_VENDOR + pick(in_, 4)));
            return;
        case 43: {
            const Made made = some(surfaces_);
            eglCreatePixmapSurface(made.display, config(made.display), in_.byte(), nullptr);
            eglCreatePbufferFromClientBuffer(made.display, EGL_OPENVG_API, nullptr, nullptr, nullptr);
            return;
        }
        case 44:
            eglGetPlatformDisplay(pick(in_, {EGL_PLATFORM_SURFACELESS_MESA, EGL_PLATFORM_X11_KHR, 0}),
                                  nullptr, nullptr);
            eglCreatePlatformWindowSurface(display_, config(display_), nullptr, nullptr);
            eglBindAPI(pick(in_, {EGL_OPENGL_API, EGL_OPENVG_API}));
            eglWaitNative(pick(in_, {EGL_CORE_NATIVE_ENGINE, 0}));
            return;
        default:
            glFlush();
        }
    }

    /// Draws a frame of a window whose display holds bands of rows, so that the frame is drawn for each band.
    void draw_frame() {
        if (in_frame_)
            return;
        const unsigned steps = 1 + pick(in_, 5);
        const EGLDisplay display = in_.byte() % 8 != 0 ? eglGetCurrentDisplay() : some_display();
        const std::uint8_t *const begin = next_, *after = next_;
        in_frame_ = true;
        frame(display, [&] {
            next_ = begin;
            for (unsigned i = 0; i < steps && spent_ < most_pixels && read_step(); ++i)
                step();
            after = next_;
        });
        in_frame_ = false;
        next_ = after;
    }

    void set_palette() {
        const Made made = some(surfaces_);
        const std::size_t kept = memory_.blocks();
        const EGLint first = in_.byte(), count = in_.byte() % 4 != 0 ? 256 - first : in_.byte();
        // For a wrong range nothing is read.
        const std::uint8_t* const colors =
            memory_.make(first + count > 256 ? 0 : static_cast<std::size_t>(3 * count));
        eglSetPaletteSPANGLE(made.display, made.handle, first, count,
                             in_.byte() % 16 != 0 ? colors : nullptr);
        memory_.drop_to(kept);
    }

    void ask_configs() {
        const EGLDisplay display = some_display();
        EGLint wish[9];
        for (int i = 0; i < 8; ++i)
            wish[i] = i % 2 == 0 ? static_cast<EGLint>(EGL_BUFFER_SIZE + pick(in_, 40))
                                 : static_cast<EGLint>(pick(in_, 40)) - 2;
        wish[8] = EGL_NONE;
        EGLConfig found[3];
        EGLint count = 0;
        eglChooseConfig(display, wish, found, static_cast<EGLint>(pick(in_, 5)) - 1 < 3 ? 3 : 0, &count);
        eglGetConfigAttrib(display, config(display), static_cast<EGLint>(EGL_BUFFER_SIZE + pick(in_, 40)),
                           &count);
        eglGetConfigs(display, found, 3, &count);
    }

    /// An open primitive holds its surfaces, so it ends first.
    void tear_down() {
        if (eglReleaseThread() == EGL_FALSE) {
            glEnd();
            expect(eglReleaseThread() != EGL_FALSE, "the thread keeps its context");
        }
        expect(eglGetCurrentContext() == EGL_NO_CONTEXT, "a context stays current");
        for (const EGLDisplay display : displays_)
            eglTerminate(display); // a display that gave its entry to another is no longer valid
        eglGetError();
    }
    static void expect(bool holds, const char* what) {
        if (holds)
            return;
        std::fprintf(stderr, "egl stream: %s\n", what);
        std::abort();
    }

    const std::uint8_t *next_, *end_;
    std::array<std::uint8_t, 1024> step_{};
    Bytes in_{step_.data(), step_.size()};
    Memory memory_;
    Calls calls_{in_};
    Scenes scenes_{in_, memory_};
    std::int64_t spent_ = 0;
    bool in_frame_ = false, setting_up_ = true;

    std::vector<EGLDisplay> displays_;
    EGLDisplay display_ = EGL_NO_DISPLAY; ///< the display that was opened last
    std::vector<Made> surfaces_, contexts_;
    Size home_{};
    PixelFormat home_format_{};
    EGLint precision_ = 0, depth_ = 0, samples_ = 0;
};

} // namespace

void run_egl_stream(const std::uint8_t* data, std::size_t bytes) {
    World(data, bytes).play();
}

} // namespace spangle::test

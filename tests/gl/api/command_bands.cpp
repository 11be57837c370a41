#include "tests/gl/api/command_bands.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/frame.hpp>
#include <spangle/native.hpp>

#include "gl/context/context.hpp"
#include "tests/gl/api/command_calls.hpp"

namespace spangle::test {

#if SPANGLE_HAS_RECORDS

namespace {

constexpr std::int32_t width = 64, height = 48;

/// A display of plain memory, whose buffers have exactly the size that they need.
class PlainDisplay final : public hal::Display {
  public:
    void reset(PixelFormat format, std::int32_t band) {
        format_ = format;
        band_ = band;
        glass.assign(bytes_of(height), 0);
        rows_.assign(static_cast<std::size_t>(height), RowSpan{});
        open(0, band == 0 ? height : 0);
    }
    static std::int32_t unit_of(PixelFormat format) { return format_info(format).rows; }

    hal::DisplayInfo info() const override {
        return {"plain", width, height, format_, true, hal::WireFormat::none, band_, unit_of(format_)};
    }
    hal::Result<void> init() override { return {}; }
    hal::Result<hal::Frame> acquire() override { return frame(0); }
    hal::Result<void> present() override {
        glass = buffer_;
        return {};
    }
    hal::Result<hal::Frame> acquire_band(std::int32_t first, std::int32_t rows) override {
        open(first, rows);
        return frame(1);
    }
    hal::Result<void> present_band() override {
        std::memcpy(glass.data() + bytes_of(first_), buffer_.data(), buffer_.size());
        return {};
    }

    std::vector<std::uint8_t> glass;

  private:
    std::size_t bytes_of(std::int32_t rows) const {
        return static_cast<std::size_t>(row_bytes(format_, width) * stored_rows(format_, rows));
    }
    void open(std::int32_t first, std::int32_t rows) {
        first_ = first;
        buffer_.assign(bytes_of(rows), 0);
        buffer_.shrink_to_fit();
        extents_ = {rows_.data(), rows, true, 0};
    }
    hal::Frame frame(std::int32_t age) { return {buffer_.data(), row_bytes(format_, width), age, &extents_}; }

    PixelFormat format_{};
    std::int32_t band_ = 0, first_ = 0;
    std::vector<std::uint8_t> buffer_;
    std::vector<RowSpan> rows_;
    RowExtents extents_;
};

enum class Way : std::uint8_t { whole, redrawn, recorded };

struct Setting {
    Way way = Way::whole;
    PixelFormat format{};
    bool deep = false, samples = false;
    EGLint precision = EGL_PRECISION_EXACT_SPANGLE;
    std::int32_t band = 0;
    EGLint record = 0;
};

struct Outcome {
    bool shown = false;   ///< whether the frame is on the glass
    bool starved = false; ///< whether a command found no memory
    std::vector<std::uint8_t> glass;
    std::uint64_t answers = 0; ///< hash of the answers about pixels
};

/// Whether a command reads only the rows of its own band, as it must in bands that are drawn by callback.
bool stays_in_its_rows(std::string_view family) {
    return !family.starts_with("Copy");
}

bool answers_with_pixels(std::string_view family) {
    return family == "ReadPixels" || family == "GetTexImage" || family.starts_with("GetQueryObject");
}

class Frames {
  public:
    Frames(PlainDisplay& display, const Setting& setting, const std::uint8_t* data, std::size_t bytes,
           bool banded_twin_reads)
        : display_(display), setting_(setting), data_(data), bytes_(bytes), reads_(banded_twin_reads) {}

    Outcome play() {
        const std::size_t before = memory_use().used;
        display_.reset(setting_.format, setting_.band);
        open();
        if (setting_.way == Way::redrawn) {
            out_.shown = spangle::frame(egl_, [this] {
                make_context(); // a new context, whose state `draw` must set
                draw();
            });
        } else {
            make_context();
            draw();
            out_.shown = eglSwapBuffers(egl_, window_) != EGL_FALSE;
        }
        eglMakeCurrent(egl_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglTerminate(egl_);
        expect(memory_use().used == before, "memory is left over");
        out_.glass = display_.glass;
        return out_;
    }

    static void expect(bool holds, const char* what) {
        if (holds)
            return;
        std::fprintf(stderr, "bands: %s\n", what);
        std::abort();
    }

  private:
    void open() {
        egl_ = eglGetDisplay(native(display_));
        expect(eglInitialize(egl_, nullptr, nullptr) != EGL_FALSE, "no display");
        const EGLint wish[] = {
            EGL_RENDERABLE_TYPE,   EGL_OPENGL_BIT,          EGL_SURFACE_TYPE, EGL_WINDOW_BIT,
            EGL_DEPTH_SIZE,        setting_.deep ? 24 : 16, EGL_SAMPLES,      setting_.samples ? 4 : 0,
            EGL_PRECISION_SPANGLE, setting_.precision,      EGL_NONE};
        EGLint count = 0;
        eglChooseConfig(egl_, wish, &config_, 1, &count);
        expect(count == 1, "no config");
        const EGLint window[] = {EGL_BAND_RECORD_SPANGLE, setting_.record,
                                 SPANGLE_FEATURE_ACCUM ? EGL_ACCUM_SIZE_SPANGLE : EGL_NONE, 16, EGL_NONE};
        window_ = eglCreateWindowSurface(egl_, config_, 0, window);
        expect(window_ != EGL_NO_SURFACE, "no window");
        if (setting_.way == Way::redrawn)
            make_context(); // a context must be current to begin with
    }

    void make_context() {
        const EGLContext old = eglGetCurrentContext();
        const EGLContext context = eglCreateContext(egl_, config_, EGL_NO_CONTEXT, nullptr);
        expect(eglMakeCurrent(egl_, window_, window_, context) != EGL_FALSE, "no context");
        if (old != EGL_NO_CONTEXT)
            eglDestroyContext(egl_, old);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT);
    }

    void draw() {
        Bytes in(data_, bytes_);
        Calls calls(in);
        note_errors(); // errors of clearing
        while (in.more()) {
            const unsigned low = in.byte();
            std::memset(result(), 0, looked_at);
            const Command& c =
                calls.one(low | static_cast<unsigned>(in.byte()) << 8, reads_ ? nullptr : stays_in_its_rows);
            if (answers_with_pixels(c.family))
                for (std::size_t i = 0; i < looked_at; ++i)
                    out_.answers = (out_.answers ^ result()[i]) * 0x100000001B3;
            note_errors();
        }
        if (gl::current_context()->inside_begin_end())
            glEnd();
        note_errors();
    }

    /// Reads a pending error, which would hide the next one.
    void note_errors() {
        GLenum& code = gl::current_context()->error_code;
        out_.starved = out_.starved || code == GL_OUT_OF_MEMORY;
        code = GL_NO_ERROR;
    }

    static constexpr std::size_t looked_at = 2048;

    PlainDisplay& display_;
    Setting setting_;
    const std::uint8_t* data_;
    std::size_t bytes_;
    bool reads_;
    EGLDisplay egl_ = EGL_NO_DISPLAY;
    EGLConfig config_ = nullptr;
    EGLSurface window_ = EGL_NO_SURFACE;
    Outcome out_;
};

/// Returns the first wished format that the build has; every build has one of them.
PixelFormat format_of(std::uint8_t how) {
    constexpr PixelFormat wished[] = {PixelFormat::rgb565_be, PixelFormat::rgba8888, PixelFormat::rgb565_le,
                                      PixelFormat::grey4,     PixelFormat::mono,     PixelFormat::rgb444};
    const PixelFormat format = wished[how % std::size(wished)];
    return is_drawable(format) ? format : wished[0];
}

} // namespace

void run_in_bands(const std::uint8_t* data, std::size_t bytes) {
    static PlainDisplay display; // one display, because EGL has few entries
    Bytes in(data, bytes);
    const std::uint8_t first = in.byte();
    Setting whole;
    whole.precision = EGL_PRECISION_EXACT_SPANGLE + first % 3;
    whole.deep = in.byte() % 2 != 0;
    whole.format = format_of(in.byte());
    whole.samples = SPANGLE_FEATURE_MULTISAMPLE && in.byte() % 4 == 0;
    Setting banded = whole;
    banded.way = (first & 0x20) != 0 ? Way::recorded : Way::redrawn;
    const std::int32_t unit = PlainDisplay::unit_of(whole.format), rows = 1 + in.byte() % height;
    banded.band = (rows + unit - 1) / unit * unit;
    const std::uint8_t size = in.byte();
    const bool records = banded.way == Way::recorded;
    banded.record = !records ? 0 : size % 4 == 0 ? 64 * (1 + size) : 4 << 20;

    constexpr std::size_t header = 6;
    const std::uint8_t* const commands = bytes > header ? data + header : data + bytes;
    const std::size_t left = bytes > header ? bytes - header : 0;
    const Outcome wanted = Frames(display, whole, commands, left, records).play();
    const Outcome got = Frames(display, banded, commands, left, records).play();
    Frames::expect(wanted.shown, "the whole frame was not shown");
    if (!got.shown) {
        Frames::expect(got.starved && records, "the frame was not shown, and nobody said why");
        const std::vector<std::uint8_t> black(got.glass.size());
        return Frames::expect(got.glass == black, "a frame that was not shown is on the glass");
    }
    if (wanted.starved || got.starved)
        return; // without memory the pictures may differ
    Frames::expect(got.glass == wanted.glass, "the pictures differ");
    Frames::expect(!records || got.answers == wanted.answers, "the answers differ");
}

#else

void run_in_bands(const std::uint8_t*, std::size_t) {}

#endif

} // namespace spangle::test

// Tests displays with windows and pixmaps of their own, and contexts as programs for PCs ask for them
// (EGL_EXT_platform_base, EGL_KHR_create_context).
#include <gtest/gtest.h>
#include <spangle/GL/gl.h>
#include <spangle/hal/window_system.hpp>

#include <cstring>
#include <map>
#include <vector>

#include "gl/context/gl_version.hpp"
#include "gl/egl/objects.hpp"
#include "gl/egl/platforms.hpp"

namespace spangle::test {
namespace {

constexpr EGLBoolean yes = EGL_TRUE, no = EGL_FALSE;
constexpr EGLenum fake_platform = 0x7777;

/// A window that its user resizes.
class Window final : public hal::Display {
  public:
    std::int32_t width = 8, height = 6;
    bool pixmap = false, fail_acquire = false;
    int presents = 0, opened = 0, closed = 0;
    std::vector<std::uint8_t> shown; ///< rows of four bytes a pixel, from the top
    std::int32_t shown_width = 0;

    hal::DisplayInfo info() const override {
        hal::DisplayInfo out = {"window", width, height, PixelFormat::rgba8888, true};
        return out;
    }
    hal::Result<void> init() override { return {}; }
    hal::Result<hal::Frame> acquire() override {
        if (fail_acquire)
            return hal::Error{hal::Fault::gone, "no buffer"};
        buffer_width_ = width;
        buffer_.assign(static_cast<std::size_t>(width * height * 4), 0);
        return hal::Frame{buffer_.data(), width * 4, 0, nullptr};
    }
    hal::Result<void> present() override {
        ++presents;
        shown = buffer_;
        shown_width = buffer_width_;
        return {};
    }
    unsigned at(std::int32_t x, std::int32_t y) const { // red, green and blue; y counts from the top
        const auto i = static_cast<std::size_t>((y * shown_width + x) * 4);
        return i + 2 < shown.size() ? unsigned{shown[i]} << 16 | unsigned{shown[i + 1]} << 8 | shown[i + 2]
                                    : 0xBADu;
    }

  private:
    std::int32_t buffer_width_ = 0;
    std::vector<std::uint8_t> buffer_;
};

class Windows final : public hal::WindowSystem {
  public:
    std::map<std::uintptr_t, Window> all;
    hal::Result<void> init() override { return {}; }
    bool shows(PixelFormat format) const override { return format == PixelFormat::rgba8888; }
    std::int32_t visual_id(PixelFormat) const override { return 0x21; }
    std::int32_t visual_type() const override { return 4; }
    hal::Result<hal::Display*> open(std::uintptr_t handle, bool pixmap, PixelFormat) override {
        const auto found = all.find(handle);
        if (found == all.end() || found->second.pixmap != pixmap)
            return hal::Error{hal::Fault::gone, "no such window"};
        ++found->second.opened;
        return &found->second;
    }
    void close(hal::Display& window) override { ++static_cast<Window&>(window).closed; }
};

Windows* windows = nullptr;
int swapped = 0, created = 0;
std::int32_t swapped_width = 0;

struct Platform : testing::Test {
    Windows system;
    unsigned long window = 11, other = 12, pixmap = 31; // ids as of X
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLConfig config = nullptr;

    void SetUp() override {
        windows = &system;
        swapped = created = 0;
        system.all[window];
        system.all[other];
        system.all[pixmap].pixmap = true;
        egl::Platforms platforms;
        platforms.extensions = " EGL_TEST_platform_fake";
        platforms.find = [](EGLenum platform, void*) {
            egl::NativeDisplay found;
            found.known = platform == fake_platform;
            found.windows = found.known ? windows : nullptr;
            return found;
        };
        platforms.precision = EGL_PRECISION_BALANCED_SPANGLE;
        platforms.swapped = [](const hal::Frame&, const hal::DisplayInfo& info) {
            ++swapped;
            swapped_width = info.width;
        };
        platforms.created = [](gl::Context&) { ++created; };
        egl::use_platforms(platforms);
        display = eglGetPlatformDisplayEXT(fake_platform, nullptr, nullptr);
        ASSERT_NE(display, EGL_NO_DISPLAY);
        ASSERT_EQ(eglInitialize(display, nullptr, nullptr), yes);
        const EGLint wish[] = {EGL_RENDERABLE_TYPE,
                               EGL_OPENGL_BIT,
                               EGL_SURFACE_TYPE,
                               EGL_WINDOW_BIT | EGL_PIXMAP_BIT | EGL_PBUFFER_BIT,
                               EGL_ALPHA_SIZE,
                               8,
                               EGL_NONE};
        EGLint count = 0;
        ASSERT_TRUE(eglChooseConfig(display, wish, &config, 1, &count) && count == 1);
    }
    void TearDown() override {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglTerminate(display);
        egl::use_platforms({});
        EXPECT_TRUE(egl::arena().consistent());
        for (const auto& [handle, w] : system.all)
            EXPECT_EQ(w.opened, w.closed) << handle;
    }
    EGLSurface shown(unsigned long handle) {
        return eglCreatePlatformWindowSurfaceEXT(display, config, &handle, nullptr);
    }
    void current(EGLSurface surface) {
        ASSERT_EQ(eglMakeCurrent(display, surface, surface,
                                 eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr)),
                  yes);
    }
    EGLint size(EGLSurface surface, EGLint name) const {
        EGLint value = -1;
        eglQuerySurface(display, surface, name, &value);
        return value;
    }
    EGLint context_error(std::vector<EGLint> attributes) {
        attributes.push_back(EGL_NONE);
        const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
        const EGLint error = eglGetError();
        EXPECT_EQ(context == EGL_NO_CONTEXT, error != EGL_SUCCESS);
        if (context != EGL_NO_CONTEXT)
            eglDestroyContext(display, context);
        return error;
    }
};

void clear(float red) {
    glClearColor(red, 0.0f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
}

TEST_F(Platform, DisplaysByPlatform) {
    EXPECT_EQ(eglGetPlatformDisplayEXT(fake_platform, nullptr, nullptr), display) << "one display, one entry";
    EXPECT_EQ(eglGetPlatformDisplay(fake_platform, nullptr, nullptr), display);
    const EGLDisplay surfaceless =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    EXPECT_NE(surfaceless, EGL_NO_DISPLAY);
    EXPECT_NE(surfaceless, display);
    int native = 0;
    eglGetError();
    EXPECT_EQ(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, &native, nullptr), EGL_NO_DISPLAY);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    EXPECT_EQ(eglGetPlatformDisplay(0x7778, nullptr, nullptr), EGL_NO_DISPLAY);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    const EGLAttrib wide[] = {1, 2, EGL_NONE};
    EXPECT_EQ(eglGetPlatformDisplay(fake_platform, nullptr, wide), EGL_NO_DISPLAY);
    EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
    const EGLAttrib none[] = {EGL_NONE};
    EXPECT_EQ(eglGetPlatformDisplay(fake_platform, nullptr, none), display);
    EXPECT_EQ(eglGetDisplay(EGL_DEFAULT_DISPLAY), EGL_NO_DISPLAY) << "this host has none by default";
    EXPECT_EQ(eglGetError(), EGL_SUCCESS) << "for which there is no error (EGL 1.4, 3.2)";
    const char* const extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    ASSERT_NE(extensions, nullptr);
    EXPECT_NE(std::strstr(extensions, "EGL_EXT_platform_base EGL_MESA_platform_surfaceless"), nullptr);
    EXPECT_NE(std::strstr(extensions, " EGL_TEST_platform_fake"), nullptr);
}

TEST_F(Platform, AttributesOfContexts) {
    constexpr EGLint major = EGL_CONTEXT_MAJOR_VERSION_KHR, minor = EGL_CONTEXT_MINOR_VERSION_KHR,
                     flags = EGL_CONTEXT_FLAGS_KHR, mask = EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                     reset = EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_KHR;
    const struct {
        std::vector<EGLint> attributes;
        EGLint error;
    } all[] = {{{}, EGL_SUCCESS},
               {{major, 1}, EGL_SUCCESS},
               {{major, 1, minor, gl::gl_minor}, EGL_SUCCESS},
               {{minor, gl::gl_minor, major, 1}, EGL_SUCCESS},
               {{major, 1, minor, gl::gl_minor + 1}, EGL_BAD_MATCH},
               {{major, 1, minor, -1}, EGL_BAD_MATCH},
               {{major, 2}, EGL_BAD_MATCH},
               {{major, 0}, EGL_BAD_MATCH},
               {{major, 3, minor, 2, mask, 1}, EGL_BAD_MATCH},
               {{mask, 2}, EGL_SUCCESS}, // the mask means nothing below OpenGL 3.2
               {{flags, 0}, EGL_SUCCESS},
               {{flags, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR}, EGL_SUCCESS},
               {{flags, EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE_BIT_KHR}, EGL_BAD_MATCH},
               {{flags, EGL_CONTEXT_OPENGL_ROBUST_ACCESS_BIT_KHR}, EGL_BAD_MATCH},
               {{flags, 8}, EGL_BAD_ATTRIBUTE},
               {{flags, EGL_CONTEXT_OPENGL_ROBUST_ACCESS_BIT_KHR, flags, 0}, EGL_BAD_MATCH},
               {{reset, EGL_NO_RESET_NOTIFICATION_KHR}, EGL_SUCCESS},
               {{reset, EGL_LOSE_CONTEXT_ON_RESET_KHR}, EGL_BAD_MATCH},
               {{reset, 1}, EGL_BAD_ATTRIBUTE},
               {{EGL_WIDTH, 1}, EGL_BAD_ATTRIBUTE}};
    for (const auto& [attributes, error] : all)
        EXPECT_EQ(context_error(attributes), error) << testing::PrintToString(attributes);
    EXPECT_EQ(created, 8) << "each new context is told of";
}

TEST_F(Platform, WindowsAreOpenedOnce) {
    EXPECT_EQ(eglCreatePlatformWindowSurfaceEXT(display, config, nullptr, nullptr), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    EXPECT_EQ(eglCreatePlatformPixmapSurfaceEXT(display, config, nullptr, nullptr), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_PIXMAP);
    EXPECT_EQ(shown(99), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    EXPECT_EQ(shown(pixmap), EGL_NO_SURFACE) << "a pixmap is no window";
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    const EGLSurface first = shown(window), second = shown(other);
    ASSERT_NE(first, EGL_NO_SURFACE);
    ASSERT_NE(second, EGL_NO_SURFACE) << "each window has a surface";
    EXPECT_EQ(shown(window), EGL_NO_SURFACE) << "but one";
    EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
    current(first);
    EXPECT_EQ(eglDestroySurface(display, first), yes);
    EXPECT_EQ(system.all[window].closed, 0) << "it is current";
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    EXPECT_EQ(system.all[window].closed, 1);
    EXPECT_NE(shown(window), EGL_NO_SURFACE);
}

TEST_F(Platform, WideAttributes) {
    const EGLAttrib one[] = {EGL_RENDER_BUFFER, EGL_SINGLE_BUFFER, EGL_NONE};
    const EGLSurface single = eglCreatePlatformWindowSurface(display, config, &window, one);
    ASSERT_NE(single, EGL_NO_SURFACE);
    EXPECT_EQ(size(single, EGL_RENDER_BUFFER), EGL_SINGLE_BUFFER);
    eglDestroySurface(display, single);
    std::vector<EGLAttrib> many;
    for (int n = 0; n < 33; ++n)
        many.insert(many.end(), {EGL_RENDER_BUFFER, EGL_BACK_BUFFER});
    many.push_back(EGL_NONE);
    EXPECT_EQ(eglCreatePlatformWindowSurface(display, config, &window, many.data()), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
    many.erase(many.begin(), many.begin() + 2);
    const EGLSurface most = eglCreatePlatformWindowSurface(display, config, &window, many.data());
    EXPECT_NE(most, EGL_NO_SURFACE) << "32 are taken";
    eglDestroySurface(display, most);
    if constexpr (sizeof(EGLAttrib) > sizeof(EGLint)) { // the upper half of a wide word counts, too
        constexpr auto beyond = static_cast<EGLAttrib>(std::uint64_t{1} << 32);
        for (const auto& list :
             {std::vector<EGLAttrib>{EGL_RENDER_BUFFER + beyond, EGL_BACK_BUFFER, EGL_NONE},
              std::vector<EGLAttrib>{EGL_RENDER_BUFFER, EGL_BACK_BUFFER + beyond, EGL_NONE}}) {
            EXPECT_EQ(eglCreatePlatformWindowSurface(display, config, &window, list.data()), EGL_NO_SURFACE);
            EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
        }
    }
}

TEST_F(Platform, SurfacesFollowTheirWindows) {
    Window& w = system.all[window];
    const EGLSurface surface = shown(window);
    current(surface);
    clear(1.0f);
    EXPECT_EQ(eglSwapBuffers(display, surface), yes);
    EXPECT_EQ(w.at(7, 5), 0xFF0000u);
    w.width = 12; // the user resizes the window, and the program calls glViewport
    w.height = 3;
    EXPECT_EQ(size(surface, EGL_WIDTH), 8) << "until then all stays";
    glViewport(0, 0, 12, 3);
    EXPECT_EQ(size(surface, EGL_WIDTH), 12);
    EXPECT_EQ(size(surface, EGL_HEIGHT), 3);
    clear(1.0f);
    EXPECT_EQ(eglSwapBuffers(display, surface), yes);
    EXPECT_EQ(w.shown_width, 12);
    EXPECT_EQ(w.at(11, 2), 0xFF0000u) << "the new pixels are drawn to";
    w.width = 5; // without glViewport the next frame has the new size
    clear(0.0f);
    EXPECT_EQ(eglSwapBuffers(display, surface), yes);
    EXPECT_EQ(w.shown_width, 12) << "the frame that was drawn";
    EXPECT_EQ(size(surface, EGL_WIDTH), 5);
}

TEST_F(Platform, WindowsThatCannotBeFollowed) {
    Window& w = system.all[window];
    const EGLSurface surface = shown(window);
    current(surface);
    w.width = 100000;
    EXPECT_EQ(eglSwapBuffers(display, surface), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    EXPECT_EQ(size(surface, EGL_WIDTH), 8) << "it stays as it is";
    clear(1.0f); // draws to no buffer
    w.width = 9;
    eglSwapBuffers(display, surface);
    EXPECT_EQ(size(surface, EGL_WIDTH), 9);
    w.width = 10;
    w.fail_acquire = true;
    EXPECT_EQ(eglSwapBuffers(display, surface), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    clear(1.0f);
    w.fail_acquire = false;
    eglSwapBuffers(display, surface);
    clear(1.0f);
    EXPECT_EQ(eglSwapBuffers(display, surface), yes);
    EXPECT_EQ(w.at(9, 0), 0xFF0000u);
}

TEST_F(Platform, Pixmaps) {
    Window& p = system.all[pixmap];
    const EGLSurface surface = eglCreatePixmapSurface(display, config, pixmap, nullptr);
    ASSERT_NE(surface, EGL_NO_SURFACE);
    current(surface);
    clear(1.0f);
    EXPECT_EQ(p.presents, 0);
    glFlush(); // a pixmap has one buffer (EGL 1.4, 3.5.4)
    EXPECT_EQ(p.at(0, 0), 0xFF0000u);
}

TEST_F(Platform, CopyBuffers) {
    const EGLint area[] = {EGL_WIDTH, 4, EGL_HEIGHT, 9, EGL_NONE};
    const EGLSurface pbuffer = eglCreatePbufferSurface(display, config, area);
    current(pbuffer);
    clear(0.0f);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 7, 4, 2); // the two rows at the top
    clear(1.0f);
    EXPECT_EQ(eglCopyBuffers(display, pbuffer, pixmap), yes);
    const Window& p = system.all[pixmap]; // the pixmap has 8x6 pixels
    EXPECT_EQ(p.at(3, 0), 0xFF0000u);
    EXPECT_EQ(p.at(4, 0), 0u) << "the pbuffer ends there";
    EXPECT_EQ(p.at(0, 1), 0xFF0000u);
    EXPECT_EQ(p.at(0, 2), 0u);
    EXPECT_EQ(p.opened, p.closed);
    EXPECT_EQ(eglCopyBuffers(display, pbuffer, 99), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_PIXMAP);
    EXPECT_EQ(eglCopyBuffers(display, pbuffer, window), no) << "no pixmap";
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_PIXMAP);
    glBegin(GL_POINTS);
    EXPECT_EQ(eglCopyBuffers(display, pbuffer, pixmap), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS);
    glEnd();
    system.all[pixmap].fail_acquire = true;
    EXPECT_EQ(eglCopyBuffers(display, pbuffer, pixmap), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_PIXMAP);
    EXPECT_EQ(p.opened, p.closed);
}

TEST_F(Platform, CopyBuffersOfOtherFormatsAndDisplays) {
    const EGLint wish[] = {
        EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_GREEN_SIZE, 6, EGL_NONE};
    EGLConfig configs[64];
    EGLint count = 0;
    ASSERT_EQ(eglChooseConfig(display, wish, configs, 64, &count), yes);
    bool refused = false;
    for (EGLint i = 0; i < count && !refused; ++i) {
        EGLint green = 0;
        eglGetConfigAttrib(display, configs[i], EGL_GREEN_SIZE, &green);
        if (green != 6)
            continue;
        const EGLint area[] = {EGL_WIDTH, 4, EGL_HEIGHT, 4, EGL_NONE};
        EXPECT_EQ(eglCopyBuffers(display, eglCreatePbufferSurface(display, configs[i], area), pixmap), no);
        EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
        refused = true;
    }
    EXPECT_TRUE(refused) << "no config of 565";
    const EGLDisplay surfaceless =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    ASSERT_EQ(eglInitialize(surfaceless, nullptr, nullptr), yes);
    const EGLSurface pbuffer = eglCreatePbufferSurface(surfaceless, config, nullptr);
    ASSERT_NE(pbuffer, EGL_NO_SURFACE);
    EXPECT_EQ(eglCopyBuffers(surfaceless, pbuffer, pixmap), no);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_PIXMAP);
    eglTerminate(surfaceless);
}

TEST_F(Platform, PbuffersAreShownToWhoAsked) {
    const EGLint area[] = {EGL_WIDTH, 4, EGL_HEIGHT, 9, EGL_NONE};
    const EGLSurface pbuffer = eglCreatePbufferSurface(display, config, area);
    current(pbuffer);
    glFlush();
    EXPECT_EQ(swapped, 1) << "a program for one buffer ends its frames like that";
    EXPECT_EQ(swapped_width, 4);
    EXPECT_EQ(eglSwapBuffers(display, pbuffer), yes);
    EXPECT_EQ(swapped, 2);
    glFlush();
    EXPECT_EQ(swapped, 2) << "it swaps: Flush is no frame";
}

std::int32_t planes_width = 0;
PixelFormat planes_format{};

/// The host draws the program in a format that the program did not choose, and pbuffers have that format.
TEST_F(Platform, PbuffersHaveWhatTheHostDraws) {
    static const egl::DrawnFormat drawn = {PixelFormat::rgb565_be, EGL_PRECISION_FAST_SPANGLE};
    egl::Platforms platforms = egl::platforms();
    platforms.drawn = &drawn;
    platforms.planes = [](const raster::Surface& picture) {
        planes_width = picture.width;
        planes_format = picture.format;
    };
    egl::use_platforms(platforms);
    const EGLint wish[] = {EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_ALPHA_SIZE,
                           8,
                           EGL_SAMPLES,
                           4,
                           EGL_NONE};
    EGLConfig sampled = nullptr;
    EGLint count = 0;
    ASSERT_TRUE(eglChooseConfig(display, wish, &sampled, 1, &count) && count == 1);
    const EGLint area[] = {EGL_WIDTH, 4, EGL_HEIGHT, 9, EGL_NONE};
    const EGLSurface pbuffer = eglCreatePbufferSurface(display, sampled, area);
    const EGLContext context = eglCreateContext(display, sampled, EGL_NO_CONTEXT, nullptr);
    ASSERT_EQ(eglMakeCurrent(display, pbuffer, pbuffer, context), yes);
    GLint red = 0, alpha = 0, samples = 0;
    glGetIntegerv(GL_RED_BITS, &red);
    glGetIntegerv(GL_ALPHA_BITS, &alpha);
    glGetIntegerv(GL_SAMPLES, &samples);
    EXPECT_EQ(red, 5);
    EXPECT_EQ(alpha, 0);
    EXPECT_EQ(samples, 0);
    EXPECT_EQ(gl::current_context()->tier, raster::Tier::fast);
    EGLint given = 0, wanted = 0;
    EXPECT_EQ(eglQueryContext(display, context, EGL_CONFIG_ID, &given), yes);
    eglGetConfigAttrib(display, sampled, EGL_CONFIG_ID, &wanted);
    EXPECT_EQ(given, wanted) << "the program sees its own config";
    EXPECT_EQ(eglSwapBuffers(display, pbuffer), yes);
    EXPECT_EQ(planes_width, 4);
    EXPECT_EQ(planes_format, PixelFormat::rgb565_be);
    EXPECT_EQ(swapped, 1);
}

TEST_F(Platform, TheHostsPrecisionComesFirst) {
    EGLint precision = 0, visual = 0, type = 0;
    EXPECT_EQ(eglGetConfigAttrib(display, config, EGL_PRECISION_SPANGLE, &precision), yes);
    EXPECT_EQ(precision, EGL_PRECISION_BALANCED_SPANGLE);
    eglGetConfigAttrib(display, config, EGL_NATIVE_VISUAL_ID, &visual);
    EXPECT_EQ(visual, 0x21);
    eglGetConfigAttrib(display, config, EGL_NATIVE_VISUAL_TYPE, &type);
    EXPECT_EQ(type, 4);
}

} // namespace
} // namespace spangle::test

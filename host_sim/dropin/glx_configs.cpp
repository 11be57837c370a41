#include "host_sim/dropin/glx_configs.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>

#include "gl/context/limits.hpp"
#include "host_sim/dropin/options.hpp"

namespace spangle::dropin::glx {

namespace {

constexpr int most_pbuffer = gl::max_viewport_dim;

std::recursive_mutex mutex;

struct Screen {
    std::vector<SpangleFbConfig> configs;
    std::map<VisualID, int> chosen; ///< id of the configuration last chosen for each visual
};

std::map<std::pair<Display*, int>, std::unique_ptr<Screen>>& screens() {
    static auto* const all = new std::map<std::pair<Display*, int>, std::unique_ptr<Screen>>;
    return *all;
}

/// The TrueColor visuals of the root window's depth; the root window's own visual comes first.
std::vector<XVisualInfo> visuals_of(Display* display, int screen) {
    XVisualInfo wish = {};
    wish.screen = screen;
    wish.depth = DefaultDepth(display, screen);
    wish.c_class = TrueColor;
    int count = 0;
    XVisualInfo* const found =
        XGetVisualInfo(display, VisualScreenMask | VisualDepthMask | VisualClassMask, &wish, &count);
    std::vector<XVisualInfo> out(found, found + count);
    if (found != nullptr)
        XFree(found);
    const VisualID usual = XVisualIDFromVisual(DefaultVisual(display, screen));
    std::stable_partition(out.begin(), out.end(),
                          [usual](const XVisualInfo& v) { return v.visualid == usual; });
    return out;
}

int of_egl(EGLDisplay display, EGLConfig config, EGLint name) {
    EGLint value = 0;
    eglGetConfigAttrib(display, config, name, &value);
    return value;
}

/// The config of EGL that has these planes and can draw to windows; null where there is none.
EGLConfig egl_config(EGLDisplay display, int depth, int stencil, int samples) {
    const EGLint wish[] = {EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_SURFACE_TYPE,
                           EGL_WINDOW_BIT | EGL_PBUFFER_BIT | EGL_PIXMAP_BIT,
                           EGL_PRECISION_SPANGLE,
                           options().precision,
                           EGL_DEPTH_SIZE,
                           depth,
                           EGL_STENCIL_SIZE,
                           stencil,
                           EGL_SAMPLES,
                           samples,
                           EGL_NONE};
    EGLConfig configs[64];
    EGLint count = 0;
    eglChooseConfig(display, wish, configs, 64, &count);
    for (EGLint i = 0; i < count; ++i)
        if (of_egl(display, configs[i], EGL_DEPTH_SIZE) == depth &&
            of_egl(display, configs[i], EGL_STENCIL_SIZE) == stencil &&
            of_egl(display, configs[i], EGL_SAMPLES) == samples)
            return configs[i];
    return nullptr;
}

/// All combinations of planes that EGL has, the commonest first. The commonest combinations get visuals of
/// their own where there are not enough visuals for all.
std::vector<SpangleFbConfig> planes_of(EGLDisplay display) {
    std::vector<SpangleFbConfig> out;
    struct Planes {
        int depth, stencil;
    };
    constexpr Planes all[] = {{24, 8}, {16, 0}, {0, 0}};
    for (const int samples : {0, 4})
        for (const int accum : {0, 16})
            for (const bool two : {true, false})
                for (const Planes& planes : all) {
                    SpangleFbConfig c = {};
                    c.egl = egl_config(display, planes.depth, planes.stencil, samples);
                    if (c.egl == nullptr)
                        continue;
                    c.red = of_egl(display, c.egl, EGL_RED_SIZE);
                    c.green = of_egl(display, c.egl, EGL_GREEN_SIZE);
                    c.blue = of_egl(display, c.egl, EGL_BLUE_SIZE);
                    c.alpha = of_egl(display, c.egl, EGL_ALPHA_SIZE);
                    c.depth = planes.depth;
                    c.stencil = planes.stencil;
                    c.accum = accum;
                    c.samples = samples;
                    c.double_buffered = two;
                    out.push_back(c);
                }
    return out;
}

/// The order in which GLX lists configurations (GLX 1.4, table 3.4): single buffers first, then fewer
/// samples, deeper depth, less stencil and less accumulation. All configurations have equal colours.
bool before(const SpangleFbConfig& a, const SpangleFbConfig& b) {
    const auto key = [](const SpangleFbConfig& c) {
        return std::tuple(c.double_buffered, c.samples, -c.depth, c.stencil, c.accum, c.id);
    };
    return key(a) < key(b);
}

Screen& screen_of(Display* display, int screen) {
    std::unique_ptr<Screen>& found = screens()[{display, screen}];
    if (found != nullptr)
        return *found;
    found = std::make_unique<Screen>();
    const EGLDisplay egl = egl_display(display);
    if (screen < 0 || screen >= ScreenCount(display) || egl == EGL_NO_DISPLAY)
        return *found;
    const std::vector<XVisualInfo> visuals = visuals_of(display, screen);
    if (visuals.empty())
        return *found;
    found->configs = planes_of(egl);
    for (std::size_t i = 0; i < found->configs.size(); ++i) {
        SpangleFbConfig& c = found->configs[i];
        const XVisualInfo& visual = visuals[i % visuals.size()];
        c.id = static_cast<int>(i) + 1;
        c.screen = screen;
        c.visual = visual.visual;
        c.visual_id = visual.visualid;
        c.visual_depth = visual.depth;
        found->chosen.insert({c.visual_id, c.id});
    }
    std::sort(found->configs.begin(), found->configs.end(), before);
    return *found;
}

} // namespace

EGLDisplay egl_display(Display* display) {
    const EGLDisplay egl = eglGetPlatformDisplayEXT(EGL_PLATFORM_X11_KHR, display, nullptr);
    return egl != EGL_NO_DISPLAY && eglInitialize(egl, nullptr, nullptr) != EGL_FALSE ? egl : EGL_NO_DISPLAY;
}

const std::vector<SpangleFbConfig>& configs(Display* display, int screen) {
    const std::lock_guard<std::recursive_mutex> lock(mutex);
    return screen_of(display, screen).configs;
}

GLXFBConfig of_visual(Display* display, int screen, VisualID visual) {
    const std::lock_guard<std::recursive_mutex> lock(mutex);
    const Screen& all = screen_of(display, screen);
    const auto chosen = all.chosen.find(visual);
    for (const SpangleFbConfig& config : all.configs)
        if (chosen != all.chosen.end() && config.id == chosen->second)
            return &config;
    return nullptr;
}

void remember_choice(const SpangleFbConfig& config) {
    const std::lock_guard<std::recursive_mutex> lock(mutex);
    for (auto& [key, screen] : screens())
        for (const SpangleFbConfig& c : screen->configs)
            if (&c == &config)
                screen->chosen[config.visual_id] = config.id;
}

void forget_configs(Display* display) {
    const std::lock_guard<std::recursive_mutex> lock(mutex);
    std::erase_if(screens(), [display](const auto& known) { return known.first.first == display; });
}

GLXFBConfig checked(Display* display, GLXFBConfig config) {
    const std::lock_guard<std::recursive_mutex> lock(mutex);
    for (int s = 0; s < ScreenCount(display); ++s)
        for (const SpangleFbConfig& c : screen_of(display, s).configs)
            if (&c == config)
                return config;
    return nullptr;
}

bool attribute(const SpangleFbConfig& c, int name, int& value) {
    switch (name) {
    case USE_GL:
    case RGBA:
    case X_RENDERABLE:
        value = True;
        return true;
    case BUFFER_SIZE:
        value = c.red + c.green + c.blue + c.alpha;
        return true;
    case LEVEL:
    case STEREO:
    case AUX_BUFFERS:
    case TRANSPARENT_INDEX_VALUE:
    case TRANSPARENT_RED_VALUE:
    case TRANSPARENT_GREEN_VALUE:
    case TRANSPARENT_BLUE_VALUE:
    case TRANSPARENT_ALPHA_VALUE:
        value = 0;
        return true;
    case DOUBLEBUFFER:
        value = c.double_buffered ? True : False;
        return true;
    case RED_SIZE:
        value = c.red;
        return true;
    case GREEN_SIZE:
        value = c.green;
        return true;
    case BLUE_SIZE:
        value = c.blue;
        return true;
    case ALPHA_SIZE:
        value = c.alpha;
        return true;
    case DEPTH_SIZE:
        value = c.depth;
        return true;
    case STENCIL_SIZE:
        value = c.stencil;
        return true;
    case ACCUM_RED_SIZE:
    case ACCUM_GREEN_SIZE:
    case ACCUM_BLUE_SIZE:
    case ACCUM_ALPHA_SIZE:
        value = c.accum;
        return true;
    case SAMPLE_BUFFERS:
        value = c.samples != 0 ? 1 : 0;
        return true;
    case SAMPLES:
        value = c.samples;
        return true;
    case CONFIG_CAVEAT:
    case TRANSPARENT_TYPE:
        value = NONE;
        return true;
    case X_VISUAL_TYPE:
        value = TRUE_COLOR;
        return true;
    case VISUAL_ID:
        value = static_cast<int>(c.visual_id);
        return true;
    case SCREEN:
        value = c.screen;
        return true;
    case FBCONFIG_ID:
        value = c.id;
        return true;
    case RENDER_TYPE:
        value = RGBA_BIT;
        return true;
    case DRAWABLE_TYPE:
        value = WINDOW_BIT | PIXMAP_BIT | PBUFFER_BIT;
        return true;
    case MAX_PBUFFER_WIDTH:
    case MAX_PBUFFER_HEIGHT:
        value = most_pbuffer;
        return true;
    case MAX_PBUFFER_PIXELS:
        value = most_pbuffer * most_pbuffer;
        return true;
    default:
        return false;
    }
}

} // namespace spangle::dropin::glx

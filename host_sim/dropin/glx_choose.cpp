// The functions of GLX that choose visuals and framebuffer configurations (GLX 1.4, 3.3.3), and those that
// tell versions and extensions (3.3.1, 3.3.2).
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <tuple>

#include <X11/Xlibint.h>
#undef min
#undef max

#include "host_sim/dropin/glx_configs.hpp"

using namespace spangle::dropin;
using namespace spangle::dropin::glx;

namespace {

constexpr int major_version = 1, minor_version = 4;
constexpr const char* extension_list =
    "GLX_ARB_create_context GLX_ARB_create_context_profile GLX_ARB_get_proc_address GLX_ARB_multisample "
    "GLX_EXT_swap_control GLX_EXT_visual_info GLX_EXT_visual_rating GLX_MESA_swap_control GLX_SGIX_fbconfig "
    "GLX_SGI_make_current_read GLX_SGI_swap_control ";

/// How a wish is compared with a value of a configuration. `defaults` holds the wishes of attributes that the
/// program does not name (GLX 1.4, table 3.4).
enum class Rule { at_least, exact, mask, ignored };
struct AttributeRequest {
    int name;
    unsigned value;
    Rule rule;
};
constexpr AttributeRequest defaults[] = {
    {FBCONFIG_ID, DONT_CARE, Rule::exact},
    {BUFFER_SIZE, 0, Rule::at_least},
    {LEVEL, 0, Rule::exact},
    {DOUBLEBUFFER, DONT_CARE, Rule::exact},
    {STEREO, False, Rule::exact},
    {AUX_BUFFERS, 0, Rule::at_least},
    {RED_SIZE, 0, Rule::at_least},
    {GREEN_SIZE, 0, Rule::at_least},
    {BLUE_SIZE, 0, Rule::at_least},
    {ALPHA_SIZE, 0, Rule::at_least},
    {DEPTH_SIZE, 0, Rule::at_least},
    {STENCIL_SIZE, 0, Rule::at_least},
    {ACCUM_RED_SIZE, 0, Rule::at_least},
    {ACCUM_GREEN_SIZE, 0, Rule::at_least},
    {ACCUM_BLUE_SIZE, 0, Rule::at_least},
    {ACCUM_ALPHA_SIZE, 0, Rule::at_least},
    {SAMPLE_BUFFERS, 0, Rule::at_least},
    {SAMPLES, 0, Rule::at_least},
    {RENDER_TYPE, RGBA_BIT, Rule::mask},
    {DRAWABLE_TYPE, WINDOW_BIT, Rule::mask},
    {X_RENDERABLE, DONT_CARE, Rule::exact},
    {X_VISUAL_TYPE, DONT_CARE, Rule::exact},
    {CONFIG_CAVEAT, DONT_CARE, Rule::exact},
    {TRANSPARENT_TYPE, static_cast<unsigned>(NONE), Rule::exact},
    {TRANSPARENT_INDEX_VALUE, DONT_CARE, Rule::ignored},
    {TRANSPARENT_RED_VALUE, DONT_CARE, Rule::ignored},
    {TRANSPARENT_GREEN_VALUE, DONT_CARE, Rule::ignored},
    {TRANSPARENT_BLUE_VALUE, DONT_CARE, Rule::ignored},
    {TRANSPARENT_ALPHA_VALUE, DONT_CARE, Rule::ignored},
    {MAX_PBUFFER_WIDTH, DONT_CARE, Rule::ignored},
    {MAX_PBUFFER_HEIGHT, DONT_CARE, Rule::ignored},
    {MAX_PBUFFER_PIXELS, DONT_CARE, Rule::ignored},
    {VISUAL_ID, DONT_CARE, Rule::ignored},
    {SWAP_INTERVAL, DONT_CARE, Rule::ignored},
};

bool satisfies(const SpangleFbConfig& config, const AttributeRequest& wish) {
    if (wish.value == DONT_CARE || wish.rule == Rule::ignored)
        return true;
    int has = 0;
    attribute(config, wish.name, has);
    const auto value = static_cast<unsigned>(has);
    return wish.rule == Rule::at_least ? has >= static_cast<int>(wish.value)
           : wish.rule == Rule::exact  ? value == wish.value
                                       : (value & wish.value) == wish.value;
}

/// Reads a list of attributes and values. Returns false when the list names an attribute that does not exist.
bool read_wishes(const int* list, std::vector<AttributeRequest>& out) {
    out.assign(std::begin(defaults), std::end(defaults));
    for (; list != nullptr && *list != 0; list += 2) {
        const auto at = std::find_if(out.begin(), out.end(),
                                     [list](const AttributeRequest& w) { return w.name == list[0]; });
        if (at == out.end())
            return false;
        at->value = static_cast<unsigned>(list[1]);
    }
    return true;
}

/// Returns the configurations that fulfil all wishes, in memory that the program frees with XFree (GLX 1.4,
/// 3.3.3). Null: there are none.
GLXFBConfig* list_of(const std::vector<SpangleFbConfig>& all, const std::vector<AttributeRequest>& wishes,
                     int& count) {
    std::vector<GLXFBConfig> chosen;
    for (const SpangleFbConfig& config : all)
        if (std::all_of(wishes.begin(), wishes.end(),
                        [&](const AttributeRequest& w) { return satisfies(config, w); }))
            chosen.push_back(&config);
    count = 0;
    const std::size_t bytes = chosen.size() * sizeof(GLXFBConfig);
    auto* const out = bytes == 0 ? nullptr : static_cast<GLXFBConfig*>(std::malloc(bytes));
    if (out == nullptr)
        return nullptr;
    std::memcpy(out, chosen.data(), bytes);
    count = static_cast<int>(chosen.size());
    return out;
}

XVisualInfo* visual_info(Display* display, const SpangleFbConfig& config) {
    XVisualInfo wish = {};
    wish.visualid = config.visual_id;
    int count = 0;
    return XGetVisualInfo(display, VisualIDMask, &wish, &count);
}

/// The attributes of glXChooseVisual, whose booleans stand without a value (GLX 1.4, 3.3.4).
struct VisualWish {
    std::vector<AttributeRequest> wishes;
    bool rgba = false;
};
bool read_visual_wish(const int* list, VisualWish& out) {
    out.wishes = {{DOUBLEBUFFER, False, Rule::exact}, {STEREO, False, Rule::exact}};
    while (list != nullptr && *list != 0) {
        const int name = *list++;
        if (name == RGBA)
            out.rgba = true;
        else if (name == DOUBLEBUFFER)
            out.wishes[0].value = True;
        else if (name == STEREO)
            out.wishes[1].value = True;
        else if (name != USE_GL) {
            const auto known = std::find_if(std::begin(defaults), std::end(defaults),
                                            [name](const AttributeRequest& w) { return w.name == name; });
            if (known == std::end(defaults))
                return false;
            out.wishes.push_back({name, static_cast<unsigned>(*list++), known->rule});
        }
    }
    return true;
}

/// Whether glXChooseVisual prefers `a` where both fulfil its wishes (GLX 1.4, 3.3.4). Fewer samples and a
/// smaller accumulation buffer come first; then the deeper depth buffer if one is wished, else the flatter.
bool is_smaller_config(const SpangleFbConfig& a, const SpangleFbConfig& b, bool wants_depth) {
    const auto key = [wants_depth](const SpangleFbConfig& c) {
        return std::tuple(c.samples, c.accum, wants_depth ? -c.depth : c.depth, c.stencil, c.id);
    };
    return key(a) < key(b);
}

} // namespace

namespace spangle::dropin::glx {

namespace {

/// Numbers that a GLX extension of the server would have. They stand in where the server has none, and no
/// extension of a server is given them.
constexpr int no_extension_error = 200, no_extension_event = 120, no_extension_opcode = 127;

XExtCodes codes_of(Display* display) {
    XExtCodes codes = {};
    if (XQueryExtension(display, "GLX", &codes.major_opcode, &codes.first_event, &codes.first_error) == 0) {
        codes.major_opcode = no_extension_opcode;
        codes.first_event = no_extension_event;
        codes.first_error = no_extension_error;
    }
    return codes;
}

void raise_x_error(Display* display, int code, int opcode, Request request, XID resource) {
    xError error = {};
    LockDisplay(display);
    error.type = X_Error;
    error.errorCode = static_cast<BYTE>(code);
    error.sequenceNumber = static_cast<CARD16>(display->request);
    error.resourceID = static_cast<CARD32>(resource);
    error.minorCode = static_cast<CARD16>(request);
    error.majorCode = static_cast<CARD8>(opcode);
    _XError(display, &error);
    UnlockDisplay(display);
}

} // namespace

void report(Display* display, Problem problem, Request request, XID resource) {
    const XExtCodes codes = codes_of(display);
    raise_x_error(display, codes.first_error + static_cast<int>(problem), codes.major_opcode, request,
                  resource);
}

void report_core(Display* display, int error, Request request, XID resource) {
    raise_x_error(display, error, codes_of(display).major_opcode, request, resource);
}

} // namespace spangle::dropin::glx

extern "C" {

Bool glXQueryExtension(Display* display, int* error_base, int* event_base) {
    const XExtCodes codes = codes_of(display);
    if (error_base != nullptr)
        *error_base = codes.first_error;
    if (event_base != nullptr)
        *event_base = codes.first_event;
    return True;
}

Bool glXQueryVersion(Display*, int* major, int* minor) {
    if (major != nullptr)
        *major = major_version;
    if (minor != nullptr)
        *minor = minor_version;
    return True;
}

const char* glXQueryExtensionsString(Display*, int) {
    return extension_list;
}

const char* glXGetClientString(Display*, int name) {
    switch (name) {
    case VENDOR:
        return "Spangle";
    case VERSION:
        return "1.4 Spangle";
    case EXTENSIONS:
        return extension_list;
    default:
        return nullptr;
    }
}

const char* glXQueryServerString(Display* display, int, int name) {
    return glXGetClientString(display, name);
}

GLXFBConfig* glXGetFBConfigs(Display* display, int screen, int* count) {
    return list_of(configs(display, screen), {}, *count);
}

GLXFBConfig* glXChooseFBConfig(Display* display, int screen, const int* list, int* count) {
    std::vector<AttributeRequest> wishes;
    *count = 0;
    return read_wishes(list, wishes) ? list_of(configs(display, screen), wishes, *count) : nullptr;
}

int glXGetFBConfigAttrib(Display* display, GLXFBConfig config, int name, int* value) {
    const GLXFBConfig found = checked(display, config);
    if (found == nullptr)
        return BAD_VISUAL;
    return attribute(*found, name, *value) ? Success : BAD_ATTRIBUTE;
}

XVisualInfo* glXGetVisualFromFBConfig(Display* display, GLXFBConfig config) {
    const GLXFBConfig found = checked(display, config);
    if (found == nullptr)
        return nullptr;
    remember_choice(*found);
    return visual_info(display, *found);
}

XVisualInfo* glXChooseVisual(Display* display, int screen, int* list) {
    VisualWish wish;
    if (!read_visual_wish(list, wish) || !wish.rgba)
        return nullptr; // Spangle has no visuals of colour indices
    bool wants_depth = false;
    for (const AttributeRequest& w : wish.wishes)
        wants_depth = wants_depth || (w.name == DEPTH_SIZE && w.value != 0);
    GLXFBConfig best = nullptr;
    for (const SpangleFbConfig& config : configs(display, screen)) {
        const bool good = std::all_of(wish.wishes.begin(), wish.wishes.end(),
                                      [&](const AttributeRequest& w) { return satisfies(config, w); });
        if (good && (best == nullptr || is_smaller_config(config, *best, wants_depth)))
            best = &config;
    }
    if (best == nullptr)
        return nullptr;
    remember_choice(*best);
    return visual_info(display, *best);
}

int glXGetConfig(Display* display, XVisualInfo* visual, int name, int* value) {
    if (visual == nullptr || visual->screen < 0 || visual->screen >= ScreenCount(display))
        return BAD_SCREEN;
    const GLXFBConfig config = of_visual(display, visual->screen, visual->visualid);
    if (name == USE_GL) {
        *value = config != nullptr ? True : False;
        return Success;
    }
    if (config == nullptr)
        return BAD_VISUAL;
    return attribute(*config, name, *value) ? Success : BAD_ATTRIBUTE;
}

int glXGetFBConfigAttribSGIX(Display* display, GLXFBConfig config, int name, int* value) {
    return glXGetFBConfigAttrib(display, config, name, value);
}

GLXFBConfig* glXChooseFBConfigSGIX(Display* display, int screen, int* list, int* count) {
    return glXChooseFBConfig(display, screen, list, count);
}

XVisualInfo* glXGetVisualFromFBConfigSGIX(Display* display, GLXFBConfig config) {
    return glXGetVisualFromFBConfig(display, config);
}

GLXFBConfig glXGetFBConfigFromVisualSGIX(Display* display, XVisualInfo* visual) {
    return visual == nullptr ? nullptr : of_visual(display, visual->screen, visual->visualid);
}
}

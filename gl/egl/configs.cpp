#include "gl/egl/configs.hpp"

#include <initializer_list>

#include "gl/context/error.hpp"
#include "gl/context/limits.hpp"
#include "gl/egl/platforms.hpp"
#include "gl/vertex/engine.hpp"

namespace spangle::egl {

namespace {

#ifdef SPANGLE_FIRMWARE
constexpr EGLint precision_count = 3; // firmware has no reference policies
#else
constexpr EGLint precision_count = 7;
#endif
/// Bit fields of a config's id less 1, from the lowest bit up: precision, depth, format, samples. Not every
/// combination exists.
constexpr int precision_bits = 3, depth_bits = 2, format_bits = 4;
constexpr EGLint plain_count = 1 << (precision_bits + depth_bits + format_bits);
constexpr EGLint config_count = plain_count * (raster::has_samples ? 2 : 1);
static_assert(precision_count <= 1 << precision_bits && pixel_formats <= 1 << format_bits);
/// Upper bound of the number of configs.
constexpr EGLint most_configs = pixel_formats * 3 * precision_count * (raster::has_samples ? 2 : 1);

/// Engines of [0] double and [1] shadow; null: not registered.
const gl::Engine* reference_engines[2] = {nullptr, nullptr};

Config config_of(EGLint id) {
    const auto i = static_cast<unsigned>(id - 1);
    const auto part = [i](int first, int bits) { return i >> first & ((1u << bits) - 1); };
    return {id, static_cast<PixelFormat>(part(precision_bits + depth_bits, format_bits)),
            static_cast<DepthFormat>(part(precision_bits, depth_bits)), id > plain_count,
            EGL_PRECISION_EXACT_SPANGLE + static_cast<EGLint>(part(0, precision_bits))};
}

/// True if this build has the config. Colour indices cannot be averaged, so their configs have no samples.
bool exists(const Config& config) {
    return raster::has_format(config.format) && raster::has_format(config.depth) &&
           !(config.multisampled && is_indexed(config.format)) &&
           precision_of(config.precision).engine != nullptr;
}

/// True if the rasterizer has no fused spans for this format.
bool is_slow(PixelFormat format) {
    return is_narrow(format) || is_indexed(format);
}

EGLConfig handle_of(const Config& config) {
    return reinterpret_cast<EGLConfig>(static_cast<std::uintptr_t>(config.id));
}

struct Attribute {
    bool known;
    EGLint value;
};

/// Returns EGL_NATIVE_VISUAL_ID. For a panel, its low eight bits are the pixel format in memory. The bits
/// above are 1 + the WireFormat that the window is sent in, or 0 if pixels are sent as they are.
EGLint visual_of(const Display& display, const Config& c) {
    const auto layout = static_cast<EGLint>(c.format);
#if SPANGLE_HAS_PLATFORMS
    if (display.system != nullptr)
        return fits_window(display, c) ? display.system->visual_id(c.format) : 0;
#endif
    if (!fits_window(display, c))
        return layout;
    const hal::WireFormat wire = display.native->info().wire;
    return wire == hal::WireFormat::none ? layout : layout | (1 + static_cast<EGLint>(wire)) << 8;
}

/// Returns the bits of EGL_SURFACE_TYPE without EGL_PBUFFER_BIT. Window systems have pixmaps, too.
EGLint shown_bits(const Display& display, const Config& c) {
    if (!fits_window(display, c))
        return 0;
#if SPANGLE_HAS_PLATFORMS
    if (display.system != nullptr)
        return EGL_WINDOW_BIT | EGL_PIXMAP_BIT;
#endif
    return EGL_WINDOW_BIT;
}

/// Returns the value of a config's attribute (EGL 1.4, table 3.1).
Attribute attribute(const Display& display, const Config& c, EGLint name) {
    const FormatInfo& info = raster::drawn_info(c.format);
    constexpr EGLint largest = gl::max_viewport_dim;
    switch (name) {
    case EGL_BUFFER_SIZE:
        return {true, info.grey ? info.red_bits
                                : info.red_bits + info.green_bits + info.blue_bits + info.alpha_bits +
                                      info.index_bits};
    case EGL_RED_SIZE:
        return {true, info.red_bits};
    case EGL_GREEN_SIZE:
        return {true, info.green_bits};
    case EGL_BLUE_SIZE:
        return {true, info.blue_bits};
    case EGL_ALPHA_SIZE:
        return {true, info.alpha_bits};
    case EGL_DEPTH_SIZE:
        return {true, c.depth == DepthFormat::none ? 0 : c.depth == DepthFormat::z16 ? 16 : 24};
    case EGL_STENCIL_SIZE:
        return {true, c.depth == DepthFormat::z24s8 ? 8 : 0};
    case EGL_CONFIG_CAVEAT:
        return {true, is_slow(c.drawn()) ? EGL_SLOW_CONFIG : EGL_NONE};
    case EGL_CONFIG_ID:
        return {true, c.id};
    case EGL_COLOR_BUFFER_TYPE:
        return {true, is_indexed(c.drawn()) ? EGL_INDEX_BUFFER_SPANGLE : EGL_RGB_BUFFER};
    case EGL_INDEX_SIZE_SPANGLE:
        return {true, info.index_bits};
    case EGL_SURFACE_TYPE:
        return {true, EGL_PBUFFER_BIT | shown_bits(display, c)};
    case EGL_RENDERABLE_TYPE:
#if SPANGLE_HAS_PLATFORMS
        return {true, EGL_OPENGL_BIT | platforms().renderable};
#else
        return {true, EGL_OPENGL_BIT};
#endif
    case EGL_CONFORMANT:
        return {true, 0}; // nobody has run the conformance tests
    case EGL_MAX_PBUFFER_WIDTH:
    case EGL_MAX_PBUFFER_HEIGHT:
        return {true, largest};
    case EGL_MAX_PBUFFER_PIXELS:
        return {true, largest * largest};
    case EGL_MIN_SWAP_INTERVAL:
        return {true, least_swap_interval};
    case EGL_MAX_SWAP_INTERVAL:
        return {true, most_swap_interval};
    case EGL_NATIVE_VISUAL_TYPE:
#if SPANGLE_HAS_PLATFORMS
        if (display.system != nullptr && fits_window(display, c))
            return {true, display.system->visual_type()};
#endif
        return {true, EGL_NONE};
    case EGL_TRANSPARENT_TYPE:
        return {true, EGL_NONE};
    case EGL_SAMPLES:
        return {true, c.multisampled ? EGLint{raster::sample_count} : 0};
    case EGL_SAMPLE_BUFFERS:
        return {true, c.multisampled ? 1 : 0};
    case EGL_NATIVE_VISUAL_ID:
        return {true, visual_of(display, c)};
    case EGL_PRECISION_SPANGLE:
        return {true, c.precision};
    case EGL_BIND_TO_TEXTURE_RGB:
    case EGL_BIND_TO_TEXTURE_RGBA:
    case EGL_NATIVE_RENDERABLE:
        return {true, EGL_FALSE};
    case EGL_LUMINANCE_SIZE:
    case EGL_ALPHA_MASK_SIZE:
    case EGL_LEVEL:
    case EGL_TRANSPARENT_RED_VALUE:
    case EGL_TRANSPARENT_GREEN_VALUE:
    case EGL_TRANSPARENT_BLUE_VALUE:
        return {true, 0};
    default:
        return {false, 0};
    }
}

/// Rules by which eglChooseConfig compares a requested value with a config's value. `defaults` has the rule
/// and the default of each attribute (EGL 1.4, table 3.4).
enum class Rule : std::uint8_t { at_least, exact, mask, ignored };
struct AttributeRequest {
    std::uint32_t name : 14; ///< tokens of config attributes are below 4000h
    std::int32_t value : 16;
    Rule rule : 2;
};
static_assert(sizeof(AttributeRequest) == 4); // boards keep the table of requests in flash
constexpr AttributeRequest defaults[] = {
    {EGL_BUFFER_SIZE, 0, Rule::at_least},
    {EGL_RED_SIZE, 0, Rule::at_least},
    {EGL_GREEN_SIZE, 0, Rule::at_least},
    {EGL_BLUE_SIZE, 0, Rule::at_least},
    {EGL_ALPHA_SIZE, 0, Rule::at_least},
    {EGL_LUMINANCE_SIZE, 0, Rule::at_least},
    {EGL_INDEX_SIZE_SPANGLE, 0, Rule::at_least},
    {EGL_ALPHA_MASK_SIZE, 0, Rule::at_least},
    {EGL_DEPTH_SIZE, 0, Rule::at_least},
    {EGL_STENCIL_SIZE, 0, Rule::at_least},
    {EGL_SAMPLES, 0, Rule::at_least},
    {EGL_SAMPLE_BUFFERS, 0, Rule::at_least},
    {EGL_CONFIG_CAVEAT, EGL_DONT_CARE, Rule::exact},
    {EGL_CONFIG_ID, EGL_DONT_CARE, Rule::exact},
    {EGL_LEVEL, 0, Rule::exact},
    {EGL_COLOR_BUFFER_TYPE, EGL_RGB_BUFFER, Rule::exact},
    {EGL_BIND_TO_TEXTURE_RGB, EGL_DONT_CARE, Rule::exact},
    {EGL_BIND_TO_TEXTURE_RGBA, EGL_DONT_CARE, Rule::exact},
    {EGL_NATIVE_RENDERABLE, EGL_DONT_CARE, Rule::exact},
    {EGL_NATIVE_VISUAL_TYPE, EGL_DONT_CARE, Rule::exact},
    {EGL_MIN_SWAP_INTERVAL, EGL_DONT_CARE, Rule::exact},
    {EGL_MAX_SWAP_INTERVAL, EGL_DONT_CARE, Rule::exact},
    {EGL_TRANSPARENT_TYPE, EGL_NONE, Rule::exact},
    {EGL_TRANSPARENT_RED_VALUE, EGL_DONT_CARE, Rule::ignored},
    {EGL_TRANSPARENT_GREEN_VALUE, EGL_DONT_CARE, Rule::ignored},
    {EGL_TRANSPARENT_BLUE_VALUE, EGL_DONT_CARE, Rule::ignored},
    {EGL_MAX_PBUFFER_WIDTH, EGL_DONT_CARE, Rule::ignored},
    {EGL_MAX_PBUFFER_HEIGHT, EGL_DONT_CARE, Rule::ignored},
    {EGL_MAX_PBUFFER_PIXELS, EGL_DONT_CARE, Rule::ignored},
    {EGL_NATIVE_VISUAL_ID, EGL_DONT_CARE, Rule::ignored},
    {EGL_MATCH_NATIVE_PIXMAP, EGL_NONE, Rule::ignored},
    {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, Rule::mask},
    {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT, Rule::mask},
    {EGL_CONFORMANT, 0, Rule::mask},
    {EGL_PRECISION_SPANGLE, EGL_DONT_CARE, Rule::exact},
};
constexpr int wish_count = sizeof defaults / sizeof defaults[0];

consteval int place_of(EGLint name) {
    int i = 0;
    while (static_cast<EGLint>(defaults[i].name) != name)
        ++i;
    return i;
}

struct AttributeRequests {
    EGLint value[wish_count];
};

/// Reads the attribute list of eglChooseConfig. False: the list has an unknown attribute, or a value that no
/// attribute has.
bool read_wishes(const EGLint* list, AttributeRequests& out) {
    for (int i = 0; i < wish_count; ++i)
        out.value[i] = defaults[i].value;
    for (; list != nullptr && *list != EGL_NONE; list += 2) {
        int i = 0;
        while (i < wish_count && static_cast<EGLint>(defaults[i].name) != list[0])
            ++i;
        if (i == wish_count)
            return false;
        if (list[1] < 0 && list[1] != EGL_DONT_CARE)
            return false;
        if (list[0] == EGL_LEVEL && list[1] == EGL_DONT_CARE)
            return false;
        out.value[i] = list[1];
    }
    return true;
}

bool matches(const Display& display, const Config& config, const AttributeRequests& wishes) {
    // With a CONFIG_ID, all other attributes are ignored (EGL 1.4, 3.4.1).
    const EGLint id = wishes.value[place_of(EGL_CONFIG_ID)];
    if (id != EGL_DONT_CARE)
        return config.id == id;
    for (int i = 0; i < wish_count; ++i) {
        const EGLint wish = wishes.value[i];
        if (wish == EGL_DONT_CARE || defaults[i].rule == Rule::ignored)
            continue;
        const EGLint value = attribute(display, config, defaults[i].name).value;
        const bool good = defaults[i].rule == Rule::at_least ? value >= wish
                          : defaults[i].rule == Rule::exact  ? value == wish
                                                             : (value & wish) == wish;
        if (!good)
            return false;
    }
    return true;
}

/// True if configs differ in depth and precision only. Ids then have the order that before() defines.
constexpr bool in_order = !SPANGLE_HAS_PLATFORMS &&
                          (raster::color_formats & (raster::color_formats - 1)) == 0 && !raster::has_samples;

/// True if config `a` is listed before `b` (EGL 1.4, 3.4.1.2). Configs without a caveat come first, then
/// those with more of the requested colour bits, then smaller buffers, then lower ids.
bool before(const Display& display, const AttributeRequests& wishes, const Config& a, const Config& b) {
    if (is_slow(a.drawn()) != is_slow(b.drawn()))
        return is_slow(b.drawn());
    EGLint bits_a = 0, bits_b = 0;
    for (const int i : {place_of(EGL_RED_SIZE), place_of(EGL_GREEN_SIZE), place_of(EGL_BLUE_SIZE),
                        place_of(EGL_ALPHA_SIZE)}) {
        if (wishes.value[i] == 0 || wishes.value[i] == EGL_DONT_CARE)
            continue;
        bits_a += attribute(display, a, defaults[i].name).value;
        bits_b += attribute(display, b, defaults[i].name).value;
    }
    if (bits_a != bits_b)
        return bits_a > bits_b;
    for (const EGLint name :
         {EGL_BUFFER_SIZE, EGL_SAMPLE_BUFFERS, EGL_SAMPLES, EGL_DEPTH_SIZE, EGL_STENCIL_SIZE}) {
        const EGLint va = attribute(display, a, name).value, vb = attribute(display, b, name).value;
        if (va != vb)
            return va < vb;
    }
    // The config with the display's own byte order comes before one that differs in nothing else.
    const bool own_a = fits_window(display, a), own_b = fits_window(display, b);
    if (own_a != own_b)
        return own_a;
#if SPANGLE_HAS_PLATFORMS
    if (a.precision != b.precision &&
        (a.precision == platforms().precision || b.precision == platforms().precision))
        return a.precision == platforms().precision;
#endif
    return a.id < b.id;
}

} // namespace

bool fits_window(const Display& display, const Config& config) {
#if SPANGLE_HAS_PLATFORMS
    if (display.system != nullptr)
        return display.system->shows(config.format);
#endif
    return display.native != nullptr && display.native->info().format == config.format;
}

Config find_config(const Display&, EGLConfig handle) {
    const auto id = reinterpret_cast<std::uintptr_t>(handle);
    if (id - 1 >= static_cast<std::uintptr_t>(config_count))
        // The test precedes the conversion, since a program may pass any number.
        return {};
    Config config = config_of(static_cast<EGLint>(id));
    if (!exists(config))
        config.id = 0;
    return config;
}

#if SPANGLE_HAS_PLATFORMS
Config made_of(Config config) {
    if (const DrawnFormat* const drawn = platforms().drawn; drawn != nullptr && config.id != 0) {
        config.format = drawn->format;
        config.precision = drawn->precision;
        config.multisampled = false;
    }
    return config;
}
#endif

Precision precision_of(EGLint precision) {
    // Precisions are numbered in the order exact, balanced, fast, double, then shadows of the first three.
    const EGLint policy = precision - EGL_PRECISION_EXACT_SPANGLE, shadow = policy - 4;
    if (precision_count == 3 || policy < 3) {
        const auto tier = static_cast<raster::Tier>(policy);
        return {raster::has_tier(tier) ? &gl::fixed_engine : nullptr, tier};
    }
    if (policy == 3)
        return {reference_engines[0], raster::Tier::exact};
    return {policy < precision_count ? reference_engines[1] : nullptr, static_cast<raster::Tier>(shadow)};
}

void register_engine(EGLint precision, const gl::Engine* engine) {
    if (precision == EGL_PRECISION_DOUBLE_SPANGLE)
        reference_engines[0] = engine;
    if (precision == EGL_PRECISION_SHADOW_SPANGLE)
        reference_engines[1] = engine;
}

} // namespace spangle::egl

using namespace spangle::egl;

extern "C" {

EGLBoolean eglGetConfigs(EGLDisplay dpy, EGLConfig* configs, EGLint config_size, EGLint* num_config) {
    begin_call(SPANGLE_TEXT("eglGetConfigs"));
    const Registry registry;
    const Display* const display = find_display(dpy);
    if (display == nullptr)
        return EGL_FALSE;
    if (num_config == nullptr)
        return fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("num_config is a null pointer"));
    EGLint n = 0;
    for (EGLint id = 1; id <= config_count; ++id) {
        const Config config = config_of(id);
        if (!exists(config))
            continue;
        if (configs != nullptr) {
            if (n >= config_size)
                break;
            configs[n] = handle_of(config);
        }
        ++n;
    }
    *num_config = n;
    return end_call();
}

EGLBoolean eglChooseConfig(EGLDisplay dpy, const EGLint* attrib_list, EGLConfig* configs, EGLint config_size,
                           EGLint* num_config) {
    begin_call(SPANGLE_TEXT("eglChooseConfig"));
    const Registry registry;
    const Display* const display = find_display(dpy);
    if (display == nullptr)
        return EGL_FALSE;
    if (num_config == nullptr)
        return fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("num_config is a null pointer"));
    AttributeRequests wishes;
    if (!read_wishes(attrib_list, wishes))
        return fail(EGL_BAD_ATTRIBUTE,
                    SPANGLE_TEXT("attrib_list has an attribute or a value that configs do not have"));
    static_assert(config_count <= UINT16_MAX);
    std::uint16_t found[most_configs];
    EGLint n = 0;
    for (EGLint id = 1; id <= config_count; ++id) {
        const Config config = config_of(id);
        if (!exists(config) || !matches(*display, config, wishes))
            continue;
        EGLint at = n++;
        for (; !in_order && at > 0 && before(*display, wishes, config, config_of(found[at - 1])); --at)
            found[at] = found[at - 1];
        found[at] = static_cast<std::uint16_t>(id);
    }
    if (n == 0 && wishes.value[place_of(EGL_RENDERABLE_TYPE)] == EGL_OPENGL_ES_BIT)
        spangle::message(EGL_SUCCESS,
                         SPANGLE_TEXT("eglChooseConfig: this is OpenGL; ask for EGL_RENDERABLE_TYPE, "
                                      "EGL_OPENGL_BIT (EGL means OpenGL ES where nothing is said)"));
    if (configs != nullptr && n > config_size)
        n = config_size < 0 ? 0 : config_size;
    for (EGLint i = 0; configs != nullptr && i < n; ++i)
        configs[i] = handle_of(config_of(found[i]));
    *num_config = n;
    return end_call();
}

EGLBoolean eglGetConfigAttrib(EGLDisplay dpy, EGLConfig config, EGLint name, EGLint* value) {
    begin_call(SPANGLE_TEXT("eglGetConfigAttrib"));
    const Registry registry;
    const Display* const display = find_display(dpy);
    if (display == nullptr)
        return EGL_FALSE;
    const Config found = find_config(*display, config);
    if (found.id == 0)
        return fail(EGL_BAD_CONFIG, SPANGLE_TEXT("config is not one of this display"));
    const Attribute result = attribute(*display, found, name);
    if (!result.known)
        return fail(EGL_BAD_ATTRIBUTE, SPANGLE_TEXT("attribute is not one of configs"));
    if (value == nullptr)
        return fail(EGL_BAD_PARAMETER, SPANGLE_TEXT("value is a null pointer"));
    *value = result.value;
    return end_call();
}
}

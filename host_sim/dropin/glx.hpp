// GLX 1.4 for the drop-in pair's own sources. The types and tokens have the values of every GLX (Khronos'
// registry).
#pragma once

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <spangle/GL/gl.h>

extern "C" {

using GLXContext = struct SpangleGlxContext*;
using GLXFBConfig = const struct SpangleFbConfig*;
using GLXDrawable = XID;
using GLXPixmap = XID;
using GLXWindow = XID;
using GLXPbuffer = XID;
using GLXContextID = XID;
using GLXProc = void (*)();

#define F(returns, name, parameters) GLAPI returns name parameters;
#include "host_sim/dropin/glx_functions.inc"
#undef F
}

namespace spangle::dropin::glx {

enum Token : int {
    USE_GL = 1,
    BUFFER_SIZE = 2,
    LEVEL = 3,
    RGBA = 4,
    DOUBLEBUFFER = 5,
    STEREO = 6,
    AUX_BUFFERS = 7,
    RED_SIZE = 8,
    GREEN_SIZE = 9,
    BLUE_SIZE = 10,
    ALPHA_SIZE = 11,
    DEPTH_SIZE = 12,
    STENCIL_SIZE = 13,
    ACCUM_RED_SIZE = 14,
    ACCUM_GREEN_SIZE = 15,
    ACCUM_BLUE_SIZE = 16,
    ACCUM_ALPHA_SIZE = 17,

    CONFIG_CAVEAT = 0x20,
    X_VISUAL_TYPE = 0x22,
    TRANSPARENT_TYPE = 0x23,
    TRANSPARENT_INDEX_VALUE = 0x24,
    TRANSPARENT_RED_VALUE = 0x25,
    TRANSPARENT_GREEN_VALUE = 0x26,
    TRANSPARENT_BLUE_VALUE = 0x27,
    TRANSPARENT_ALPHA_VALUE = 0x28,
    NONE = 0x8000,
    TRUE_COLOR = 0x8002,
    VISUAL_ID = 0x800B,
    SCREEN = 0x800C,
    DRAWABLE_TYPE = 0x8010,
    RENDER_TYPE = 0x8011,
    X_RENDERABLE = 0x8012,
    FBCONFIG_ID = 0x8013,
    RGBA_TYPE = 0x8014,
    COLOR_INDEX_TYPE = 0x8015,
    MAX_PBUFFER_WIDTH = 0x8016,
    MAX_PBUFFER_HEIGHT = 0x8017,
    MAX_PBUFFER_PIXELS = 0x8018,
    PRESERVED_CONTENTS = 0x801B,
    LARGEST_PBUFFER = 0x801C,
    WIDTH = 0x801D,
    HEIGHT = 0x801E,
    EVENT_MASK = 0x801F,
    PBUFFER_HEIGHT = 0x8040,
    PBUFFER_WIDTH = 0x8041,
    VISUAL_CAVEAT = 0x20, // attribute of GLX_EXT_visual_rating
    SAMPLE_BUFFERS = 100000,
    SAMPLES = 100001,
    SWAP_INTERVAL = 0x20F1,
    MAX_SWAP_INTERVAL = 0x20F2,

    CONTEXT_MAJOR_VERSION = 0x2091,
    CONTEXT_MINOR_VERSION = 0x2092,
    CONTEXT_FLAGS = 0x2094,
    CONTEXT_PROFILE_MASK = 0x9126,
};

inline constexpr int WINDOW_BIT = 1, PIXMAP_BIT = 2, PBUFFER_BIT = 4, RGBA_BIT = 1;
inline constexpr int CONTEXT_DEBUG_BIT = 1, CONTEXT_FORWARD_COMPATIBLE_BIT = 2; // bits of CONTEXT_FLAGS
inline constexpr int CONTEXT_CORE_PROFILE_BIT = 1, CONTEXT_COMPATIBILITY_PROFILE_BIT = 2;
inline constexpr unsigned DONT_CARE = 0xFFFFFFFF;

/// Errors that glXGetConfig returns.
inline constexpr int BAD_SCREEN = 1, BAD_ATTRIBUTE = 2, NO_EXTENSION = 3, BAD_VISUAL = 4, BAD_CONTEXT = 5,
                     BAD_VALUE = 6, BAD_ENUM = 7;

/// Names of strings that glXGetClientString knows.
inline constexpr int VENDOR = 1, VERSION = 2, EXTENSIONS = 3;

/// Errors of the X extension GLX, counted from its first.
enum class Problem : int {
    context = 0,
    context_state = 1,
    drawable = 2,
    pixmap = 3,
    context_tag = 4,
    current_window = 5,
    render_request = 6,
    large_request = 7,
    unsupported_private_request = 8,
    fb_config = 9,
    pbuffer = 10,
    current_drawable = 11,
    window = 12,
    profile = 13,
};

/// Requests of the X extension GLX that an error names.
enum class Request : int {
    create_context = 3,
    make_current = 5,
    copy_context = 10,
    swap_buffers = 11,
    use_x_font = 12,
    create_pixmap = 22,
    create_new_context = 24,
    make_context_current = 26,
    create_pbuffer = 27,
    get_drawable_attributes = 29,
    create_window = 31,
    destroy_window = 32,
    create_context_attribs = 34,
};

/// Calls the program's error handler, as the server would have done: report() for errors of GLX,
/// report_core() for errors of X.
void report(Display* display, Problem problem, Request request, XID resource);
void report_core(Display* display, int error, Request request, XID resource);

} // namespace spangle::dropin::glx

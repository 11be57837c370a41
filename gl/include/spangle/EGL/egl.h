/* EGL 1.4 as Spangle has it: it connects rendering contexts with displays. Types are those of Khronos'
 * headers with EGL_NO_X11. For C89 and up, and C++.
 * Written by gl/api/generate.py from gl/api/egl.json: change that, not this.
 *
 * A comment holds for all that stands below it, up to the next comment or empty line. A function that fails
 * returns EGL_FALSE, null or 0, does nothing else, and leaves an error for eglGetError. Where a comment names
 * no other errors: EGL_BAD_DISPLAY, EGL_NOT_INITIALIZED (eglInitialize did not succeed), EGL_BAD_CONFIG,
 * EGL_BAD_SURFACE, EGL_BAD_CONTEXT, for handles that are none, and EGL_BAD_PARAMETER for null pointers
 * (EGL 1.4, 3.1). Attribute lists end with EGL_NONE, may be null, and are read before the call returns. */
#ifndef SPANGLE_EGL_EGL_H
#define SPANGLE_EGL_EGL_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How functions are declared and called; a build may define them. */
#ifndef EGLAPI
#define EGLAPI extern
#endif
#ifndef EGLAPIENTRY
#define EGLAPIENTRY
#endif

/* The display, the pixmaps and the windows of the platform. spangle::native (spangle/native.hpp) makes such a
 * display of a HAL display. A board has one window, which is 0. */
typedef void* EGLNativeDisplayType;
typedef uintptr_t EGLNativePixmapType;
typedef uintptr_t EGLNativeWindowType;

/* Types (EGL 1.4, 2.1). Handles are opaque. */
typedef int32_t EGLint;
typedef unsigned int EGLBoolean;
typedef unsigned int EGLenum;
typedef void* EGLConfig;
typedef void* EGLContext;
typedef void* EGLDisplay;
typedef void* EGLSurface;
typedef void* EGLClientBuffer;
typedef intptr_t EGLAttrib; /* a type of EGL 1.5 */
typedef void (*__eglMustCastToProperFunctionPointerType)(void);

/* The versions that this EGL has. */
#define EGL_VERSION_1_0 1
#define EGL_VERSION_1_1 1
#define EGL_VERSION_1_2 1
#define EGL_VERSION_1_3 1
#define EGL_VERSION_1_4 1

/* Values of several types that name nothing, or the default. */
#define EGL_FALSE 0
#define EGL_TRUE 1
#define EGL_DONT_CARE ((EGLint)-1)
#define EGL_UNKNOWN ((EGLint)-1)
#define EGL_DEFAULT_DISPLAY ((EGLNativeDisplayType)0)
#define EGL_NO_CONTEXT ((EGLContext)0)
#define EGL_NO_DISPLAY ((EGLDisplay)0)
#define EGL_NO_SURFACE ((EGLSurface)0)

/* Errors (EGL 1.4, 3.1) */
#define EGL_SUCCESS 0x3000
#define EGL_NOT_INITIALIZED 0x3001
#define EGL_BAD_ACCESS 0x3002
#define EGL_BAD_ALLOC 0x3003
#define EGL_BAD_ATTRIBUTE 0x3004
#define EGL_BAD_CONFIG 0x3005
#define EGL_BAD_CONTEXT 0x3006
#define EGL_BAD_CURRENT_SURFACE 0x3007
#define EGL_BAD_DISPLAY 0x3008
#define EGL_BAD_MATCH 0x3009
#define EGL_BAD_NATIVE_PIXMAP 0x300A
#define EGL_BAD_NATIVE_WINDOW 0x300B
#define EGL_BAD_PARAMETER 0x300C
#define EGL_BAD_SURFACE 0x300D
#define EGL_CONTEXT_LOST 0x300E

/* Attributes of configs (EGL 1.4, 3.4, table 3.1) */
#define EGL_BUFFER_SIZE 0x3020
#define EGL_ALPHA_SIZE 0x3021
#define EGL_BLUE_SIZE 0x3022
#define EGL_GREEN_SIZE 0x3023
#define EGL_RED_SIZE 0x3024
#define EGL_DEPTH_SIZE 0x3025
#define EGL_STENCIL_SIZE 0x3026
#define EGL_CONFIG_CAVEAT 0x3027
#define EGL_CONFIG_ID 0x3028
#define EGL_LEVEL 0x3029
#define EGL_MAX_PBUFFER_HEIGHT 0x302A
#define EGL_MAX_PBUFFER_PIXELS 0x302B
#define EGL_MAX_PBUFFER_WIDTH 0x302C
#define EGL_NATIVE_RENDERABLE 0x302D
#define EGL_NATIVE_VISUAL_ID 0x302E
#define EGL_NATIVE_VISUAL_TYPE 0x302F
#define EGL_SAMPLES 0x3031
#define EGL_SAMPLE_BUFFERS 0x3032
#define EGL_SURFACE_TYPE 0x3033
#define EGL_TRANSPARENT_TYPE 0x3034
#define EGL_TRANSPARENT_BLUE_VALUE 0x3035
#define EGL_TRANSPARENT_GREEN_VALUE 0x3036
#define EGL_TRANSPARENT_RED_VALUE 0x3037
#define EGL_NONE 0x3038
#define EGL_BIND_TO_TEXTURE_RGB 0x3039
#define EGL_BIND_TO_TEXTURE_RGBA 0x303A
#define EGL_MIN_SWAP_INTERVAL 0x303B
#define EGL_MAX_SWAP_INTERVAL 0x303C
#define EGL_LUMINANCE_SIZE 0x303D
#define EGL_ALPHA_MASK_SIZE 0x303E
#define EGL_COLOR_BUFFER_TYPE 0x303F
#define EGL_RENDERABLE_TYPE 0x3040
#define EGL_MATCH_NATIVE_PIXMAP 0x3041
#define EGL_CONFORMANT 0x3042

/* Values of these attributes (EGL 1.4, 3.4) */
#define EGL_SLOW_CONFIG 0x3050
#define EGL_NON_CONFORMANT_CONFIG 0x3051
#define EGL_TRANSPARENT_RGB 0x3052
#define EGL_RGB_BUFFER 0x308E
#define EGL_LUMINANCE_BUFFER 0x308F
#define EGL_PBUFFER_BIT 0x0001
#define EGL_PIXMAP_BIT 0x0002
#define EGL_WINDOW_BIT 0x0004
#define EGL_OPENGL_ES_BIT 0x0001
#define EGL_OPENVG_BIT 0x0002
#define EGL_OPENGL_ES2_BIT 0x0004
#define EGL_OPENGL_BIT 0x0008

/* Strings, attributes of surfaces and of contexts, APIs (EGL 1.4, 3.3, 3.5, 3.7) */
#define EGL_VENDOR 0x3053
#define EGL_VERSION 0x3054
#define EGL_EXTENSIONS 0x3055
#define EGL_CLIENT_APIS 0x308D
#define EGL_HEIGHT 0x3056
#define EGL_WIDTH 0x3057
#define EGL_LARGEST_PBUFFER 0x3058
#define EGL_DRAW 0x3059
#define EGL_READ 0x305A
#define EGL_CORE_NATIVE_ENGINE 0x305B
#define EGL_NO_TEXTURE 0x305C
#define EGL_TEXTURE_FORMAT 0x3080
#define EGL_TEXTURE_TARGET 0x3081
#define EGL_MIPMAP_TEXTURE 0x3082
#define EGL_MIPMAP_LEVEL 0x3083
#define EGL_BACK_BUFFER 0x3084
#define EGL_SINGLE_BUFFER 0x3085
#define EGL_RENDER_BUFFER 0x3086
#define EGL_HORIZONTAL_RESOLUTION 0x3090
#define EGL_VERTICAL_RESOLUTION 0x3091
#define EGL_PIXEL_ASPECT_RATIO 0x3092
#define EGL_SWAP_BEHAVIOR 0x3093
#define EGL_BUFFER_PRESERVED 0x3094
#define EGL_BUFFER_DESTROYED 0x3095
#define EGL_CONTEXT_CLIENT_TYPE 0x3097
#define EGL_CONTEXT_CLIENT_VERSION 0x3098
#define EGL_MULTISAMPLE_RESOLVE 0x3099
#define EGL_MULTISAMPLE_RESOLVE_DEFAULT 0x309A
#define EGL_MULTISAMPLE_RESOLVE_BOX 0x309B
#define EGL_OPENGL_ES_API 0x30A0
#define EGL_OPENVG_API 0x30A1
#define EGL_OPENGL_API 0x30A2

/* Platforms: EGL_EXT_platform_base, EGL_MESA_platform_surfaceless, EGL_KHR_platform_x11 */
#define EGL_PLATFORM_X11_KHR 0x31D5
#define EGL_PLATFORM_X11_EXT 0x31D5
#define EGL_PLATFORM_SURFACELESS_MESA 0x31DD

/* Attributes of contexts and their values: EGL_KHR_create_context */
#define EGL_CONTEXT_MAJOR_VERSION_KHR 0x3098
#define EGL_CONTEXT_MINOR_VERSION_KHR 0x30FB
#define EGL_CONTEXT_FLAGS_KHR 0x30FC
#define EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR 0x30FD
#define EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_KHR 0x31BD
#define EGL_NO_RESET_NOTIFICATION_KHR 0x31BE
#define EGL_LOSE_CONTEXT_ON_RESET_KHR 0x31BF
#define EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR 0x0001
#define EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE_BIT_KHR 0x0002
#define EGL_CONTEXT_OPENGL_ROBUST_ACCESS_BIT_KHR 0x0004
#define EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR 0x0001
#define EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT_KHR 0x0002

/* EGL_EXT_buffer_age: an attribute of eglQuerySurface, the number of frames since the buffer was drawn. The
 * value 0 means that its contents are undefined. */
#define EGL_BUFFER_AGE_EXT 0x313D

/* EGL_SPANGLE_precision: a config attribute, the [tier](docs/glossary.md#tier) of accuracy. Contexts of the
 * config draw in that tier where no hint says otherwise. DOUBLE is the reference picture. SHADOW,
 * SHADOW_BALANCED and SHADOW_FAST are the tiers with a double beside every number. DOUBLE and SHADOW configs
 * exist on hosts only. */
#define EGL_PRECISION_SPANGLE 0x3F00
#define EGL_PRECISION_EXACT_SPANGLE 0x3F01
#define EGL_PRECISION_BALANCED_SPANGLE 0x3F02
#define EGL_PRECISION_FAST_SPANGLE 0x3F03
#define EGL_PRECISION_DOUBLE_SPANGLE 0x3F04
#define EGL_PRECISION_SHADOW_SPANGLE 0x3F05
#define EGL_PRECISION_SHADOW_BALANCED_SPANGLE 0x3F06
#define EGL_PRECISION_SHADOW_FAST_SPANGLE 0x3F07

/* EGL_SPANGLE_accum: an attribute of eglCreateWindowSurface, eglCreatePbufferSurface and eglQuerySurface: the
 * bits of a component of the accumulation buffer, 0 or 16. A request for 1 to 16 bits gives 16; other values
 * are EGL_BAD_MATCH. */
#define EGL_ACCUM_SIZE_SPANGLE 0x3F08

/* EGL_SPANGLE_bands: an attribute of eglCreateWindowSurface and eglQuerySurface: the rows of the depth,
 * stencil and accumulation buffers, and of the colour buffer where the display holds no whole frame. The
 * value 0 means all rows. Such a window is drawn [band](docs/glossary.md#band) by band, by spangle::frame
 * (spangle/frame.hpp). Where a byte holds pixels of several rows, the number is rounded up to whole bytes.
 * EGL_BAD_PARAMETER: the number is negative; EGL_BAD_MATCH: the display's own buffer has fewer rows. */
#define EGL_BAND_HEIGHT_SPANGLE 0x3F09
/* An attribute of a window with bands, on a display that holds no whole frame: bytes of memory for the record
 * of a frame, which eglSwapBuffers draws band by band. With 0 there is no record. Configs with samples have
 * no record. A frame that does not fit raises GL_OUT_OF_MEMORY and is not shown. spangle::frame draws such
 * frames by callback. */
#define EGL_BAND_RECORD_SPANGLE 0x3F0C
/* An attribute of eglQuerySurface: bytes of the record that the longest frame so far has taken. */
#define EGL_BAND_RECORD_PEAK_SPANGLE 0x3F0D

/* EGL_SPANGLE_color_index: configs whose EGL_COLOR_BUFFER_TYPE is EGL_INDEX_BUFFER_SPANGLE hold indices of
 * EGL_INDEX_SIZE_SPANGLE bits and no colours. Their contexts are in GL's color index mode (GL_INDEX_MODE is
 * TRUE). eglChooseConfig returns them only if its list names the type, since EGL_RGB_BUFFER is the default.
 *
 * A window of such a config has a palette. eglSetPaletteSPANGLE sets the colours of `count` indices from
 * `first` on; `rgb` holds bytes of red, green and blue for each. If the display has a palette in hardware,
 * the colours show at once. Otherwise the next eglSwapBuffers sends the pixels that they change. Initially
 * the bits RRRGGGBB of an index are its colour: R / 7, G / 7, B / 3. Errors: EGL_BAD_SURFACE: the surface is
 * not a window. EGL_BAD_MATCH: the surface has RGB colours. EGL_BAD_PARAMETER: indices are not between 0 and
 * 255, or `rgb` is null. */
#define EGL_INDEX_BUFFER_SPANGLE 0x3F0A
#define EGL_INDEX_SIZE_SPANGLE 0x3F0B

/* Returns the error of the last EGL function of this thread, EGL_SUCCESS if it did not fail, and forgets it
 * (EGL 1.4, 3.1). */
EGLAPI EGLint EGLAPIENTRY eglGetError(void);
/* Returns the handle of a display, or EGL_NO_DISPLAY if there is none. The native display must outlive
 * eglTerminate. No error is raised (EGL 1.4, 3.2). */
EGLAPI EGLDisplay EGLAPIENTRY eglGetDisplay(EGLNativeDisplayType display_id);
/* Initialises a display and its panel, and writes EGL's version, 1 and 4, where the pointers are not null.
 * EGL_NOT_INITIALIZED: the panel cannot be initialised; a message says why (EGL 1.4, 3.2). */
EGLAPI EGLBoolean EGLAPIENTRY eglInitialize(EGLDisplay dpy, EGLint* major, EGLint* minor);
/* Destroys all objects of a display. An object that is current is destroyed when it is no longer current (EGL
 * 1.4, 3.2). */
EGLAPI EGLBoolean EGLAPIENTRY eglTerminate(EGLDisplay dpy);
/* Returns a static string about a display, or the client extensions if the display is EGL_NO_DISPLAY. name:
 * EGL_CLIENT_APIS, EGL_EXTENSIONS, EGL_VENDOR, EGL_VERSION. EGL_BAD_PARAMETER: another name (EGL 1.4, 3.3).
 */
EGLAPI const char* EGLAPIENTRY eglQueryString(EGLDisplay dpy, EGLint name);
/* Writes up to config_size configs, and their number. If configs is null, only the number of all configs is
 * written (EGL 1.4, 3.4.1). */
EGLAPI EGLBoolean EGLAPIENTRY eglGetConfigs(EGLDisplay dpy, EGLConfig* configs, EGLint config_size,
                                            EGLint* num_config);
/* Writes up to config_size configs that have the attributes, the best first, and their number.
 * EGL_BAD_ATTRIBUTE: an attribute or a value does not exist (EGL 1.4, 3.4.1). */
EGLAPI EGLBoolean EGLAPIENTRY eglChooseConfig(EGLDisplay dpy, const EGLint* attrib_list, EGLConfig* configs,
                                              EGLint config_size, EGLint* num_config);
/* Writes an attribute of a config. EGL_BAD_ATTRIBUTE: there is no such attribute (EGL 1.4, 3.4.3). */
EGLAPI EGLBoolean EGLAPIENTRY eglGetConfigAttrib(EGLDisplay dpy, EGLConfig config, EGLint attribute,
                                                 EGLint* value);
/* Makes a surface of a window. EGL_BAD_NATIVE_WINDOW: there is no such window. EGL_BAD_ALLOC: the window has
 * a surface already, or there is not enough memory. EGL_BAD_MATCH: the config or an attribute does not suit
 * the window (EGL 1.4, 3.5.1). */
EGLAPI EGLSurface EGLAPIENTRY eglCreateWindowSurface(EGLDisplay dpy, EGLConfig config,
                                                     EGLNativeWindowType win, const EGLint* attrib_list);
/* Makes a surface in memory, of EGL_WIDTH x EGL_HEIGHT pixels. EGL_BAD_ALLOC: there is not enough memory.
 * EGL_BAD_MATCH: the config does not suit a pbuffer (EGL 1.4, 3.5.2). */
EGLAPI EGLSurface EGLAPIENTRY eglCreatePbufferSurface(EGLDisplay dpy, EGLConfig config,
                                                      const EGLint* attrib_list);
/* Makes a surface of a pixmap of the platform. EGL_BAD_NATIVE_PIXMAP: there is no such pixmap (EGL 1.4,
 * 3.5.4). */
EGLAPI EGLSurface EGLAPIENTRY eglCreatePixmapSurface(EGLDisplay dpy, EGLConfig config,
                                                     EGLNativePixmapType pixmap, const EGLint* attrib_list);
/* Makes a pbuffer of an OpenVG image. There are no such images here, so the call fails with EGL_BAD_PARAMETER
 * (EGL 1.4, 3.5.3). */
EGLAPI EGLSurface EGLAPIENTRY eglCreatePbufferFromClientBuffer(EGLDisplay dpy, EGLenum buftype,
                                                               EGLClientBuffer buffer, EGLConfig config,
                                                               const EGLint* attrib_list);
/* Sets an attribute of a surface. EGL_BAD_ATTRIBUTE: there is no such attribute. EGL_BAD_MATCH: the config
 * does not have the value (EGL 1.4, 3.5.6). */
EGLAPI EGLBoolean EGLAPIENTRY eglSurfaceAttrib(EGLDisplay dpy, EGLSurface surface, EGLint attribute,
                                               EGLint value);
/* Makes a pbuffer a texture of OpenGL ES. No config here binds to textures, so the call fails with
 * EGL_BAD_SURFACE, or with EGL_BAD_PARAMETER if buffer is not EGL_BACK_BUFFER (EGL 1.4, 3.6.1). */
EGLAPI EGLBoolean EGLAPIENTRY eglBindTexImage(EGLDisplay dpy, EGLSurface surface, EGLint buffer);
/* Ends eglBindTexImage, and fails with the same errors (EGL 1.4, 3.6.2). */
EGLAPI EGLBoolean EGLAPIENTRY eglReleaseTexImage(EGLDisplay dpy, EGLSurface surface, EGLint buffer);
/* Copies the colours of a surface to a pixmap. EGL_BAD_NATIVE_PIXMAP: there is no such pixmap. EGL_BAD_MATCH:
 * the pixmap has another format (EGL 1.4, 3.9.2). */
EGLAPI EGLBoolean EGLAPIENTRY eglCopyBuffers(EGLDisplay dpy, EGLSurface surface, EGLNativePixmapType target);
/* Destroys a surface. If it is current, it is destroyed when it is no longer current (EGL 1.4, 3.5.5). */
EGLAPI EGLBoolean EGLAPIENTRY eglDestroySurface(EGLDisplay dpy, EGLSurface surface);
/* Writes an attribute of a surface. EGL_BAD_ATTRIBUTE: there is no such attribute (EGL 1.4, 3.5.6). */
EGLAPI EGLBoolean EGLAPIENTRY eglQuerySurface(EGLDisplay dpy, EGLSurface surface, EGLint attribute,
                                              EGLint* value);
/* Makes an API current; EGL_OPENGL_API is current from the start and is the only one. (By EGL 1.4, 3.7
 * EGL_NONE would be current at first where there is no OpenGL ES.) EGL_BAD_PARAMETER: another API. */
EGLAPI EGLBoolean EGLAPIENTRY eglBindAPI(EGLenum api);
/* Returns the API that is current, EGL_OPENGL_API (EGL 1.4, 3.7). */
EGLAPI EGLenum EGLAPIENTRY eglQueryAPI(void);
/* Sets whether eglSwapBuffers of the current window waits. With 0 it does not wait; with 1 it waits as the
 * display was set up to do (EGL 1.4, 3.9.3). */
EGLAPI EGLBoolean EGLAPIENTRY eglSwapInterval(EGLDisplay dpy, EGLint interval);
/* Makes a context. It shares textures, buffers and lists with share_context if that is not EGL_NO_CONTEXT.
 * EGL_BAD_ALLOC: there is not enough memory. EGL_BAD_MATCH: the version, or the context to share with, does
 * not suit (EGL 1.4, 3.7.1). */
EGLAPI EGLContext EGLAPIENTRY eglCreateContext(EGLDisplay dpy, EGLConfig config, EGLContext share_context,
                                               const EGLint* attrib_list);
/* Destroys a context. If it is current, it is destroyed when it is no longer current (EGL 1.4, 3.7.2). */
EGLAPI EGLBoolean EGLAPIENTRY eglDestroyContext(EGLDisplay dpy, EGLContext ctx);
/* Makes a context current on this thread, with the surfaces to draw to and read from; all three may be none.
 * EGL_BAD_ACCESS: the context is current on another thread. EGL_BAD_MATCH: configs differ (EGL 1.4, 3.7.3).
 */
EGLAPI EGLBoolean EGLAPIENTRY eglMakeCurrent(EGLDisplay dpy, EGLSurface draw, EGLSurface read,
                                             EGLContext ctx);
/* Returns the context that is current on this thread, or EGL_NO_CONTEXT (EGL 1.4, 3.7.4). */
EGLAPI EGLContext EGLAPIENTRY eglGetCurrentContext(void);
/* Returns the surface of the current context. readdraw: EGL_DRAW, EGL_READ (EGL 1.4, 3.7.4). */
EGLAPI EGLSurface EGLAPIENTRY eglGetCurrentSurface(EGLint readdraw);
/* Returns the display of the current context, or EGL_NO_DISPLAY (EGL 1.4, 3.7.4). */
EGLAPI EGLDisplay EGLAPIENTRY eglGetCurrentDisplay(void);
/* Writes an attribute of a context. EGL_BAD_ATTRIBUTE: there is no such attribute (EGL 1.4, 3.7.4). */
EGLAPI EGLBoolean EGLAPIENTRY eglQueryContext(EGLDisplay dpy, EGLContext ctx, EGLint attribute,
                                              EGLint* value);
/* Returns when GL's commands on this thread are done (EGL 1.4, 3.8). */
EGLAPI EGLBoolean EGLAPIENTRY eglWaitGL(void);
/* Does what eglWaitGL does (EGL 1.4, 3.8). */
EGLAPI EGLBoolean EGLAPIENTRY eglWaitClient(void);
/* Returns when the platform's drawing is done. engine: EGL_CORE_NATIVE_ENGINE (EGL 1.4, 3.8). */
EGLAPI EGLBoolean EGLAPIENTRY eglWaitNative(EGLint engine);
/* Makes nothing current on this thread, and forgets its error (EGL 1.4, 3.11). */
EGLAPI EGLBoolean EGLAPIENTRY eglReleaseThread(void);
/* Sets colours of a window's palette; see EGL_SPANGLE_color_index above. */
EGLAPI EGLBoolean EGLAPIENTRY eglSetPaletteSPANGLE(EGLDisplay dpy, EGLSurface surface, EGLint first,
                                                   EGLint count, const uint8_t* rgb);
/* Shows what was drawn on a window. On other surfaces it does nothing. EGL_BAD_NATIVE_WINDOW: the display did
 * not accept the frame. A message says why, and the next call sends what is missing. EGL_BAD_SURFACE: the
 * surface is not the current draw surface. EGL_BAD_ALLOC: the record of the frame is incomplete (EGL 1.4,
 * 3.9.1). */
EGLAPI EGLBoolean EGLAPIENTRY eglSwapBuffers(EGLDisplay dpy, EGLSurface surface);
/* Returns the address of a function of GL or EGL by its name, or null if there is none (EGL 1.4, 3.10). */
EGLAPI __eglMustCastToProperFunctionPointerType EGLAPIENTRY eglGetProcAddress(const char* procname);

/* The commands of EGL_EXT_platform_base, and the same commands by their names in EGL 1.5; hosts only. Each
 * does what the command of EGL 1.4 does, and names the platform, or points to the native handle. */
EGLAPI EGLDisplay EGLAPIENTRY eglGetPlatformDisplayEXT(EGLenum platform, void* native_display,
                                                       const EGLint* attrib_list);
EGLAPI EGLSurface EGLAPIENTRY eglCreatePlatformWindowSurfaceEXT(EGLDisplay dpy, EGLConfig config,
                                                                void* native_window,
                                                                const EGLint* attrib_list);
EGLAPI EGLSurface EGLAPIENTRY eglCreatePlatformPixmapSurfaceEXT(EGLDisplay dpy, EGLConfig config,
                                                                void* native_pixmap,
                                                                const EGLint* attrib_list);
EGLAPI EGLDisplay EGLAPIENTRY eglGetPlatformDisplay(EGLenum platform, void* native_display,
                                                    const EGLAttrib* attrib_list);
EGLAPI EGLSurface EGLAPIENTRY eglCreatePlatformWindowSurface(EGLDisplay dpy, EGLConfig config,
                                                             void* native_window,
                                                             const EGLAttrib* attrib_list);
EGLAPI EGLSurface EGLAPIENTRY eglCreatePlatformPixmapSurface(EGLDisplay dpy, EGLConfig config,
                                                             void* native_pixmap,
                                                             const EGLAttrib* attrib_list);

#ifdef __cplusplus
}
#endif

#endif

#!/usr/bin/env python3
"""Tests that the pair exports what programs look up, and nothing else (docs/programs.md).

usage: symbols_test.py PAIR SOURCE
"""
import ctypes
import json
import os
import pathlib
import re
import subprocess
import sys

from harness import check, failures, need, spangle_environment

PAIR, SOURCE = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
LIBRARIES = ("libGL.so.1", "libEGL.so.1", "libOpenGL.so.0", "libGLX.so.0")
LINKS = ("libGL.so", "libEGL.so", "libGLESv2.so", "libGLESv1_CM.so")
# The names that piglit's utility library and waffle look up when they are loaded; without them the programs do not start.
EGL = """BindAPI ChooseConfig CreateContext CreatePbufferSurface CreateWindowSurface DestroyContext DestroySurface
    GetConfigAttrib GetCurrentContext GetCurrentDisplay GetCurrentSurface GetDisplay GetError GetProcAddress Initialize MakeCurrent
    QueryString QuerySurface SwapBuffers Terminate
    BindTexImage CopyBuffers CreatePbufferFromClientBuffer CreatePixmapSurface GetConfigs QueryAPI QueryContext ReleaseTexImage
    ReleaseThread SurfaceAttrib SwapInterval WaitClient WaitGL WaitNative GetPlatformDisplay GetPlatformDisplayEXT
    CreatePlatformWindowSurface CreatePlatformWindowSurfaceEXT""".split()
GLX = """ChooseVisual CreateContext CreateNewContext CreatePixmap DestroyContext GetCurrentDisplay GetCurrentDrawable
    GetFBConfigAttrib GetFBConfigs GetVisualFromFBConfig MakeCurrent QueryExtension QueryExtensionsString QueryVersion
    GetProcAddress GetProcAddressARB ChooseFBConfig CreateContextAttribsARB CreateGLXPixmap CreatePbuffer CreateWindow
    DestroyGLXPixmap DestroyPbuffer DestroyPixmap DestroyWindow GetClientString GetConfig GetCurrentContext
    GetCurrentReadDrawable GetSelectedEvent IsDirect MakeContextCurrent QueryContext QueryDrawable QueryServerString SelectEvent
    SwapBuffers SwapIntervalMESA SwapIntervalSGI UseXFont WaitGL WaitX CopyContext""".split()


def commands():
    """Returns every function of the public header, and every name with a suffix."""
    header = (SOURCE / "gl/include/spangle/GL/gl.h").read_text()
    aliases = (SOURCE / "gl/api/generated/aliases.inc").read_text()
    return (re.findall(r"GLAPIENTRY (gl\w+)\(", header) + re.findall(r"^ALIAS\([^,]+, (gl\w+),", aliases, re.M))


def in_child():
    """Looks names up as programs do: in each library on its own, then in all libraries in one process."""
    names = commands()
    for library in LIBRARIES + LINKS:
        handle = ctypes.CDLL(library)
        wanted = [n for n in names + ["egl" + n for n in EGL] + ["glX" + n for n in GLX] if not hasattr(handle, n)]
        check(not wanted, f"{library} lacks {wanted}")
    gl, egl = ctypes.CDLL("libGL.so.1"), ctypes.CDLL("libEGL.so.1")
    for find in (gl.glXGetProcAddress, gl.glXGetProcAddressARB, egl.eglGetProcAddress):
        find.restype, find.argtypes = ctypes.c_void_p, [ctypes.c_char_p]
        for name in names:
            address = ctypes.cast(getattr(gl, name), ctypes.c_void_p).value
            check(find(name.encode()) is not None, f"{find.__name__} does not find {name}")
            if name in ("glBegin", "glClear"):
                check(find(name.encode()) == address, f"{find.__name__} finds another {name} than the linker")
        check(find(b"glNoSuchFunction") is None, f"{find.__name__} finds what does not exist")
    egl.eglQueryString.restype = ctypes.c_char_p
    egl.eglQueryString.argtypes = [ctypes.c_void_p, ctypes.c_int]
    client = egl.eglQueryString(None, 0x3055).decode().split()
    for name in ("EGL_EXT_client_extensions", "EGL_EXT_platform_base", "EGL_MESA_platform_surfaceless",
                 "EGL_EXT_platform_x11", "EGL_KHR_platform_x11"):
        check(name in client, f"the client extensions lack {name}")
    one_context(gl, egl)
    mapped = {line.split()[-1] for line in pathlib.Path("/proc/self/maps").read_text().splitlines() if "/lib" in line}
    strangers = {m for m in mapped if re.search(r"lib(GL|EGL|OpenGL|GLX|GLdispatch)[._-]", m) and not m.startswith(str(PAIR))}
    check(not strangers, f"libraries of another GL are loaded too: {strangers}")


def one_context(gl, egl):
    """A context that libEGL made current is current for libGL, too. Its version is 1.x and not higher."""
    egl.eglGetPlatformDisplay.restype = ctypes.c_void_p
    egl.eglGetPlatformDisplay.argtypes = [ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p]
    display = ctypes.c_void_p(egl.eglGetPlatformDisplay(0x31DD, None, None))
    check(egl.eglInitialize(display, None, None) == 1, "eglInitialize fails")
    egl.eglQueryString.argtypes = [ctypes.c_void_p, ctypes.c_int]
    check("EGL_KHR_create_context" in egl.eglQueryString(display, 0x3055).decode().split(), "EGL_KHR_create_context is missing")
    check(egl.eglQueryString(display, 0x308D) == b"OpenGL", "CLIENT_APIS is not OpenGL")
    wish = (ctypes.c_int * 17)(0x3020, 32, 0x3024, 8, 0x3023, 8, 0x3022, 8, 0x3021, 8, 0x3025, 24, 0x3026, 1, 0x3040, 8, 0x3038)
    wish = (ctypes.c_int * 19)(*wish[:16], 0x3033, 1, 0x3038)
    config, count = ctypes.c_void_p(), ctypes.c_int()
    check(egl.eglChooseConfig(display, wish, ctypes.byref(config), 1, ctypes.byref(count)) == 1 and count.value == 1,
          "there is no config of RGBA8888, Z24S8 for pbuffers")
    size = (ctypes.c_int * 5)(0x3057, 160, 0x3056, 160, 0x3038)
    egl.eglCreatePbufferSurface.restype = egl.eglCreateContext.restype = ctypes.c_void_p
    surface = ctypes.c_void_p(egl.eglCreatePbufferSurface(display, config, size))
    for major, minor, there in ((1, 3, True), (1, 0, True), (1, 9, False), (2, 0, False), (3, 2, False)):
        version = (ctypes.c_int * 5)(0x3098, major, 0x30FB, minor, 0x3038)
        context = egl.eglCreateContext(display, config, None, version)
        check((context is not None) == there, f"a context of version {major}.{minor} is {'not ' if there else ''}created")
    context = ctypes.c_void_p(egl.eglCreateContext(display, config, None, None))
    check(egl.eglMakeCurrent(display, surface, surface, context) == 1, "eglMakeCurrent fails")
    gl.glGetString.restype = ctypes.c_char_p
    check((gl.glGetString(0x1F02) or b"").startswith(b"1."), f"libGL sees no context of libEGL: {gl.glGetString(0x1F02)}")


def exported():
    """The libraries export names of GL, EGL and GLX only."""
    words = subprocess.run(["nm", "-D", "--defined-only", PAIR / "libspangle-dropin.so.0"], stdout=subprocess.PIPE, text=True,
                           check=True).stdout
    names = [line.split()[-1] for line in words.splitlines()]
    strangers = [n for n in names if not re.match(r"(gl[A-Z]|egl[A-Z])", n)]
    check(not strangers, f"these names are seen from outside: {strangers[:10]}")
    for name in LINKS + LIBRARIES:
        check((PAIR / name).exists(), f"the folder lacks {name}")


if os.environ.get("IN_CHILD"):
    in_child()
    print(json.dumps(failures))
else:
    need("nm")
    exported()
    child = subprocess.run([sys.executable, *sys.argv], env=spangle_environment(PAIR, IN_CHILD="1"), check=False)
    check(child.returncode == 0, "names or contexts are not as programs expect them")
sys.exit(1 if failures else 0)

#!/usr/bin/env python3
"""Draws a triangle in a window of a toolkit a few times, and in another size in between: what such a program asks of GLX.

usage: toolkits.py sdl2|glfw|glut      exits with 0 when the picture read back is right, 77 without the library.
"""
import ctypes
import ctypes.util
import sys

WIDTH, HEIGHT = 200, 150
LARGER = (260, 190)
SKIPPED = 77
FRAMES = 4


def library(name):
    try:
        return ctypes.CDLL(name)
    except OSError:
        print(f"there is no {name}")
        sys.exit(SKIPPED)


class Drawing:
    """Draws a red triangle over the lower left half of a blue window."""
    def __init__(self):
        self.gl = ctypes.CDLL("libGL.so.1")
        self.wrong = []

    def draw(self, width, height):
        gl, f = self.gl, ctypes.c_float
        gl.glViewport(0, 0, width, height)
        gl.glClearColor(f(0), f(0), f(1), f(1))
        gl.glClear(0x4000)
        gl.glColor3f(f(1), f(0), f(0))
        gl.glBegin(4)
        for x, y in ((-1, -1), (1, -1), (-1, 1)):
            gl.glVertex2f(f(x), f(y))
        gl.glEnd()
        for at, color in (((width // 4, height // 4), (255, 0, 0)), ((width - 3, height - 3), (0, 0, 255))):
            pixel = (ctypes.c_ubyte * 4)()
            gl.glReadPixels(at[0], at[1], 1, 1, 0x1908, 0x1401, pixel)
            if tuple(pixel[:3]) != color:
                self.wrong.append(f"{width}x{height} {at}: {tuple(pixel[:3])}, not {color}")
        error = gl.glGetError()
        if error:
            self.wrong.append(f"glGetError: {error:#x}")


def sdl2(drawing):
    sdl = library("libSDL2-2.0.so.0")
    for name in ("SDL_CreateWindow", "SDL_GL_CreateContext"):
        getattr(sdl, name).restype = ctypes.c_void_p
    sdl.SDL_GetError.restype = ctypes.c_char_p
    if sdl.SDL_Init(0x20) != 0:
        return drawing.wrong.append(sdl.SDL_GetError().decode())
    window = ctypes.c_void_p(sdl.SDL_CreateWindow(b"triangle", 0, 0, WIDTH, HEIGHT, 2 | 0x20))
    context = ctypes.c_void_p(sdl.SDL_GL_CreateContext(window))
    if not context:
        return drawing.wrong.append(sdl.SDL_GetError().decode())
    w, h, event = ctypes.c_int(), ctypes.c_int(), (ctypes.c_ubyte * 64)()
    for size in ((WIDTH, HEIGHT), LARGER):
        sdl.SDL_SetWindowSize(window, *size)
        for _ in range(FRAMES):
            while sdl.SDL_PollEvent(event):
                pass
            sdl.SDL_GL_GetDrawableSize(window, ctypes.byref(w), ctypes.byref(h))
            drawing.draw(w.value, h.value)
            sdl.SDL_GL_SwapWindow(window)
    if (w.value, h.value) != LARGER:
        drawing.wrong.append(f"the window is {w.value}x{h.value}, not {LARGER}")
    sdl.SDL_GL_DeleteContext(context)
    sdl.SDL_DestroyWindow(window)
    return sdl.SDL_Quit()


def glfw(drawing):
    lib = library("libglfw.so.3")
    lib.glfwCreateWindow.restype = ctypes.c_void_p
    if not lib.glfwInit():
        return drawing.wrong.append("glfwInit fails")
    window = ctypes.c_void_p(lib.glfwCreateWindow(WIDTH, HEIGHT, b"triangle", None, None))
    if not window:
        return drawing.wrong.append("glfwCreateWindow fails")
    lib.glfwMakeContextCurrent(window)
    w, h = ctypes.c_int(), ctypes.c_int()
    for size in ((WIDTH, HEIGHT), LARGER):
        lib.glfwSetWindowSize(window, *size)
        for _ in range(FRAMES):
            lib.glfwPollEvents()
            lib.glfwGetFramebufferSize(window, ctypes.byref(w), ctypes.byref(h))
            drawing.draw(w.value, h.value)
            lib.glfwSwapBuffers(window)
    lib.glfwDestroyWindow(window)
    return lib.glfwTerminate()


def glut(drawing):
    lib = library("libglut.so.3.12")
    count = ctypes.c_int(1)
    lib.glutInit(ctypes.byref(count), (ctypes.c_char_p * 2)(b"triangle", None))
    lib.glutInitDisplayMode(2 | 16 | 4 | 32)  # DOUBLE, DEPTH, ACCUM, STENCIL
    lib.glutInitWindowSize(WIDTH, HEIGHT)
    window = lib.glutCreateWindow(b"triangle")
    size = [WIDTH, HEIGHT]
    resized = ctypes.CFUNCTYPE(None, ctypes.c_int, ctypes.c_int)(lambda w, h: size.__setitem__(slice(None), [w, h]))
    display = ctypes.CFUNCTYPE(None)(lambda: (drawing.draw(*size), lib.glutSwapBuffers()))
    lib.glutReshapeFunc(resized)
    lib.glutDisplayFunc(display)
    for wish in ((WIDTH, HEIGHT), LARGER):
        lib.glutReshapeWindow(*wish)
        for _ in range(FRAMES):
            lib.glutPostRedisplay()
            lib.glutMainLoopEvent()
    if lib.glutGet(0x66) == 0:
        drawing.wrong.append("the window's height is 0")
    return lib.glutDestroyWindow(window)


drawing = Drawing()
{"sdl2": sdl2, "glfw": glfw, "glut": glut}[sys.argv[1]](drawing)
print("\n".join(drawing.wrong))
sys.exit(1 if drawing.wrong else 0)

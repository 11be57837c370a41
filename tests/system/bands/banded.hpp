// Plays frames of a program on a simulated board, whole or band by band.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <spangle/GL/gl.h>
#include <spangle/boards/boards.hpp>
#include <spangle/frame.hpp>
#include <spangle/native.hpp>
#include <spangle/sim/board.hpp>

#include "boards/scenes/scene.hpp"

namespace spangle::test {

struct Program {
    std::string name;
    std::function<void(int, int)> setup;
    std::function<void(int)> draw;
};

inline Program program_of(const scenes::Scene& scene) {
    return {scene.id, scene.setup, scene.draw};
}

struct Setting {
    std::int32_t display_band = 0; ///< rows that the display holds; 0: all
    std::int32_t band_height = 0;  ///< EGL_BAND_HEIGHT_SPANGLE, in rows
    EGLint record = 0;             ///< EGL_BAND_RECORD_SPANGLE, in bytes
    EGLint depth = 24, stencil = 8, accum = 16;
    EGLint precision = EGL_DONT_CARE;
    EGLint samples = 0;
};

/// A window on a board, and a context that is current on it.
class Banded {
  public:
    Banded(hal::Board board, const Setting& setting) : board_(with_bands(board, setting)), sim(board_) {
        display = eglGetDisplay(native(sim.display()));
        const EGLint wish[] = {EGL_SURFACE_TYPE,  EGL_WINDOW_BIT,  EGL_RENDERABLE_TYPE,
                               EGL_OPENGL_BIT,    EGL_DEPTH_SIZE,  setting.depth,
                               EGL_STENCIL_SIZE,  setting.stencil, EGL_PRECISION_SPANGLE,
                               setting.precision, EGL_SAMPLES,     setting.samples,
                               EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        const EGLint window[] = {EGL_BAND_HEIGHT_SPANGLE,
                                 setting.band_height,
                                 EGL_ACCUM_SIZE_SPANGLE,
                                 setting.accum,
                                 EGL_BAND_RECORD_SPANGLE,
                                 setting.record,
                                 EGL_NONE};
        good = eglInitialize(display, nullptr, nullptr) != EGL_FALSE &&
               eglChooseConfig(display, wish, &config, 1, &count) != EGL_FALSE && count == 1;
        surface = eglCreateWindowSurface(display, config, 0, window);
        context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        good = good && eglMakeCurrent(display, surface, surface, context) != EGL_FALSE;
        records = setting.record != 0;
        EXPECT_TRUE(good) << "EGL refused";
    }
    ~Banded() {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglTerminate(display);
    }
    Banded(const Banded&) = delete;
    Banded& operator=(const Banded&) = delete;

    void set_up(const Program& program) {
        const hal::DisplayInfo info = sim.display().info();
        program.setup(info.width, info.height);
    }
    /// Draws and shows frame f. Returns what the controller's memory holds then.
    sim::Image show(const Program& program, int f) {
        const auto draw = [&] {
            ++draws;
            program.draw(f);
        };
        if (records) // a recorded window is drawn as any window is
            draw();
        EXPECT_TRUE(records ? eglSwapBuffers(display, surface) != EGL_FALSE : spangle::frame(display, draw))
            << program.name << ", frame " << f << ": " << eglGetError();
        EXPECT_TRUE(sim.display().finish().ok());
        return sim.memory();
    }
    std::int32_t height() { return sim.display().info().height; }

    bool good = false, records = false;
    int draws = 0; ///< calls of Program::draw
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLSurface surface = EGL_NO_SURFACE;
    EGLContext context = EGL_NO_CONTEXT;

  private:
    static hal::Board with_bands(hal::Board board, const Setting& setting) {
        board.display.band = setting.display_band;
        return board;
    }
    hal::Board board_;

  public:
    sim::SimBoard sim;
};

/// Returns the controller's memory after each of the frames.
inline std::vector<sim::Image> play(const hal::Board& board, const Setting& setting, const Program& program,
                                    int frames) {
    Banded window(board, setting);
    std::vector<sim::Image> shown;
    if (!window.good)
        return shown;
    window.set_up(program);
    for (int f = 0; f < frames; ++f)
        shown.push_back(window.show(program, f));
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << program.name;
    EXPECT_EQ(window.sim.violations_text(), "") << program.name;
    return shown;
}

} // namespace spangle::test

// What the environment asks of the drop-in pair: docs/programs.md lists the variables.
#pragma once

#include <optional>
#include <string>

#include <spangle/EGL/egl.h>
#include <spangle/format.hpp>
#include <spangle/hal/board.hpp>

#include "host_sim/bringup/attach.hpp"

namespace spangle::dropin {

struct Options {
    const hal::Board* board = nullptr; ///< SPANGLE_BOARD; null: none
    bringup::BusOptions bus;           ///< SPANGLE_SPIDEV and those beside it: a real display
    EGLint precision = EGL_PRECISION_EXACT_SPANGLE;
    int width = 0, height = 0; ///< SPANGLE_SIZE; 0: the glass's, or windows keep theirs
    bool panel_format = false; ///< SPANGLE_FORMAT=panel: windows have the panel's own pixels
    std::string shot;          ///< SPANGLE_SHOT: PNG of the last picture
    std::string report;        ///< SPANGLE_REPORT: figures of the run, for `spangle exec`
    std::string record;        ///< SPANGLE_RECORD: what was asked of GL, for `spangle profile`
    /// SPANGLE_RECORD_FORMAT: the surfaces that it is recorded for; none: the program's own.
    std::optional<PixelFormat> record_format;
    std::string capture;     ///< SPANGLE_CAPTURE: all that `spangle trade` judges frames by
    bool times_only = false; ///< SPANGLE_CAPTURE_TIMES: of each frame the time alone
    bool dither = true;      ///< SPANGLE_CAPTURE_DITHER: what GL_DITHER is at first
    /// SPANGLE_CAPTURE_FORMAT: the format of pbuffers, whatever their config says; none: what it says.
    std::optional<PixelFormat> capture_format;
    long frames = 0;            ///< SPANGLE_FRAMES: the program ends after so many; 0: by itself
    std::size_t memory = 0;     ///< bytes
    bool end_by_signal = false; ///< SPANGLE_SIGNAL: it ends by SIGTERM, so that a tracer writes what it has
    bool messages = false;      ///< SPANGLE_MESSAGES: Spangle's sentences go to standard error
};

/// Read once. A value that means nothing ends the program with a sentence that says so.
const Options& options();

} // namespace spangle::dropin

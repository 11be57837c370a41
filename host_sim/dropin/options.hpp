// The options of the drop-in pair, from environment variables; docs/programs.md lists these.
#pragma once

#include <optional>
#include <string>

#include <spangle/EGL/egl.h>
#include <spangle/format.hpp>
#include <spangle/hal/board.hpp>

#include "host_sim/bringup/attach.hpp"

namespace spangle::dropin {

struct Options {
    const hal::Board* board = nullptr; ///< SPANGLE_BOARD; null: no board
    bringup::BusOptions bus;           ///< SPANGLE_SPIDEV and related variables: a real display
    EGLint precision = EGL_PRECISION_EXACT_SPANGLE;
    int width = 0, height = 0; ///< SPANGLE_SIZE, pixels; 0: the size of the glass, or of the window
    bool panel_format = false; ///< SPANGLE_FORMAT=panel: windows have the panel's own pixel format
    std::string shot;          ///< SPANGLE_SHOT: file for a PNG of the last picture
    std::string report;        ///< SPANGLE_REPORT: file for figures of the run, for `spangle exec`
    std::string record;        ///< SPANGLE_RECORD: file for the recorded use of GL, for `spangle profile`
    /// SPANGLE_RECORD_FORMAT: the pixel format of surfaces for which the use is recorded; none: that of the
    /// program.
    std::optional<PixelFormat> record_format;
    std::string capture;     ///< SPANGLE_CAPTURE: file by which `spangle trade` judges frames
    bool times_only = false; ///< SPANGLE_CAPTURE_TIMES: captures only the time of each frame
    bool dither = true;      ///< SPANGLE_CAPTURE_DITHER: the initial value of GL_DITHER
    /// SPANGLE_CAPTURE_FORMAT: the format of pbuffers, instead of that of their config; none: the config's.
    std::optional<PixelFormat> capture_format;
    long frames = 0;        ///< SPANGLE_FRAMES: frames after which the program is ended; 0: it ends by itself
    std::size_t memory = 0; ///< SPANGLE_MEMORY: bytes for EGL
    bool end_by_signal = false; ///< SPANGLE_SIGNAL: the end is a SIGTERM, so that a tracer writes its data
    bool messages = false;      ///< SPANGLE_MESSAGES: messages of Spangle go to standard error
};

/// The options, which are read once. A value without meaning ends the program with a message.
const Options& options();

} // namespace spangle::dropin

// The options of the command line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <spangle/EGL/egl.h>
#include <spangle/raster/tier.hpp>

#include "host_sim/bringup/attach.hpp"

namespace spangle::cli {

/// Values of EGL_PRECISION_SPANGLE; host_sim/capture/names.hpp has their names.
enum class Precision : EGLint {
    exact = EGL_PRECISION_EXACT_SPANGLE,
    balanced = EGL_PRECISION_BALANCED_SPANGLE,
    fast = EGL_PRECISION_FAST_SPANGLE,
    reference = EGL_PRECISION_DOUBLE_SPANGLE,
    shadow = EGL_PRECISION_SHADOW_SPANGLE,
};

/// How the board presents frames. Options that are left at these values leave the board's own settings.
struct PresentOptions {
    std::string tear_free = "off"; ///< one of off, te, poll
    std::string pacing = "block";  ///< one of block, drop, coalesce
    int buffers = 0;
    int draw_ms = 0; ///< ms that the processor takes for a frame, in virtual time
    bool row_hash = false;
    bool any() const {
        return tear_free != "off" || pacing != "block" || buffers != 0 || draw_ms != 0 || row_hash;
    }
};

/// How a board draws that has no memory for a whole frame.
struct BandOptions {
    int height = 0;      ///< rows of a band; 0: whole frames
    bool record = false; ///< bands are drawn from a record of the frame; else by callback
    int record_bytes = 1 << 20;
};

struct RunOptions {
    std::string scene;       ///< id of the scene to draw; empty when a model is drawn
    std::string model;       ///< file of the model to draw; empty when a scene is drawn
    bool baked = false;      ///< the model is drawn as images of firmware hold it (`spangle bake`)
    bringup::BusOptions bus; ///< the board to draw on, simulated or real
    int frames = 1;
    int width = 0, height = 0; ///< pixels of an off-screen picture; 0: the board's glass
    Precision precision = Precision::exact;
    std::optional<raster::Knobs> knobs; ///< knobs of a tier that the user composed; none: `precision` is used
    bool dither = true;
    PresentOptions present;
    BandOptions bands;
    std::string shot;            ///< PNG file for the picture of the last frame
    std::string vcd;             ///< file for a trace of the wires
    std::uint64_t vcd_limit = 0; ///< most bytes of the trace; 0: the usual limit
    bool compare = false;        ///< also draw with the double reference
    std::string difference;      ///< PNG file of what differs from the reference
    bool stats = false;
    bool window = false;
    bool json = false;
};

} // namespace spangle::cli

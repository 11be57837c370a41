// What the command line asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <spangle/EGL/egl.h>
#include <spangle/raster/tier.hpp>

#include "host_sim/bringup/attach.hpp"

namespace spangle::cli {

/// EGL_PRECISION_SPANGLE; host_sim/capture/names.hpp has their names.
enum class Precision : EGLint {
    exact = EGL_PRECISION_EXACT_SPANGLE,
    balanced = EGL_PRECISION_BALANCED_SPANGLE,
    fast = EGL_PRECISION_FAST_SPANGLE,
    reference = EGL_PRECISION_DOUBLE_SPANGLE,
    shadow = EGL_PRECISION_SHADOW_SPANGLE,
};

/// How the board presents; what is left as it is stays as the board has it.
struct PresentOptions {
    std::string tear_free = "off"; ///< te, poll
    std::string pacing = "block";  ///< drop, coalesce
    int buffers = 0;
    int draw_ms = 0; ///< what the processor takes for a frame, in virtual time
    bool row_hash = false;
    bool any() const {
        return tear_free != "off" || pacing != "block" || buffers != 0 || draw_ms != 0 || row_hash;
    }
};

/// How a board that holds no whole frame draws.
struct BandOptions {
    int height = 0;      ///< rows; 0: whole frames
    bool record = false; ///< drawn once, from a record; else by callback
    int record_bytes = 1 << 20;
};

struct RunOptions {
    std::string scene;       ///< id of a scene; empty when a model is drawn
    std::string model;       ///< file of a model; empty when a scene is drawn
    bool baked = false;      ///< the model is drawn as images of firmware hold it (`spangle bake`)
    bringup::BusOptions bus; ///< the board, simulated or real
    int frames = 1;
    int width = 0, height = 0; ///< 0: the board's glass; else an off-screen picture of this size
    Precision precision = Precision::exact;
    std::optional<raster::Knobs> knobs; ///< of a tier that the user composed
    bool dither = true;
    PresentOptions present;
    BandOptions bands;
    std::string shot;            ///< PNG file of the last frame
    std::string vcd;             ///< trace of the wires
    std::uint64_t vcd_limit = 0; ///< its most bytes; 0: the usual
    bool compare = false;        ///< draw with the double reference too
    std::string difference;      ///< PNG file of what differs from it
    bool stats = false;
    bool window = false;
    bool json = false;
};

} // namespace spangle::cli

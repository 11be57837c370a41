// Measures how far a program in one tier and format is from the double reference, and what it sends.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <spangle/reference.hpp>
#include <spangle/sim/image.hpp>

#include "host_sim/trade/choice.hpp"
#include "host_sim/trade/program.hpp"

namespace spangle::trade {

struct Setting {
    int width = 320, height = 240, frames = 10;
    bool dither = false;
};

struct Measured {
    PictureError error;     ///< errors of covered pixels in all frames, against double in the same format
    double psnr_to_888 = 0; ///< dB, of the last frame, against double in eight bits: tier and format together
    /// How different the last frame looks from double in eight bits, 0 .. 1 (perceived.hpp).
    double perceived = 0;
    std::uint64_t off_own = 0;     ///< pixels whose coverage differs from brute force on the snapped vertices
    std::uint64_t off_snapped = 0; ///< pixels whose coverage differs from that of double, ideally snapped
    std::uint64_t off_unsnapped = 0; ///< pixels whose coverage differs from that of vertices in double
    std::uint64_t off_ideal = 0;     ///< pixels changed by ideal snapping of doubles: the cost of n.8 itself
    std::vector<StageError> stages;  ///< errors of the stages, from the shadow precision
    std::uint64_t frame_bytes = 0;   ///< bytes of a whole frame in this format
    /// Bytes of a frame after the first, sent to an ILI9341; 0 unless frames are in 565 and of its size.
    std::uint64_t bus_bytes = 0;
    sim::Image picture, reference, plain; ///< last frame: the tier; double; double in eight bits
    std::string problem;                  ///< why the program cannot be drawn; empty if it was
};

Measured measure(const Program& program, const Tier& tier, const Format& format, const Setting& setting);

} // namespace spangle::trade

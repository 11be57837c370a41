// Plays a board's scenes on its simulated display, and hands each presented frame to a function.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "boards/demo/demo.hpp"
#include "host_sim/boards/desk.hpp"

namespace spangle::sim {

struct PlayedFrame {
    const scenes::Scene& scene;
    int index;          ///< index in the frames of its scene
    std::uint32_t hash; ///< hash of what was drawn
    std::uint32_t fragments;
};

/// Plays the scenes. Returns what went wrong, or an empty string.
std::string play(Desk& desk, const std::vector<std::string>& ids, int frames,
                 const std::function<void(const PlayedFrame&)>& presented);

} // namespace spangle::sim

// Plays a board's scenes on its simulated display and hands each frame that was presented to whoever asks.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "boards/demo/demo.hpp"
#include "host_sim/boards/desk.hpp"

namespace spangle::sim {

struct PlayedFrame {
    const scenes::Scene& scene;
    int index;          ///< of the scene's frames
    std::uint32_t hash; ///< of what was drawn
    std::uint32_t fragments;
};

/// Empty, or what went wrong.
std::string play(Desk& desk, const std::vector<std::string>& ids, int frames,
                 const std::function<void(const PlayedFrame&)>& presented);

} // namespace spangle::sim

// A hash of the bytes that a program draws, which changes when any of them does.
#pragma once

#include <cstdint>
#include <string>

#include "host_sim/trade/measure.hpp"
#include "host_sim/trade/program.hpp"

namespace spangle::trade {

/// Draws all frames, and hashes their colours and depths, in their order. Returns why they cannot be drawn,
/// or an empty string.
std::string hash_frames(const Program& program, const Tier& tier, const Format& format,
                        const Setting& setting, std::uint64_t& out);

} // namespace spangle::trade

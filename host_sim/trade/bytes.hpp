// The bytes that a program draws, as a number: where any changes, so does that.
#pragma once

#include <cstdint>
#include <string>

#include "host_sim/trade/measure.hpp"
#include "host_sim/trade/program.hpp"

namespace spangle::trade {

/// Draws all frames, and makes a hash of their colours and depths, in their order. The result is empty, or
/// why they cannot be drawn.
std::string hash_frames(const Program& program, const Tier& tier, const Format& format,
                        const Setting& setting, std::uint64_t& out);

} // namespace spangle::trade

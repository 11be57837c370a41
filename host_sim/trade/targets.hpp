// What a frame costs on microcontrollers: images of firmware, counted in QEMU.
//
// A folder of firmware holds TARGET/PROGRAM-TIER.elf. ./dev firmware builds it: each image is one
// program with a library that has one tier, and nothing of the other two. tests/bench/trade_main.cpp is its
// main().
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/trade/choice.hpp"
#include "host_sim/trade/measure.hpp"

namespace spangle::trade {

struct Target {
    const char* name;
    const char* title;
    std::vector<const char*> machine; ///< the emulator and its machine
};
/// This machine is the target "host", which has no images.
inline constexpr const char* host_target = "host";
const std::vector<Target>& targets();
/// The name of every target, host first.
std::vector<std::string> target_names();

/// What one frame takes, and what the image holds.
struct BoardCost {
    std::uint64_t instructions; ///< mean of the frames that work_of_frames() looks at
    std::uint64_t flash;        ///< bytes that are stored: code, constants, first values of variables
    std::uint64_t ram; ///< bytes of variables, of the arena at most, and of the stack, without the picture
};

/// The image of a program in a tier, by its name in ASCII: what is no letter, digit, '-' or '.' is '_'. It
/// may be missing.
std::string image_path(const std::string& folder, const Target& target, const std::string& program,
                       const Tier& tier);

/// Runs an image. Empty, or what went wrong; the picture it draws must be the host's (`hash`, of
/// picture_hash()).
std::string count_on(const Target& target, const std::string& image, const Setting& setting,
                     std::uint32_t hash, BoardCost& out);

/// Bytes of an ELF image (32 bits, little endian): stored, and in RAM without what is stored nowhere else.
struct ImageSizes {
    std::uint64_t flash = 0, variables = 0;
};
std::string read_sizes(const std::string& image, ImageSizes& out);

/// What the firmware said of itself: "frame INSTRUCTIONS HASH" for each frame, "NAME BYTES" for memory.
struct Said {
    std::vector<std::uint64_t> frames;
    std::uint32_t hash = 0; ///< of the last frame
    std::uint64_t own = 0, surface = 0, peak = 0, stack = 0;
};
/// Empty, or what is missing.
std::string read_said(std::string_view text, Said& out);

} // namespace spangle::trade

// The cost of a frame on microcontrollers, counted by running images of firmware in QEMU.
//
// A folder of firmware holds TARGET/PROGRAM-TIER.elf. ./dev firmware builds it: each image is one program
// with a library that has one tier, and nothing of the other two. tests/tools/bench/trade_main.cpp is its
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
/// The name of this machine as a target. It has no images.
inline constexpr const char* host_target = "host";
const std::vector<Target>& targets();
/// The name of every target, host first.
std::vector<std::string> target_names();

/// What one frame costs, and how large the image is.
struct BoardCost {
    std::uint64_t instructions; ///< mean of the frames that work_of_frames() counts
    std::uint64_t flash;        ///< bytes that are stored: code, constants, first values of variables
    std::uint64_t ram; ///< bytes of variables, of the arena at most, and of the stack, without the picture
};

/// The image of a program in a tier, which may be missing. Its name is in ASCII; a character other than a
/// letter, digit, '-' or '.' becomes '_'.
std::string image_path(const std::string& folder, const Target& target, const std::string& program,
                       const Tier& tier);

/// Runs an image. The picture that it draws must be that of the host (`hash`, of picture_hash()). Returns
/// what went wrong, or an empty string.
std::string count_on(const Target& target, const std::string& image, const Setting& setting,
                     std::uint32_t hash, BoardCost& out);

/// Bytes of an ELF image (32 bits, little endian): in flash, and in RAM without the stack.
struct ImageSizes {
    std::uint64_t flash = 0, variables = 0;
};
std::string read_sizes(const std::string& image, ImageSizes& out);

/// What the firmware reports: "frame INSTRUCTIONS HASH" for each frame, "NAME BYTES" for memory.
struct FirmwareReport {
    std::vector<std::uint64_t> frames;
    std::uint32_t hash = 0; ///< hash of the last frame's picture
    std::uint64_t own = 0, surface = 0, peak = 0, stack = 0;
};
/// Reads the report. Returns what is missing, or an empty string.
std::string read_firmware_report(std::string_view text, FirmwareReport& out);

} // namespace spangle::trade

// Bytes to a USB device that answers what it likes, and to what a program does with it: what the fuzzer runs,
// and what the everyday tests replay.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gud_test {

/// Plugs in a device whose descriptors, modes, limits and answers `data` spells, and drives it. Aborts when
/// the host leaves files open, or takes a size that it must refuse.
void run_gud_stream(const std::uint8_t* data, std::size_t bytes);

/// Where a fuzzer starts: devices that are nearly right.
std::vector<std::vector<std::uint8_t>> gud_seeds();

} // namespace gud_test

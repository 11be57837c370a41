// A stream of bytes decides what a USB device answers, and what a program does with it. The fuzzer runs such
// streams, and the everyday tests replay them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gud_test {

/// Plugs in a device whose descriptors, modes, limits and answers come from `data`, and drives it. Aborts if
/// the host leaves files open, or accepts a size that it must refuse.
void run_gud_stream(const std::uint8_t* data, std::size_t bytes);

/// Returns streams to start a fuzzer with: devices that are nearly right.
std::vector<std::vector<std::uint8_t>> gud_seeds();

} // namespace gud_test

// Bytes to EGL and GL calls on several displays, contexts and surfaces, by public headers alone: what the
// fuzzer runs, and what the everyday tests replay.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spangle::test {

/// A stream is a row of steps of so many bytes; what a step needs beyond them is drawn by lot from them. So
/// steps can be left out, repeated and mixed, and all others mean what they meant. The first one sets up.
constexpr std::size_t stream_step = 16;

/// Runs the steps that `data` spells, then terminates all displays. Aborts when memory is left over, or EGL
/// forgot what it was told.
void run_egl_stream(const std::uint8_t* data, std::size_t bytes);

/// Where a fuzzer starts: streams in which each piece of a program meets each kind of surface.
std::vector<std::vector<std::uint8_t>> egl_seeds();

} // namespace spangle::test

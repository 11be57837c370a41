// Streams of bytes become EGL and GL calls on several displays, contexts and surfaces, by public headers
// only. The fuzzer runs such streams, and the everyday tests replay them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spangle::test {

/// A stream is a row of steps of this many bytes. Further bytes that a step needs are random numbers made
/// from the step's own. So steps can be removed, repeated and mixed without a change to the others. The first
/// step sets up.
constexpr std::size_t stream_step = 16;

/// Runs the steps in `data`, then terminates all displays. Aborts if memory is left over, or if EGL lost an
/// object or a state.
void run_egl_stream(const std::uint8_t* data, std::size_t bytes);

/// Returns streams to start a fuzzer with, in which each piece of a program meets each kind of surface.
std::vector<std::vector<std::uint8_t>> egl_seeds();

} // namespace spangle::test

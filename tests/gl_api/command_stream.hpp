// Bytes to GL calls, by the command table: what the fuzzer and the random-stream test run on the real
// pipeline.
#pragma once

#include <cstddef>
#include <cstdint>

namespace spangle::test {

/// Makes a context with a 64 x 48 surface of exact size, runs the commands that `data` spells, and destroys
/// it. Aborts when the arena is damaged or something is left in it. By its first byte a stream is drawn to a
/// window instead, whole and in bands (command_bands.hpp).
void run_command_stream(const std::uint8_t* data, std::size_t bytes);

/// Which of `entries` a byte names, where multiples of `other` mean something else.
constexpr std::size_t choice_of(std::uint8_t how, unsigned other, std::size_t entries) {
    return (how - how / other - 1) % entries;
}

} // namespace spangle::test

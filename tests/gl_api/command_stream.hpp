// Bytes to GL calls, by the command table: what the fuzzer and the random-stream test run on the real
// pipeline.
#pragma once

#include <cstddef>
#include <cstdint>

namespace spangle::test {

/// Makes a context with a 64 x 48 surface of exact size, runs the commands that `data` spells, and destroys
/// it. Every argument may be anything, but for what GL cannot check: client memory is large enough for the
/// sizes that are given. Aborts when the arena is damaged or something is left in it.
void run_command_stream(const std::uint8_t* data, std::size_t bytes);

/// Which of `entries` a byte names, where multiples of `other` mean something else.
constexpr std::size_t choice_of(std::uint8_t how, unsigned other, std::size_t entries) {
    return (how - how / other - 1) % entries;
}

} // namespace spangle::test

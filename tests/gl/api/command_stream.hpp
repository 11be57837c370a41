// Makes GL calls from bytes, by the command table. The fuzzer and the random-stream test run such streams on
// the real pipeline.
#pragma once

#include <cstddef>
#include <cstdint>

namespace spangle::test {

/// Makes a context with a 64 x 48 surface of exact size, runs the commands in `data`, and destroys the
/// context. Aborts if the arena is damaged or not empty afterwards. The first byte may choose a window
/// instead, drawn whole and in bands (command_bands.hpp).
void run_command_stream(const std::uint8_t* data, std::size_t bytes);

/// Returns which of `entries` a byte names; multiples of `other` mean something else.
constexpr std::size_t choice_of(std::uint8_t how, unsigned other, std::size_t entries) {
    return (how - how / other - 1) % entries;
}

} // namespace spangle::test

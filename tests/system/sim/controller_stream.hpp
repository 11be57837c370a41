// Streams of bytes decide what happens at the pins of a controller model. The fuzzer and the everyday tests
// run them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace sim_test {

/// Steps of a stream. A step is one byte modulo `count`, and the bytes named beside it follow.
enum class Step : std::uint8_t {
    command,     ///< byte
    parameter,   ///< byte
    data,        ///< n, n bytes
    repeat,      ///< n, byte: 4 n times
    select,      ///< level
    reset,       ///< level
    micros,      ///< 2 bytes
    millis,      ///< byte
    read,        ///< n bits (serial) or bytes (parallel)
    write_cycle, ///< ns
    read_cycle,  ///< 4 ns
    edge,        ///< pin and level; only at pins; ends the comparison with the twin
    look,        ///< reads the glass, the scan and TE
    count
};

/// The first bytes choose a chip, its front end and the glass. A front end of pins has a twin that gets the
/// same bytes, and both must hold the same afterwards. Aborts if they do not, or if a state is impossible.
void run_controller_stream(const std::uint8_t* data, std::size_t bytes);

/// Returns streams that do what drivers do: set-up, windows, pixels in every format, read-back, scrolling,
/// resets.
std::vector<std::vector<std::uint8_t>> controller_seeds();

} // namespace sim_test

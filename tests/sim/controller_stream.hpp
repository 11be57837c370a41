// Bytes to what happens at the pins of a controller model: what the fuzzer and the everyday tests run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace sim_test {

/// One byte each, modulo `count`; what follows stands beside it.
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
    edge,        ///< pin and level: only at pins, and the end of the comparison below
    look,        ///< at the glass, the scan and TE
    count
};

/// The first bytes choose a chip, its front end and the glass. Front ends of pins have a twin that is fed the
/// same bytes; both must hold the same afterwards. Aborts when they do not, or when a state is impossible.
void run_controller_stream(const std::uint8_t* data, std::size_t bytes);

/// Streams that do what drivers do: set-up, windows, pixels in every format, read-back, scrolling, resets.
std::vector<std::vector<std::uint8_t>> controller_seeds();

} // namespace sim_test

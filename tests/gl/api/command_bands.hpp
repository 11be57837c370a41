// Draws the same commands whole and in bands: the picture and the answers must be the same.
#pragma once

#include <cstddef>
#include <cstdint>

namespace spangle::test {

/// A stream whose first byte is below this number is drawn to a surface of GL alone.
constexpr std::uint8_t first_of_bands = 192;

/// Draws a frame of the commands in `data` to a window of a display with whole frames. Then draws it to a
/// display with bands, by callback or from a record. Aborts if the two differ, or if memory is left over. The
/// first six bytes choose the way, depth, format, samples, the height of bands, and the bytes of the record.
void run_in_bands(const std::uint8_t* data, std::size_t bytes);

} // namespace spangle::test

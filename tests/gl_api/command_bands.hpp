// The same commands drawn whole and in bands: one picture, and the same answers.
#pragma once

#include <cstddef>
#include <cstdint>

namespace spangle::test {

/// Streams that begin with a byte below this are drawn to a surface of GL alone.
constexpr std::uint8_t first_of_bands = 192;

/// Draws a frame of the commands that `data` spells to a window of a display with whole frames, then to one
/// with bands, by callback or from a record. Aborts where these differ, or where memory is left over. The
/// first six bytes choose the way, depth, format, samples, the height of bands, and the bytes of the record.
void run_in_bands(const std::uint8_t* data, std::size_t bytes);

} // namespace spangle::test

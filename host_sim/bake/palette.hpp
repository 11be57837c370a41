// Which few colours stand for all of a picture?
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace spangle::bake {

using Rgba = std::array<std::uint8_t, 4>;

/// The nearest color that a texel with these bits can be.
Rgba rounded(const Rgba& color, const std::uint8_t (&bits)[4]);

/// At most `most` colours of those bits: all of the picture's where there are no more, else the means of
/// boxes (Heckbert's median cut, widest box first) moved to where their pixels are (Lloyd's steps).
std::vector<Rgba> choose_palette(const std::vector<std::uint8_t>& rgba, std::size_t most,
                                 const std::uint8_t (&bits)[4]);

/// The entry with the least sum of squares.
std::size_t nearest_entry(const std::vector<Rgba>& palette, const Rgba& color);

} // namespace spangle::bake

// Selects few colours that stand for all colours of a picture.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace spangle::bake {

using Rgba = std::array<std::uint8_t, 4>;

/// The nearest colour that a texel with these bits for each component can have.
Rgba rounded(const Rgba& color, const std::uint8_t (&bits)[4]);

/// Chooses at most `most` colours, each of which a texel with `bits` can have. They are all colours of the
/// picture where it has no more. Otherwise they are the means of boxes (Heckbert's median cut, widest box
/// first), moved to where their pixels are (Lloyd's steps).
std::vector<Rgba> choose_palette(const std::vector<std::uint8_t>& rgba, std::size_t most,
                                 const std::uint8_t (&bits)[4]);

/// The index of the entry with the least sum of squared differences.
std::size_t nearest_entry(const std::vector<Rgba>& palette, const Rgba& color);

} // namespace spangle::bake

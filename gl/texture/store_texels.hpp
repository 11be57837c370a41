// Client images into texels.
#pragma once

#include "gl/pixel/pixel_layout.hpp"
#include "gl/texture/texture_object.hpp"

namespace spangle::gl {

struct Context;

/// A rectangle of texels, counted from the first texel of the array, border included.
struct TexelRect {
    std::uint32_t x, y, width, height;
};

/// Unpacks by the context's unpack and transfer state, clamps to [0, 1], rounds to the bits kept and stores
/// (GL 1.3, 3.8.1). The rectangle lies inside the image.
void store_texels(const Context& context, LevelImage& image, const TexelRect& rect, const PixelLayout& layout,
                  const void* pixels);

} // namespace spangle::gl

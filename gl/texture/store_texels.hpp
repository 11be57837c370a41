// Converts client images to texels.
#pragma once

#include "gl/pixel/pixel_layout.hpp"
#include "gl/texture/internal_format.hpp"
#include "gl/texture/texture_object.hpp"

namespace spangle::gl {

struct Context;

/// A box of texels. Offsets count from the first texel of the array, which may belong to the border.
struct TexelBox {
    std::uint32_t at[3], size[3];

    // Builds without 3D textures have one image, the first.
    std::uint32_t images() const { return SPANGLE_FEATURE_TEXTURE_3D ? size[2] : 1; }
    std::uint32_t first_image() const { return SPANGLE_FEATURE_TEXTURE_3D ? at[2] : 0; }
};

/// Unpacks a client image by the context's unpack and transfer state, clamps it to [0, 1], rounds it to the
/// texels' bits and stores it (GL 1.3, 3.8.1). The box lies inside the image. Images of a volume are stacked
/// as IMAGE_HEIGHT says.
void store_texels(const Context& context, LevelImage& image, const TexelBox& box, const PixelLayout& layout,
                  const void* pixels);

} // namespace spangle::gl

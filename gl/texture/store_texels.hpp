// Client images into texels.
#pragma once

#include "gl/pixel/pixel_layout.hpp"
#include "gl/texture/internal_format.hpp"
#include "gl/texture/texture_object.hpp"

namespace spangle::gl {

struct Context;

/// Texels, counted from the first one of the array, border included.
struct TexelBox {
    std::uint32_t at[3], size[3];

    // Where there are no volumes there is one image, the first.
    std::uint32_t images() const { return SPANGLE_FEATURE_TEXTURE_3D ? size[2] : 1; }
    std::uint32_t first_image() const { return SPANGLE_FEATURE_TEXTURE_3D ? at[2] : 0; }
};

/// Unpacks by the context's unpack and transfer state, clamps to [0, 1], rounds to the bits kept and stores
/// (GL 1.3, 3.8.1). The box lies inside the image; images of a volume are stacked as IMAGE_HEIGHT says.
void store_texels(const Context& context, LevelImage& image, const TexelBox& box, const PixelLayout& layout,
                  const void* pixels);

} // namespace spangle::gl

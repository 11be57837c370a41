// Client images and pixels of the framebuffer into texels, and texels one by one.
#pragma once

#include "gl/pixel/pixel_layout.hpp"
#include "gl/texture/internal_format.hpp"
#include "gl/texture/texture_object.hpp"

namespace spangle::gl {

struct Context;

/// Texels, counted from the first one of the array, border included.
struct TexelBox {
    std::uint32_t at[3], size[3];
};

/// Unpacks by the context's unpack and transfer state, clamps to [0, 1], rounds to the bits kept and stores
/// (GL 1.3, 3.8.1). The box lies inside the image; images of a volume are stacked as IMAGE_HEIGHT says.
void store_texels(const Context& context, LevelImage& image, const TexelBox& box, const PixelLayout& layout,
                  const void* pixels);

/// Codes of R, G, B, A with the bits that the format keeps (texel_bits); what it lacks is not looked at, or
/// is 0 and for alpha 1.
void store_texel(raster::TexelFormat format, const std::uint32_t rgba[4], std::uint8_t* to);
void load_texel(raster::TexelFormat format, const std::uint8_t* from, std::uint32_t rgba[4]);

} // namespace spangle::gl

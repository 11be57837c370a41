// Images of levels: makes them, replaces and discards them, and keeps those that recorded draws use.
#pragma once

#include "gl/texture/texture_object.hpp"

namespace spangle::gl {

class Arena;
struct Context;
struct ShareGroup;

/// Makes an image whose texels are not yet written. Returns null when the arena is full.
LevelImage* new_image(Arena& arena, const LevelShape& shape);

/// Clears all texels, so that old memory contents never show where GL leaves texels undefined.
void clear_texels(LevelImage& image);

/// Frees an image that no texture has any more. If recorded draws use the image, it is freed after them.
void discard_image(ShareGroup& share, LevelImage* image);

/// Whether recorded draws use the image.
bool is_recorded(const ShareGroup& share, const LevelImage& image);

/// Marks the images that the units sample as used by recorded draws.
void hold_textures(Context& context);

/// Replaces the image of a level, and discards the old one. Derived levels are updated if the texture
/// generates mipmaps (GL 1.4, 3.8.8).
void put_image(Context& context, TextureObject& texture, unsigned face, GLint level, LevelImage* image);

/// Updates the derived levels. It must be called when texels of a level have changed.
void image_written(Context& context, TextureObject& texture, unsigned face, GLint level);

/// Returns the texel format for a new level. If another level has the same internal format, its texel format
/// is returned. The levels then agree, although another surface may have been current.
raster::TexelFormat format_beside(const TextureObject& texture, GLint level, const LevelShape& shape);

} // namespace spangle::gl

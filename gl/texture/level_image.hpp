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

/// Frees an image that no texture has any more: at once, or when no recorded draw uses it any more.
void discard_image(ShareGroup& share, LevelImage* image);

/// Whether recorded draws use the image.
bool is_recorded(const ShareGroup& share, const LevelImage& image);

/// Marks the images that the units sample as used by recorded draws.
void hold_textures(Context& context);

/// Replaces the image of a level, and discards the old one. Derived levels are updated if the texture
/// generates mipmaps (GL 1.4, 3.8.8).
void put_image(Context& context, TextureObject& texture, unsigned face, GLint level, LevelImage* image);

/// Called when texels of a level have changed: updates derived levels.
void image_written(Context& context, TextureObject& texture, unsigned face, GLint level);

/// The texel format for a new level. It is that of another level with the same internal format, if there is
/// one: the levels then agree, whichever surface was current.
raster::TexelFormat format_beside(const TextureObject& texture, GLint level, const LevelShape& shape);

} // namespace spangle::gl

// Images of levels: made, put in place of others, read back.
#pragma once

#include "gl/texture/texture_object.hpp"

namespace spangle::gl {

class Arena;
struct Context;
struct ShareGroup;

/// An image of that shape, whose texels are to be written. Null: the arena is full.
LevelImage* new_image(Arena& arena, const LevelShape& shape);

/// Where GL leaves texels undefined no earlier ones shine through.
void clear_texels(LevelImage& image);

/// An image that no texture has any more goes, now or when no recorded draw looks at it any more.
void discard_image(ShareGroup& share, LevelImage* image);

/// Recorded draws look at the image.
bool is_recorded(const ShareGroup& share, const LevelImage& image);

/// What the units sample is looked at by draws that are recorded from now on.
void hold_textures(Context& context);

/// Puts an image where another was, which goes. Derived levels follow where the texture asks for them
/// (GL 1.4, 3.8.8).
void put_image(Context& context, TextureObject& texture, unsigned face, GLint level, LevelImage* image);

/// Texels of a level are others: derived levels follow.
void image_written(Context& context, TextureObject& texture, unsigned face, GLint level);

/// Levels of one texture and one internal format are kept alike, whichever surface was current.
raster::TexelFormat format_beside(const TextureObject& texture, GLint level, const LevelShape& shape);

} // namespace spangle::gl

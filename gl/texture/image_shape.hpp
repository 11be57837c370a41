// What the arguments of TexImage, CopyTexImage and their sub-image forms have in common
// (GL 1.3, 3.8.1, 3.8.2).
#pragma once

#include "gl/texture/store_texels.hpp"
#include "gl/texture/texture_target.hpp"

namespace spangle::gl {

/// An image to be made. Sizes that the target does not have are 1.
struct ImageRequest {
    ImageTarget target;
    GLint level, internal_format;
    GLsizei size[3];
    GLint border;
};

/// The shape, empty where a proxy cannot have it. False: the error is set.
bool shape_of(Context& context, const ImageRequest& request, LevelShape& shape);

/// A box of an image that is there, counted like the arguments of TexSubImage from inside its border. What
/// the target does not have is at 0, and 1.
struct SubImage {
    ImageTarget target;
    GLint level;
    GLint at[3];
    GLsizei size[3];
};

/// The image, to be written, and the box, or null and the error is set. Compressed images are refused
/// (GL 1.3, 3.8.3), constant ones become copies.
LevelImage* find_box(Context& context, const SubImage& sub, TexelBox& out);

/// All of an image.
TexelBox whole_box(const LevelShape& shape);

} // namespace spangle::gl

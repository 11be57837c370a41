// Checks of arguments that TexImage, CopyTexImage and their sub-image forms share (GL 1.3, 3.8.1, 3.8.2).
#pragma once

#include "gl/texture/store_texels.hpp"
#include "gl/texture/texture_target.hpp"

namespace spangle::gl {

/// An image to be made. Sizes along dimensions that the target does not have are 1.
struct ImageRequest {
    ImageTarget target;
    GLint level, internal_format;
    GLsizei size[3];
    GLint border;
};

/// Computes the shape of an image. If a proxy cannot have the image, the shape is empty. Returns false after
/// an error.
bool shape_of(Context& context, const ImageRequest& request, LevelShape& shape);

/// A box of an existing image. Offsets count from the first texel inside the border, as in TexSubImage. Along
/// dimensions that the target does not have, the offset is 0 and the size 1.
struct SubImage {
    ImageTarget target;
    GLint level;
    GLint at[3];
    GLsizei size[3];
};

/// Finds the image to be written, and sets `out` to the box within it. Returns null after an error.
/// Compressed images are refused (GL 1.3, 3.8.3), and constant images are replaced by copies.
LevelImage* find_box(Context& context, const SubImage& sub, TexelBox& out);

/// The box of a whole image.
TexelBox whole_box(const LevelShape& shape);

} // namespace spangle::gl

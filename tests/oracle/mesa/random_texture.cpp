#include "tests/oracle/mesa/random_texture.hpp"

#include <algorithm>
#include <vector>

#include "tests/oracle/mesa/random_image.hpp"

namespace spangle::oracle {

using test::Random;

namespace {

struct Format {
    GLenum internal, base;
    bool two_values = false; ///< whether Mesa and Spangle store different numbers of bits
};
/// Generic compressed formats are left out, because Mesa compresses some of them.
constexpr Format formats[] = {
    {1, GL_LUMINANCE},
    {2, GL_LUMINANCE_ALPHA},
    {3, GL_RGB},
    {4, GL_RGBA},
    {GL_ALPHA, GL_ALPHA},
    {GL_ALPHA4, GL_ALPHA},
    {GL_ALPHA8, GL_ALPHA},
    {GL_ALPHA12, GL_ALPHA},
    {GL_ALPHA16, GL_ALPHA},
    {GL_LUMINANCE, GL_LUMINANCE},
    {GL_LUMINANCE4, GL_LUMINANCE},
    {GL_LUMINANCE8, GL_LUMINANCE},
    {GL_LUMINANCE12, GL_LUMINANCE},
    {GL_LUMINANCE16, GL_LUMINANCE},
    {GL_LUMINANCE_ALPHA, GL_LUMINANCE_ALPHA},
    {GL_LUMINANCE4_ALPHA4, GL_LUMINANCE_ALPHA, true},
    {GL_LUMINANCE6_ALPHA2, GL_LUMINANCE_ALPHA},
    {GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA},
    {GL_LUMINANCE12_ALPHA4, GL_LUMINANCE_ALPHA},
    {GL_LUMINANCE12_ALPHA12, GL_LUMINANCE_ALPHA},
    {GL_LUMINANCE16_ALPHA16, GL_LUMINANCE_ALPHA},
    {GL_INTENSITY, GL_INTENSITY},
    {GL_INTENSITY4, GL_INTENSITY},
    {GL_INTENSITY8, GL_INTENSITY},
    {GL_INTENSITY12, GL_INTENSITY},
    {GL_INTENSITY16, GL_INTENSITY},
    {GL_RGB, GL_RGB},
    {GL_R3_G3_B2, GL_RGB},
    {GL_RGB4, GL_RGB, true},
    {GL_RGB5, GL_RGB, true},
    {GL_RGB8, GL_RGB},
    {GL_RGB10, GL_RGB},
    {GL_RGB12, GL_RGB},
    {GL_RGB16, GL_RGB},
    {GL_RGBA, GL_RGBA},
    {GL_RGBA2, GL_RGBA},
    {GL_RGBA4, GL_RGBA},
    {GL_RGB5_A1, GL_RGBA},
    {GL_RGBA8, GL_RGBA},
    {GL_RGB10_A2, GL_RGBA, true},
    {GL_RGBA12, GL_RGBA},
    {GL_RGBA16, GL_RGBA},
};
constexpr Format depth_formats[] = {{GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT},
                                    {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT},
                                    {GL_DEPTH_COMPONENT32, GL_DEPTH_COMPONENT}};

/// Components of border colours, as a texel of the format would have them.
constexpr GLubyte extremes[] = {0, 255};

} // namespace

RandomTexture::RandomTexture(Random& random, const Wishes& wishes) {
    choose_format(random, wishes);
    choose_size(random, wishes);
    glGenTextures(1, &name_);
    glBindTexture(target, name_);
    store_tight();
    for (GLubyte& c : border_color_)
        c = one_of(random, extremes);
    if (wishes.depths)
        std::fill(border_color_ + 1, border_color_ + 4, border_color_[0]);
    for (GLenum face = 0; face < (cube() ? 6u : 1u); ++face)
        for (int level = 0; level < levels; ++level)
            image(random, face, level);
    parameters(random, wishes);
}

RandomTexture::~RandomTexture() {
    glDeleteTextures(1, &name_);
}

void RandomTexture::choose_format(Random& random, const Wishes& wishes) {
    Format f;
    do
        f = wishes.depths ? one_of(random, depth_formats) : one_of(random, formats);
    while (wishes.same_bits && f.two_values);
    format_ = f.internal;
    base = f.base;
    two_values_ = f.two_values;
    few_bits = format_ == GL_R3_G3_B2 || format_ == GL_RGBA2 || format_ == GL_RGBA4 || format_ == GL_RGB5_A1;
}

void RandomTexture::choose_size(Random& random, const Wishes& wishes) {
    constexpr GLenum targets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP};
    target = wishes.plane ? GLenum{GL_TEXTURE_2D} : targets[random.below(wishes.depths ? 2 : 4)];
    for (int axis = 0; axis < dimensions(); ++axis)
        size[axis] = maybe(random) ? 1 << random.below(5) : whole(random, 1, 13);
    if (cube())
        size[1] = size[0];
    if (wishes.mipmaps)
        for (int n = std::max({size[0], size[1], size[2]}); n > 1; n /= 2)
            ++levels;
    border_ = wishes.borders && random.below(4) == 0 ? 1 : 0;
}

/// Mesa ignores texels in borders and takes the border colour, so the border's texels have that colour.
void RandomTexture::image(Random& random, GLenum face, int level) {
    int whole_size[3] = {1, 1, 1}, border[3] = {};
    for (int axis = 0; axis < dimensions(); ++axis) {
        border[axis] = border_;
        whole_size[axis] = std::max(size[axis] >> level, 1) + 2 * border_;
    }
    const bool depths = base == GL_DEPTH_COMPONENT;
    const std::size_t channels = depths ? 1 : 4;
    std::vector<GLubyte> texels;
    for (int z = 0; z < whole_size[2]; ++z)
        for (int y = 0; y < whole_size[1]; ++y)
            for (int x = 0; x < whole_size[0]; ++x) {
                const int at[] = {x, y, z};
                bool outside = false;
                for (int axis = 0; axis < 3; ++axis)
                    outside =
                        outside || at[axis] < border[axis] || at[axis] >= whole_size[axis] - border[axis];
                for (std::size_t c = 0; c < channels; ++c)
                    texels.push_back(outside       ? border_color_[c]
                                     : two_values_ ? one_of(random, extremes)
                                                   : static_cast<GLubyte>(random.below(256)));
            }
    const GLenum format = depths ? GL_DEPTH_COMPONENT : GL_RGBA;
    const auto internal = static_cast<GLint>(format_);
    if (target == GL_TEXTURE_1D)
        glTexImage1D(target, level, internal, whole_size[0], border_, format, GL_UNSIGNED_BYTE,
                     texels.data());
    else if (target == GL_TEXTURE_3D)
        glTexImage3D(target, level, internal, whole_size[0], whole_size[1], whole_size[2], border_, format,
                     GL_UNSIGNED_BYTE, texels.data());
    else
        glTexImage2D(cube() ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + face : target, level, internal, whole_size[0],
                     whole_size[1], border_, format, GL_UNSIGNED_BYTE, texels.data());
}

void RandomTexture::parameters(Random& random, const Wishes& wishes) {
    constexpr GLenum wraps[] = {GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE,
                                GL_CLAMP_TO_BORDER};
    constexpr GLenum axes[] = {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};
    for (const GLenum axis : axes)
        glTexParameteri(target, axis, static_cast<GLint>(one_of(random, wraps)));
    linear = wishes.linear && maybe(random);
    const bool also = wishes.mipmaps ? wishes.linear && maybe(random) : linear;
    const bool between = maybe(random);
    min = !wishes.mipmaps ? also ? GL_LINEAR : GL_NEAREST
          : also          ? between ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_NEAREST
          : between       ? GL_NEAREST_MIPMAP_LINEAR
                          : GL_NEAREST_MIPMAP_NEAREST;
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(min));
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, linear ? GL_LINEAR : GL_NEAREST);
    GLfloat color[4];
    for (int c = 0; c < 4; ++c)
        color[c] = static_cast<GLfloat>(border_color_[c]) / 255;
    glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, color);
}

} // namespace spangle::oracle

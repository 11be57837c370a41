#include "gl/texture/internal_format.hpp"

namespace spangle::gl {

using raster::BaseFormat;
using raster::TexelFormat;

bool texel_format_of(GLint internal_format, PixelFormat surface, TexelFormat& out) {
    switch (internal_format) {
    case GL_ALPHA:
    case GL_ALPHA4:
    case GL_ALPHA8:
    case GL_ALPHA12:
    case GL_ALPHA16:
        out = TexelFormat::a8;
        return true;
    case 1:
    case GL_LUMINANCE:
    case GL_LUMINANCE4:
    case GL_LUMINANCE8:
    case GL_LUMINANCE12:
    case GL_LUMINANCE16:
        out = TexelFormat::l8;
        return true;
    case 2:
    case GL_LUMINANCE_ALPHA:
    case GL_LUMINANCE4_ALPHA4:
    case GL_LUMINANCE6_ALPHA2:
    case GL_LUMINANCE8_ALPHA8:
    case GL_LUMINANCE12_ALPHA4:
    case GL_LUMINANCE12_ALPHA12:
    case GL_LUMINANCE16_ALPHA16:
        out = TexelFormat::la88;
        return true;
    case GL_INTENSITY:
    case GL_INTENSITY4:
    case GL_INTENSITY8:
    case GL_INTENSITY12:
    case GL_INTENSITY16:
        out = TexelFormat::i8;
        return true;
    case 3:
    case GL_RGB:
    case GL_R3_G3_B2:
    case GL_RGB4:
    case GL_RGB5:
        out = format_info(surface).bytes_per_pixel == 2 ? TexelFormat::rgb565 : TexelFormat::rgb888;
        return true;
    case GL_RGB8:
    case GL_RGB10:
    case GL_RGB12:
    case GL_RGB16:
        out = TexelFormat::rgb888;
        return true;
    case 4:
    case GL_RGBA:
    case GL_RGBA2:
    case GL_RGBA4:
    case GL_RGB5_A1:
    case GL_RGBA8:
    case GL_RGB10_A2:
    case GL_RGBA12:
    case GL_RGBA16:
        out = TexelFormat::rgba8888;
        return true;
    default:
        return false;
    }
}

BaseFormat base_format_of(TexelFormat format) {
    switch (format) {
    case TexelFormat::a8:
        return BaseFormat::alpha;
    case TexelFormat::l8:
        return BaseFormat::luminance;
    case TexelFormat::i8:
        return BaseFormat::intensity;
    case TexelFormat::la88:
        return BaseFormat::luminance_alpha;
    case TexelFormat::rgba8888:
        return BaseFormat::rgba;
    default:
        return BaseFormat::rgb;
    }
}

unsigned texel_bytes(TexelFormat format) {
    constexpr std::uint8_t bytes[] = {1, 1, 1, 2, 2, 3, 4};
    return bytes[static_cast<unsigned>(format)];
}

ColorBits texel_bits(TexelFormat format) {
    return format == TexelFormat::rgb565 ? ColorBits{{5, 6, 5, 8}} : ColorBits{};
}

} // namespace spangle::gl

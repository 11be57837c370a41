#include "gl/texture/internal_format.hpp"

#include "gl/texture/compressed_format.hpp"
#include "raster/span/texel.hpp"

namespace spangle::gl {

using raster::BaseFormat;
using raster::TexelFormat;

namespace {

/// Of formats without sizes.
TexelFormat rgb_of(PixelFormat surface) {
    return raster::drawn_info(surface).red_bits <= 5 ? TexelFormat::rgb565 : TexelFormat::rgb888;
}

bool depth_format_of(GLint internal_format, TexelFormat& out) {
    switch (internal_format) {
    case GL_DEPTH_COMPONENT:
    case GL_DEPTH_COMPONENT16:
        out = TexelFormat::z16;
        return SPANGLE_FEATURE_DEPTH_TEXTURES != 0;
    case GL_DEPTH_COMPONENT24:
    case GL_DEPTH_COMPONENT32:
        out = TexelFormat::z24;
        return SPANGLE_FEATURE_DEPTH_TEXTURES != 0;
    default:
        return false;
    }
}

void take_base_format(GLint& internal_format) {
    if (internal_format >= GL_COMPRESSED_ALPHA && internal_format <= GL_COMPRESSED_RGBA) {
        constexpr std::uint16_t base[] = {GL_ALPHA,     GL_LUMINANCE, GL_LUMINANCE_ALPHA,
                                          GL_INTENSITY, GL_RGB,       GL_RGBA};
        internal_format = base[internal_format - GL_COMPRESSED_ALPHA];
    }
}

/// Of the table, whatever the build holds.
bool kept_format_of(GLint internal_format, PixelFormat surface, TexelFormat& out) {
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
        out = rgb_of(surface);
        return true;
    case GL_R3_G3_B2:
        out = TexelFormat::rgb332;
        return true;
    case GL_RGB4:
    case GL_RGB5:
    case GL_RGB565: // ARB_ES2_compatibility
        out = TexelFormat::rgb565;
        return true;
    case GL_RGB8:
    case GL_RGB10:
    case GL_RGB12:
    case GL_RGB16:
        out = TexelFormat::rgb888;
        return true;
    case GL_RGBA2:
    case GL_RGBA4:
        out = TexelFormat::rgba4444;
        return true;
    case GL_RGB5_A1:
        out = TexelFormat::rgba5551;
        return true;
    case 4:
    case GL_RGBA:
    case GL_RGBA8:
    case GL_RGB10_A2:
    case GL_RGBA12:
    case GL_RGBA16:
        out = TexelFormat::rgba8888;
        return true;
    default:
        return depth_format_of(internal_format, out);
    }
}

} // namespace

bool texel_format_of(GLint& internal_format, PixelFormat surface, TexelFormat& out) {
    take_base_format(internal_format);
    return kept_format_of(internal_format, surface, out) && raster::has_format(out);
}

BaseFormat base_format_of(TexelFormat format, GLenum internal_format) {
    switch (raster::sampled(format)) {
    case TexelFormat::a8:
        return BaseFormat::alpha;
    case TexelFormat::i8:
        return BaseFormat::intensity;
    case TexelFormat::la88:
        return BaseFormat::luminance_alpha;
    case TexelFormat::l8:
    case TexelFormat::z16:
    case TexelFormat::z24:
        return BaseFormat::luminance;
    case TexelFormat::rgba8888:
    case TexelFormat::rgba4444:
    case TexelFormat::rgba5551:
        return BaseFormat::rgba;
    case TexelFormat::p4:
    case TexelFormat::p8:
        return base_format_of(palette_format_of(internal_format), internal_format);
    default:
        return BaseFormat::rgb;
    }
}

unsigned texel_size(TexelFormat format) {
    return static_cast<unsigned>(raster::texel_bytes(raster::sampled(format)));
}

ColorBits texel_bits(TexelFormat format) {
    switch (format) {
    case TexelFormat::rgb565:
        return {{5, 6, 5, 8}};
    case TexelFormat::rgba5551:
        return {{5, 5, 5, 1}};
    case TexelFormat::rgba4444:
        return {{4, 4, 4, 4}};
    case TexelFormat::rgb332:
        return {{3, 3, 2, 8}};
    case TexelFormat::z16:
        return {{16, 8, 8, 8}};
    case TexelFormat::z24:
        return {{24, 8, 8, 8}};
    default:
        return {};
    }
}

} // namespace spangle::gl

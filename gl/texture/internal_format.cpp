#include "gl/texture/internal_format.hpp"

#include <iterator>

#include "gl/texture/compressed_format.hpp"
#include "raster/ops/texel.hpp"

namespace spangle::gl {

using raster::BaseFormat;
using raster::TexelFormat;

namespace {

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
        static constexpr std::uint16_t base[] = {GL_ALPHA,     GL_LUMINANCE, GL_LUMINANCE_ALPHA,
                                                 GL_INTENSITY, GL_RGB,       GL_RGBA};
        constexpr auto is_base = [](GLenum compressed, GLenum format) {
            return base[compressed - GL_COMPRESSED_ALPHA] == format;
        };
        static_assert(is_base(GL_COMPRESSED_ALPHA, GL_ALPHA) &&
                      is_base(GL_COMPRESSED_LUMINANCE, GL_LUMINANCE) &&
                      is_base(GL_COMPRESSED_LUMINANCE_ALPHA, GL_LUMINANCE_ALPHA) &&
                      is_base(GL_COMPRESSED_INTENSITY, GL_INTENSITY) && is_base(GL_COMPRESSED_RGB, GL_RGB) &&
                      is_base(GL_COMPRESSED_RGBA, GL_RGBA) &&
                      std::size(base) == GL_COMPRESSED_RGBA - GL_COMPRESSED_ALPHA + 1);
        internal_format = base[internal_format - GL_COMPRESSED_ALPHA];
    }
}

/// The table `kept` has the texel formats of component counts 1 to 4, then of base formats from ALPHA on,
/// then of sized formats from ALPHA4 on. The sizes are 4, 8, 12 and 16 bits where the table does not say
/// otherwise. `none` marks tokens that are not internal formats. Its value etc1 is free for that, because
/// TexImage has no such format.
constexpr unsigned counted = 0, unsized = 4, sized = 9, all_kept = 42;
constexpr TexelFormat none = TexelFormat::etc1;
constexpr TexelFormat a8 = TexelFormat::a8, l8 = TexelFormat::l8, la = TexelFormat::la88,
                      i8 = TexelFormat::i8, rgb565 = TexelFormat::rgb565, rgb8 = TexelFormat::rgb888,
                      rgba4 = TexelFormat::rgba4444, rgba5 = TexelFormat::rgba5551,
                      rgba8 = TexelFormat::rgba8888;
constexpr TexelFormat kept[all_kept] = {
    l8,    la,     rgb8,   rgba8,                          // 1, 2, 3, 4
    a8,    rgb8,   rgba8,  l8,    la,                      // ALPHA, RGB, RGBA, LUMINANCE, LUMINANCE_ALPHA
    a8,    a8,     a8,     a8,    l8,    l8,    l8,    l8, // ALPHA, LUMINANCE
    la,    la,     la,     la,    la,    la,           // LUMINANCE_ALPHA: 4 4, 6 2, 8 8, 12 4, 12 12, 16 16
    i8,    i8,     i8,     i8,    i8,                  // INTENSITY, then its sized formats
    none,  rgb565, rgb565, rgb8,  rgb8,  rgb8,  rgb8,  // RGB: (2), 4, 5, 8, 10, 12, 16
    rgba4, rgba4,  rgba5,  rgba8, rgba8, rgba8, rgba8, // RGBA: 2, 4, 5 1, 8, 10 2, 12, 16
};

/// The index of an internal format in `kept`, or `all_kept` if it is not there.
constexpr unsigned place_of(GLenum token) {
    return token - 1 < 4                          ? token - 1 + counted
           : token - GL_ALPHA < sized - unsized   ? token - GL_ALPHA + unsized
           : token - GL_ALPHA4 < all_kept - sized ? token - GL_ALPHA4 + sized
                                                  : all_kept;
}
constexpr bool are_kept_as(TexelFormat format, auto... tokens) {
    return ((kept[place_of(static_cast<GLenum>(tokens))] == format) && ...);
}
static_assert(are_kept_as(a8, GL_ALPHA, GL_ALPHA4, GL_ALPHA8, GL_ALPHA12, GL_ALPHA16) &&
              are_kept_as(l8, 1, GL_LUMINANCE, GL_LUMINANCE4, GL_LUMINANCE8, GL_LUMINANCE12,
                          GL_LUMINANCE16) &&
              are_kept_as(la, 2, GL_LUMINANCE_ALPHA, GL_LUMINANCE4_ALPHA4, GL_LUMINANCE6_ALPHA2,
                          GL_LUMINANCE8_ALPHA8, GL_LUMINANCE12_ALPHA4, GL_LUMINANCE12_ALPHA12,
                          GL_LUMINANCE16_ALPHA16) &&
              are_kept_as(i8, GL_INTENSITY, GL_INTENSITY4, GL_INTENSITY8, GL_INTENSITY12, GL_INTENSITY16) &&
              are_kept_as(rgb565, GL_RGB4, GL_RGB5) &&
              are_kept_as(rgb8, 3, GL_RGB, GL_RGB8, GL_RGB10, GL_RGB12, GL_RGB16) &&
              are_kept_as(rgba4, GL_RGBA2, GL_RGBA4) && are_kept_as(rgba5, GL_RGB5_A1) &&
              are_kept_as(rgba8, 4, GL_RGBA, GL_RGBA8, GL_RGB10_A2, GL_RGBA12, GL_RGBA16) &&
              place_of(GL_RGBA16) == all_kept - 1 && place_of(GL_RGBA16 + 1) == all_kept);

/// Finds the texel format in the table, even if the build does not support it.
bool kept_format_of(GLint internal_format, PixelFormat surface, TexelFormat& out) {
    const auto token = static_cast<GLenum>(internal_format);
    const unsigned at = place_of(token);
    if (at == all_kept) {
        out = token == GL_RGB565 ? rgb565 : TexelFormat::rgb332; // ARB_ES2_compatibility
        return token == GL_RGB565 || token == GL_R3_G3_B2 || depth_format_of(internal_format, out);
    }
    out = kept[at];
    if (at < sized && out == rgb8 && raster::drawn_info(surface).red_bits <= 5)
        out = rgb565;
    return out != none;
}

/// The client format and type that texels in memory have, so that the same code packs and unpacks client
/// images and texels.
struct Texel {
    std::uint16_t format, type;
};
constexpr Texel texels[] = {
    {GL_ALPHA, GL_UNSIGNED_BYTE},
    {GL_RED, GL_UNSIGNED_BYTE},
    {GL_RED, GL_UNSIGNED_BYTE},
    {GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE},
    {GL_RGB, GL_UNSIGNED_SHORT_5_6_5},
    {GL_RGB, GL_UNSIGNED_BYTE},
    {GL_RGBA, GL_UNSIGNED_BYTE},
    {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4},
    {GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1},
    {GL_RGB, GL_UNSIGNED_BYTE_3_3_2},
    {GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT},
    {GL_DEPTH_COMPONENT, GL_UNSIGNED_INT},
};
constexpr bool lies_as(TexelFormat format, GLenum client_format, GLenum type) {
    const Texel& texel = texels[static_cast<unsigned>(format)];
    return texel.format == client_format && texel.type == type;
}
static_assert(lies_as(a8, GL_ALPHA, GL_UNSIGNED_BYTE) && lies_as(l8, GL_RED, GL_UNSIGNED_BYTE) &&
              lies_as(i8, GL_RED, GL_UNSIGNED_BYTE) && lies_as(la, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE) &&
              lies_as(rgb565, GL_RGB, GL_UNSIGNED_SHORT_5_6_5) && lies_as(rgb8, GL_RGB, GL_UNSIGNED_BYTE) &&
              lies_as(rgba8, GL_RGBA, GL_UNSIGNED_BYTE) &&
              lies_as(rgba4, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4) &&
              lies_as(rgba5, GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1) &&
              lies_as(TexelFormat::rgb332, GL_RGB, GL_UNSIGNED_BYTE_3_3_2) &&
              lies_as(TexelFormat::z16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT) &&
              lies_as(TexelFormat::z24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT));

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
    case TexelFormat::rgb565:
    case TexelFormat::rgb888:
    case TexelFormat::rgb332:
    case TexelFormat::etc1:
        break;
    }
    return BaseFormat::rgb;
}

unsigned texel_size(TexelFormat format) {
    return static_cast<unsigned>(raster::texel_bytes(raster::sampled(format)));
}

PixelLayout texel_layout(TexelFormat format) {
    const Texel& texel = texels[static_cast<unsigned>(format)];
    PixelLayout layout;
    static_cast<void>(pixel_layout(texel.format, texel.type, layout));
    if (layout.channel[0] == Channel::luminance)
        layout.channel[0] = Channel::red; // a texel's luminance is red only (GL 1.3, table 6.1)
    if (format == TexelFormat::z24)
        layout.bits[0] = 24;
    return layout;
}

unsigned texel_bits(TexelFormat format, Channel channel) {
    // The only compressed format here is ETC1, because for paletted images callers ask for the format of the
    // palette's entries.
    if (SPANGLE_FEATURE_COMPRESSED_TEXTURES && format >= TexelFormat::p4)
        return 8;
    const PixelLayout layout = texel_layout(format);
    for (unsigned i = 0; i < layout.components; ++i)
        if (layout.channel[i] == channel)
            return layout.bits[i];
    return 0;
}

} // namespace spangle::gl

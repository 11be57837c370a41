// GetTexLevelParameter: the parameters of an image or of a proxy (GL 1.3, 6.1.3).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/texture/compressed_format.hpp"
#include "gl/texture/internal_format.hpp"
#include "gl/texture/texture_target.hpp"

namespace spangle::gl {

namespace {

/// Returns the value of a ..._SIZE parameter, which is the number of bits that texels really have. For
/// paletted images it is the number of bits of the palette's entries.
unsigned size_of(const LevelShape& shape, GLenum pname) {
    using raster::BaseFormat;
    if (shape.empty()) // a level without texels has no bits
        return 0;
    if (is_depth(shape.format) || pname == GL_TEXTURE_DEPTH_SIZE)
        return is_depth(shape.format) && pname == GL_TEXTURE_DEPTH_SIZE
                   ? texel_bits(shape.format, Channel::depth)
                   : 0;
    // The function makes a set of the base formats that have a component.
    const auto set = [](auto... bases) constexpr {
        return static_cast<std::uint8_t>(((1u << static_cast<unsigned>(bases)) | ...));
    };
    constexpr std::uint8_t color = set(BaseFormat::rgb, BaseFormat::rgba);
    static constexpr std::uint8_t having[] = {
        color,
        color,
        color,
        set(BaseFormat::alpha, BaseFormat::luminance_alpha, BaseFormat::rgba),
        set(BaseFormat::luminance, BaseFormat::luminance_alpha),
        set(BaseFormat::intensity)};
    static_assert(GL_TEXTURE_GREEN_SIZE - GL_TEXTURE_RED_SIZE == static_cast<int>(Channel::green) &&
                  GL_TEXTURE_BLUE_SIZE - GL_TEXTURE_RED_SIZE == static_cast<int>(Channel::blue) &&
                  GL_TEXTURE_ALPHA_SIZE - GL_TEXTURE_RED_SIZE == static_cast<int>(Channel::alpha) &&
                  GL_TEXTURE_LUMINANCE_SIZE - GL_TEXTURE_RED_SIZE == 4 &&
                  GL_TEXTURE_INTENSITY_SIZE - GL_TEXTURE_RED_SIZE == 5);
    const unsigned of = pname - GL_TEXTURE_RED_SIZE;
    const BaseFormat base = base_format_of(shape.format, shape.internal_format);
    if ((having[of] >> static_cast<unsigned>(base) & 1) == 0)
        return 0;
    return texel_bits(is_palette(shape.internal_format) ? palette_format_of(shape.internal_format)
                                                        : shape.format,
                      of < 4 ? static_cast<Channel>(of) : Channel::red);
}

/// Finds a parameter of a level. Returns false if `pname` is not such a parameter.
bool value_of(const LevelShape& shape, GLenum pname, std::uint32_t& out) {
    switch (pname) {
    case GL_TEXTURE_WIDTH:
    case GL_TEXTURE_HEIGHT:
        static_assert(GL_TEXTURE_HEIGHT - GL_TEXTURE_WIDTH == 1);
        out = shape.size[pname - GL_TEXTURE_WIDTH];
        return true;
    case GL_TEXTURE_DEPTH:
        out = shape.size[2];
        return true;
    case GL_TEXTURE_BORDER:
        out = shape.border;
        return true;
    case GL_TEXTURE_INTERNAL_FORMAT:
        out = shape.internal_format;
        return true;
    case GL_TEXTURE_RED_SIZE:
    case GL_TEXTURE_GREEN_SIZE:
    case GL_TEXTURE_BLUE_SIZE:
    case GL_TEXTURE_ALPHA_SIZE:
    case GL_TEXTURE_LUMINANCE_SIZE:
    case GL_TEXTURE_INTENSITY_SIZE:
    case GL_TEXTURE_DEPTH_SIZE:
        out = size_of(shape, pname);
        return true;
    case GL_TEXTURE_COMPRESSED:
        out = is_compressed(shape.internal_format) ? 1 : 0;
        return true;
    default:
        return false;
    }
}

} // namespace

void cmd::GetTexLevelParameter(Context& context, GLenum target, GLint level, GLenum pname, Params& params) {
    ImageTarget of;
    params.count = 0;
    if (!find_image_target(context, target, 0, of))
        return;
    if (!is_level(level))
        return error(context, GL_INVALID_VALUE,
                     SPANGLE_TEXT("level is above the smallest image of the largest texture"));
    static constexpr LevelShape none{};
    const LevelImage* const image =
        of.proxy ? nullptr : bound_texture(context, of.kind).image(of.face, level);
    const LevelShape& shape = of.proxy           ? context.texture.proxy(of.kind, level)
                              : image != nullptr ? image->shape
                                                 : none;
    std::uint32_t value = 0;
    if (pname == GL_TEXTURE_COMPRESSED_IMAGE_SIZE) {
        if (image == nullptr || !is_compressed(shape.internal_format))
            return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("the image is not compressed"));
        value = palette_bytes(shape.internal_format) + image->bytes;
    } else if (!value_of(shape, pname, value)) {
        return error(context, GL_INVALID_ENUM);
    }
    params.v[0] = Param::from_integer(value);
    params.count = 1;
}

} // namespace spangle::gl

#include "gl/texture/compressed_format.hpp"

#include "gl/texture/internal_format.hpp"

namespace spangle::gl {

std::uint32_t palette_bytes(GLenum internal_format) {
    if (!is_palette(internal_format))
        return 0;
    const std::uint32_t entries = has_small_palette(internal_format) ? 16 : 256;
    return entries * texel_size(palette_format_of(internal_format));
}

std::uint32_t compressed_bytes(GLenum internal_format, std::uint32_t width, std::uint32_t height) {
    if (!is_palette(internal_format))
        return (width + 3) / 4 * ((height + 3) / 4) * 8;
    return has_small_palette(internal_format) ? (width * height + 1) / 2 : width * height;
}

} // namespace spangle::gl

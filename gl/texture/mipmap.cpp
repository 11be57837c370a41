#include "gl/texture/mipmap.hpp"

#include <bit>

#include "gl/api/generated/commands.hpp"
#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"
#include "gl/texture/complete.hpp"
#include "gl/texture/compressed_format.hpp"
#include "gl/texture/halve_row.hpp"
#include "gl/texture/internal_format.hpp"
#include "gl/texture/level_image.hpp"
#include "gl/texture/texture_target.hpp"

namespace spangle::gl {

namespace {

#if SPANGLE_FEATURE_MIPMAP_GENERATION

/// The two texels that texel i of the next level covers. Both levels are counted from the first texel inside
/// the border. Sizes are halved and rounded down, so that the last texel of an odd size has no effect on the
/// next level.
struct CoveredTexels {
    std::int32_t of[2];
    CoveredTexels(std::int32_t i, std::int32_t size, std::int32_t next_size) {
        of[0] = i < 0 ? i : i >= next_size ? size : 2 * i;
        of[1] = of[0] < 0 || of[0] >= size - 1 ? of[0] : of[0] + 1;
    }
};

class LevelReduction {
  public:
    LevelReduction(const LevelImage& from, LevelImage& to)
        : source_level_(from), target_level_(to), layout_(texel_layout(from.shape.format)) {
        for (unsigned axis = 0; axis < 3; ++axis) {
            border_[axis] = static_cast<std::int32_t>(from.shape.border_along(axis));
            size_[axis] = static_cast<std::int32_t>(from.shape.size_without_border(axis));
            target_size_[axis] = static_cast<std::int32_t>(to.shape.size_without_border(axis));
        }
    }
    void run() const {
        for (std::int32_t z = -border_[2]; z < target_size_[2] + border_[2]; ++z)
            for (std::int32_t y = -border_[1]; y < target_size_[1] + border_[1]; ++y)
                row(y, z);
    }

  private:
    void row(std::int32_t y, std::int32_t z) const {
        std::int32_t x = -border_[0];
        if constexpr (has_row_codes) {
            RowHalver halver(layout_);
            if (size_[0] > 1 && halver.works()) {
                for (; x < 0; ++x)
                    texel(x, y, z);
                const CoveredTexels cy(y, size_[1], target_size_[1]), cz(z, size_[2], target_size_[2]);
                const auto at = [&](unsigned i) {
                    return source_level_.texels + place(source_level_, 0, cy.of[i & 1], cz.of[i >> 1]);
                };
                halver.halve({at(0), at(1), at(2), at(3)}, target_size_[0],
                             target_level_.own_texels() + place(target_level_, 0, y, z));
                x = target_size_[0];
            }
        }
        for (; x < target_size_[0] + border_[0]; ++x)
            texel(x, y, z);
    }
    void texel(std::int32_t x, std::int32_t y, std::int32_t z) const {
        const CoveredTexels cx(x, size_[0], target_size_[0]), cy(y, size_[1], target_size_[1]),
            cz(z, size_[2], target_size_[2]);
        const Groups texels(layout_);
        Pixel texel; // each texel that is read, and afterwards the mean
        std::uint32_t sum[4] = {};
        for (unsigned i = 0; i < 8; ++i) {
            texel = texels.color(source_level_.texels +
                                     place(source_level_, cx.of[i & 1], cy.of[i >> 1 & 1], cz.of[i >> 2]),
                                 0);
            for (unsigned c = 0; c < 4; ++c)
                sum[c] += texel.value[c].code;
        }
        for (unsigned c = 0; c < 4; ++c)
            texel.value[c].code = (sum[c] + 4) >> 3;
        pack_pixel(layout_, false, texel, target_level_.own_texels() + place(target_level_, x, y, z));
    }
    std::size_t place(const LevelImage& image, std::int32_t x, std::int32_t y, std::int32_t z) const {
        const auto at = [&](std::int32_t v, unsigned axis) {
            return static_cast<std::size_t>(v + border_[axis]);
        };
        return at(z, 2) * image.slice() + at(y, 1) * image.stride + at(x, 0) * texel_size(image.shape.format);
    }

    const LevelImage& source_level_;
    LevelImage& target_level_;
    PixelLayout layout_;
    std::int32_t border_[3], size_[3], target_size_[3];
};

LevelShape next_shape(const LevelShape& shape) {
    LevelShape next = shape;
    for (unsigned axis = 0; axis < shape.dimensions; ++axis) {
        const std::uint32_t half = shape.size_without_border(axis) / 2;
        next.size[axis] = static_cast<std::uint16_t>((half > 1 ? half : 1) + 2u * shape.border);
    }
    return next;
}

#endif

} // namespace

void generate_mipmaps(Context& context, TextureObject& texture, unsigned face, GLint last) {
#if SPANGLE_FEATURE_MIPMAP_GENERATION
    const GLint base = texture.parameters.base_level;
    const LevelImage* from = is_level(base) ? texture.image(face, base) : nullptr;
    if (from == nullptr || from->shape.empty() || is_compressed(from->shape.internal_format))
        return;
    const auto sides = from->shape.size_without_border(0) | from->shape.size_without_border(1) |
                       from->shape.size_without_border(2);
    const GLint longest = base + static_cast<GLint>(std::bit_width(sides)) - 1;
    const GLint end = last < longest ? last : longest;
    LevelImage* made[texture_levels] = {};
    Arena& arena = context.share->arena;
    for (GLint l = base + 1; l <= end; ++l) {
        made[l] = new_image(arena, next_shape(from->shape));
        if (made[l] == nullptr) {
            for (LevelImage* image : made)
                arena.free(image);
            return error(context, GL_OUT_OF_MEMORY,
                         SPANGLE_TEXT("GL_GENERATE_MIPMAP: no room in the arena for the levels"));
        }
        LevelReduction(*from, *made[l]).run();
        from = made[l];
    }
    for (GLint l = base + 1; l <= end; ++l) {
        discard_image(*context.share, texture.image(face, l));
        texture.image(face, l) = made[l];
    }
    texture_changed(context, texture);
#else
    static_cast<void>(context), static_cast<void>(texture), static_cast<void>(face), static_cast<void>(last);
#endif
}

#if SPANGLE_FEATURE_MIPMAP_GENERATION

namespace cmd {

void GenerateMipmap(Context& context, GLenum target) {
    TextureKind kind;
    if (!find_texture_target(context, target, kind))
        return;
    TextureObject& texture = bound_texture(context, kind);
    if (kind == TextureKind::cube && !is_cube_complete(texture))
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("the six faces are not alike"));
    for (unsigned face = 0; face < texture.faces(); ++face)
        generate_mipmaps(context, texture, face, texture.parameters.max_level);
}

} // namespace cmd

#endif

} // namespace spangle::gl

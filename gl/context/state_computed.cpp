#include "gl/context/state_computed.hpp"

#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"
#include "gl/context/limits.hpp"
#include "gl/texture/compressed_format.hpp"
#include "raster/surface/samples.hpp"

namespace spangle::gl::computed_state {

namespace {

Param integer(std::int32_t value) {
    return Param::from_integer(static_cast<std::uint32_t>(value));
}

} // namespace

void matrix(const Context& context, GLenum name, Param* out) {
    const Matrix16 top = top_matrix(context, name);
    for (int i = 0; i < 16; ++i)
        out[i] = Param::from(top.m[i]);
}

/// Tokens of plain and of transposed matrices have the same order.
void transposed_matrix(const Context& context, GLenum name, Param* out) {
    const Matrix16 top = top_matrix(context, name - GL_TRANSPOSE_MODELVIEW_MATRIX + GL_MODELVIEW_MATRIX);
    for (int i = 0; i < 16; ++i)
        out[i] = Param::from(top.m[i / 4 + i % 4 * 4]);
}

void depth_of_stack(const Context& context, GLenum name, Param* out) {
    out[0] = integer(stack_depth(context, name));
}

void element_limit(const Context&, GLenum, Param* out) {
    out[0] = integer(65536);
}

void viewport_limits(const Context&, GLenum, Param* out) {
    out[0] = out[1] = integer(max_viewport_dim);
}

void render_mode(const Context& context, GLenum, Param* out) {
    out[0] = Param::from_integer(context.render.mode);
}

void saved_depth(const Context& context, GLenum name, Param* out) {
    out[0] = integer(saved_attributes(context, name == GL_CLIENT_ATTRIB_STACK_DEPTH));
}

#if SPANGLE_FEATURE_BUFFERS
void buffer_binding(const Context& context, GLenum name, Param* out) {
    out[0] = Param::from_integer(bound_buffer(context, name));
}
#endif

void size_range(const Context&, GLenum name, Param* out) {
    const bool point = name == GL_POINT_SIZE_RANGE || name == GL_ALIASED_POINT_SIZE_RANGE;
    out[0] = integer(1);
    out[1] = integer(point ? max_point_size : max_line_width);
}

/// Returns the granularity of point sizes and line widths: 1/8 pixel with antialiasing, else 1 pixel.
void size_granularity(const Context&, GLenum, Param* out) {
    constexpr Real eighth = numeric::from_float(0.125f);
    out[0] = Param::from(SPANGLE_FEATURE_ANTIALIASING ? eighth : numeric::one);
}

void binding(const Context& context, GLenum name, Param* out) {
    const TextureKind kind = name == GL_TEXTURE_BINDING_1D   ? TextureKind::one
                             : name == GL_TEXTURE_BINDING_2D ? TextureKind::two
                             : name == GL_TEXTURE_BINDING_3D ? TextureKind::three
                                                             : TextureKind::cube;
    out[0] = Param::from_integer(texture_binding(context, kind));
}

void compressed_texture_formats(const Context&, GLenum, Param* out) {
    for (unsigned i = 0; i < palette_formats; ++i)
        out[i] = Param::from_integer(first_palette_format + i);
    out[palette_formats] = Param::from_integer(GL_ETC1_RGB8_OES);
}

void active_unit(const Context& context, GLenum name, Param* out) {
    out[0] =
        Param::from_integer(GL_TEXTURE0 + (name == GL_ACTIVE_TEXTURE ? context.texture.active
                                                                     : context.array_bindings.client_active));
}

#if SPANGLE_FEATURE_PIXEL_TRANSFER
void size_of_pixel_map(const Context& context, GLenum name, Param* out) {
    out[0] = integer(pixel_map_size(context, name));
}
#endif

void index_mode(const Context& context, GLenum name, Param* out) {
    const std::int32_t index_bits = context.drawable.index_bits;
    out[0] = integer(name == GL_INDEX_BITS                          ? index_bits
                     : (index_bits != 0) == (name == GL_INDEX_MODE) ? 1
                                                                    : 0);
}

void bits(const Context& context, GLenum name, Param* out) {
    const raster::Surface& surface = context.drawable.surface;
    const FormatInfo& format = raster::drawn_info(surface.format);
    const std::uint8_t colors[] = {format.red_bits, format.green_bits, format.blue_bits, format.alpha_bits};
    if (name == GL_DEPTH_BITS)
        out[0] = integer(surface.depth_format == DepthFormat::none  ? 0
                         : surface.depth_format == DepthFormat::z16 ? 16
                                                                    : 24);
    else if (name == GL_STENCIL_BITS)
        out[0] = integer(surface.depth_format == DepthFormat::z24s8 ? 8 : 0);
    else
        out[0] = integer(colors[name - GL_RED_BITS]);
    static_assert(GL_GREEN_BITS - GL_RED_BITS == 1 && GL_BLUE_BITS - GL_RED_BITS == 2 &&
                  GL_ALPHA_BITS - GL_RED_BITS == 3);
}

void samples(const Context& context, GLenum name, Param* out) {
    const bool has = context.drawable.surface.samples != nullptr;
    out[0] = integer(!has ? 0 : name == GL_SAMPLE_BUFFERS ? 1 : std::int32_t{raster::sample_count});
}

void accum_bits(const Context& context, GLenum, Param* out) {
    out[0] = integer(context.drawable.surface.accum != nullptr ? 16 : 0);
}

} // namespace spangle::gl::computed_state

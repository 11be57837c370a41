// Fog, hints, pixel storage, Flush and Finish (GL 1.3, 3.10, 5.6, 3.6.1, 5.5).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/features.hpp"
#include "gl/context/tokens.hpp"

namespace spangle::gl::cmd {

#if SPANGLE_FEATURE_FOG
void Fog(Context& context, GLenum pname, const Params& params) {
    if (params.count == 0)
        return error(context, GL_INVALID_ENUM);
    FogState& fog = context.fog;
    const Real value = params.v[0].real();
    switch (pname) {
    case GL_FOG_MODE: {
        const GLenum mode = params.v[0].token();
        if (!is_in(fog_modes, mode))
            return error(context, GL_INVALID_ENUM);
        fog.mode = mode;
        break;
    }
    case GL_FOG_DENSITY:
        if (value < numeric::zero)
            return error(context, GL_INVALID_VALUE);
        fog.density = value;
        break;
    case GL_FOG_START:
        fog.start = value;
        break;
    case GL_FOG_END:
        fog.end = value;
        break;
    case GL_FOG_INDEX:
        fog.index = value;
        break;
    case GL_FOG_COORDINATE_SOURCE: {
        const GLenum source = params.v[0].token();
        if (source != GL_FRAGMENT_DEPTH && source != GL_FOG_COORDINATE)
            return error(context, GL_INVALID_ENUM);
        fog.source = source;
        break;
    }
    case GL_FOG_COLOR:
        for (int c = 0; c < 4; ++c)
            fog.color[c] = numeric::clamp01(params.v[c].real());
        break;
    default:
        return error(context, GL_INVALID_ENUM);
    }
    context.changed(dirty_fragment);
}
#endif

namespace {

/// Returns the HintIndex of a target of Hint, or `hints` for a token that is no target.
unsigned hint_of(GLenum target) {
    if (target == GL_TEXTURE_COMPRESSION_HINT)
        return hint_texture_compression;
#if SPANGLE_FEATURE_MIPMAP_GENERATION
    if (target == GL_GENERATE_MIPMAP_HINT)
        return hint_generate_mipmap;
#endif
    static_assert(GL_POINT_SMOOTH_HINT - GL_PERSPECTIVE_CORRECTION_HINT == hint_point_smooth &&
                  GL_LINE_SMOOTH_HINT - GL_PERSPECTIVE_CORRECTION_HINT == hint_line_smooth &&
                  GL_POLYGON_SMOOTH_HINT - GL_PERSPECTIVE_CORRECTION_HINT == hint_polygon_smooth &&
                  GL_FOG_HINT - GL_PERSPECTIVE_CORRECTION_HINT == hint_fog);
    const unsigned place = target - GL_PERSPECTIVE_CORRECTION_HINT;
    return place <= hint_fog ? place : hints;
}

} // namespace

void Hint(Context& context, GLenum target, GLenum mode) {
    if (mode != GL_FASTEST && mode != GL_NICEST && mode != GL_DONT_CARE)
        return error(context, GL_INVALID_ENUM);
    const unsigned hint = hint_of(target);
    if (hint == hints)
        return error(context, GL_INVALID_ENUM);
    context.hint.mode[hint] = mode;
    context.changed(dirty_fragment);
}

void PixelStore(Context& context, GLenum pname, const Params& params) {
    static constexpr GLint gl::PixelStore::*numbers[] = {
        &gl::PixelStore::row_length, &gl::PixelStore::skip_rows,    &gl::PixelStore::skip_pixels,
        &gl::PixelStore::alignment,  &gl::PixelStore::image_height, &gl::PixelStore::skip_images};
    const bool later = pname >= GL_PACK_SKIP_IMAGES; // tokens for volumes do not follow the other tokens
    const bool pack = later ? pname <= GL_PACK_IMAGE_HEIGHT : pname >= GL_PACK_SWAP_BYTES;
    const GLenum first = later ? GL_PACK_SKIP_IMAGES : pack ? GL_PACK_SWAP_BYTES : GL_UNPACK_SWAP_BYTES;
    const GLenum place = pname - first;
    if (params.count == 0 || place > (later ? 3u : 5u))
        return error(context, GL_INVALID_ENUM);
    const GLenum index = later ? 7 - (place & 1) : place;
    gl::PixelStore& store = pack ? context.pixel_store.pack : context.pixel_store.unpack;
    if (index < 2) {
        (index == 0 ? store.swap_bytes : store.lsb_first) = numeric::to_bool(params.v[0].real());
        return;
    }
    const GLint value = params.v[0].integer();
    const bool is_alignment = index == GL_PACK_ALIGNMENT - GL_PACK_SWAP_BYTES;
    if (is_alignment ? value != 1 && value != 2 && value != 4 && value != 8 : value < 0)
        return error(context, GL_INVALID_VALUE);
    store.*numbers[index - 2] = value;
}

// Every command is complete when it returns. Flush only has to show the surface of a window without a back
// buffer; SwapBuffers shows other windows.
void Flush(Context& context) {
    if (context.drawable.show != nullptr)
        context.drawable.show(false);
}

void Finish(Context& context) {
    if (context.drawable.show != nullptr)
        context.drawable.show(true);
}

} // namespace spangle::gl::cmd

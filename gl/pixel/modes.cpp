// Fog, hints, pixel storage, Flush and Finish (GL 1.3, 3.10, 5.6, 3.6.1, 5.5).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/features.hpp"

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
        if (mode != GL_EXP && mode != GL_EXP2 && mode != GL_LINEAR)
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

void Hint(Context& context, GLenum target, GLenum mode) {
    if (mode != GL_FASTEST && mode != GL_NICEST && mode != GL_DONT_CARE)
        return error(context, GL_INVALID_ENUM);
    switch (target) {
    case GL_PERSPECTIVE_CORRECTION_HINT:
        context.hint.perspective_correction = mode;
        break;
    case GL_POINT_SMOOTH_HINT:
        context.hint.point_smooth = mode;
        break;
    case GL_LINE_SMOOTH_HINT:
        context.hint.line_smooth = mode;
        break;
    case GL_POLYGON_SMOOTH_HINT:
        context.hint.polygon_smooth = mode;
        break;
    case GL_FOG_HINT:
        context.hint.fog = mode;
        break;
    case GL_TEXTURE_COMPRESSION_HINT:
        context.hint.texture_compression = mode;
        break;
    default:
        return error(context, GL_INVALID_ENUM);
    }
    context.changed(dirty_fragment);
}

void PixelStore(Context& context, GLenum pname, const Params& params) {
    if (params.count == 0)
        return error(context, GL_INVALID_ENUM);
    const bool pack = pname == GL_PACK_IMAGE_HEIGHT || pname == GL_PACK_SKIP_IMAGES ||
                      (pname >= GL_PACK_SWAP_BYTES && pname <= GL_PACK_ALIGNMENT);
    gl::PixelStore& store = pack ? context.pixel_store.pack : context.pixel_store.unpack;
    const GLint value = params.v[0].integer();
    GLint* number = nullptr;
    switch (pname) {
    case GL_UNPACK_SWAP_BYTES:
    case GL_PACK_SWAP_BYTES:
        store.swap_bytes = numeric::to_bool(params.v[0].real());
        return;
    case GL_UNPACK_LSB_FIRST:
    case GL_PACK_LSB_FIRST:
        store.lsb_first = numeric::to_bool(params.v[0].real());
        return;
    case GL_UNPACK_ALIGNMENT:
    case GL_PACK_ALIGNMENT:
        if (value != 1 && value != 2 && value != 4 && value != 8)
            return error(context, GL_INVALID_VALUE);
        store.alignment = value;
        return;
    case GL_UNPACK_ROW_LENGTH:
    case GL_PACK_ROW_LENGTH:
        number = &store.row_length;
        break;
    case GL_UNPACK_SKIP_ROWS:
    case GL_PACK_SKIP_ROWS:
        number = &store.skip_rows;
        break;
    case GL_UNPACK_SKIP_PIXELS:
    case GL_PACK_SKIP_PIXELS:
        number = &store.skip_pixels;
        break;
    case GL_UNPACK_IMAGE_HEIGHT:
    case GL_PACK_IMAGE_HEIGHT:
        number = &store.image_height;
        break;
    case GL_UNPACK_SKIP_IMAGES:
    case GL_PACK_SKIP_IMAGES:
        number = &store.skip_images;
        break;
    default:
        return error(context, GL_INVALID_ENUM);
    }
    if (value < 0)
        return error(context, GL_INVALID_VALUE);
    *number = value;
}

// Every command has reached the surface when it returns. A window with a back buffer shows it at SwapBuffers,
// one without here.
void Flush(Context& context) {
    if (context.drawable.show != nullptr)
        context.drawable.show(false);
}

void Finish(Context& context) {
    if (context.drawable.show != nullptr)
        context.drawable.show(true);
}

} // namespace spangle::gl::cmd

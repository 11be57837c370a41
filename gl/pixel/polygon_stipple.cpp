// PolygonStipple and GetPolygonStipple (GL 1.3, 3.5.2 and 6.1.5).
#include "gl/pixel/polygon_stipple.hpp"

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/pixel/pixel_layout.hpp"

#if SPANGLE_FEATURE_STIPPLE

namespace spangle::gl {

namespace {

constexpr unsigned side = 32;

/// Calls visit(y, x, byte, mask) for each bit of the image.
template <class Byte, class Visit> void each_bit(const PixelStore& store, Byte* image, Visit visit) {
    PixelLayout layout;
    layout.kind = ElementKind::bitmap;
    const ImageRows rows = image_rows(store, layout, side);
    for (unsigned y = 0; y < side; ++y) {
        Byte* const row = image + rows.skip + y * rows.stride;
        for (unsigned x = 0; x < side; ++x) {
            const unsigned bit = rows.skip_bits + x;
            visit(y, x, row[bit / 8], store.lsb_first ? 1u << bit % 8 : 0x80u >> bit % 8);
        }
    }
}

} // namespace

StipplePattern unpack_stipple(const PixelStore& store, const void* image) {
    StipplePattern pattern;
    each_bit(store, static_cast<const unsigned char*>(image),
             [&](unsigned y, unsigned x, unsigned char byte, unsigned mask) {
                 if ((byte & mask) == 0)
                     pattern.row[y] &= ~(1u << x);
             });
    return pattern;
}

void pack_stipple(const PixelStore& store, const StipplePattern& pattern, void* image) {
    each_bit(store, static_cast<unsigned char*>(image),
             [&](unsigned y, unsigned x, unsigned char& byte, unsigned mask) {
                 const bool on = (pattern.row[y] >> x & 1) != 0;
                 byte = static_cast<unsigned char>(on ? byte | mask : byte & ~mask);
             });
}

namespace cmd {

void PolygonStipple(Context& context, const GLubyte* pattern) {
    if (pattern == nullptr)
        return error(context, GL_INVALID_VALUE);
    context.polygon.stipple = unpack_stipple(context.pixel_store.unpack, pattern);
    context.changed(dirty_fragment); // recorded primitives keep the old pattern
}

void GetPolygonStipple(Context& context, GLubyte* pattern) {
    if (pattern == nullptr)
        return error(context, GL_INVALID_VALUE);
    pack_stipple(context.pixel_store.pack, context.polygon.stipple, pattern);
}

} // namespace cmd

} // namespace spangle::gl

#endif

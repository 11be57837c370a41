#include "gl/pixel/row_fields.hpp"

#if SPANGLE_ROW_CODES

namespace spangle::gl {

namespace {

void place(GroupFields& fields, Channel channel, GroupField field) {
    if (channel == Channel::luminance)
        fields.field[0] = fields.field[1] = fields.field[2] = field;
    else
        fields.field[static_cast<unsigned>(channel)] = field;
}

} // namespace

GroupFields fields_of(const PixelLayout& layout, bool swap_bytes) {
    GroupFields fields;
    if (layout.kind != ElementKind::unsigned_integer)
        return fields;
    for (unsigned i = 0; i < layout.components; ++i) {
        const std::uint8_t bits = layout.bits[i];
        const bool bytes_only =
            layout.element_bytes == 1 || (layout.packed && (bits == 8 || layout.element_bytes == 2));
        if (layout.channel[i] > Channel::luminance || bits > 8 || !bytes_only)
            return fields;
        unsigned shift = layout.packed ? layout.shift[i] : 8 * i;
        if (swap_bytes && layout.element_bytes == 4)
            shift = 24 - shift;
        place(fields, layout.channel[i], {static_cast<std::uint8_t>(shift), bits});
    }
    fields.bytes = static_cast<std::uint8_t>(layout.group_bytes());
    fields.swapped = swap_bytes && layout.element_bytes == 2;
    return fields;
}

GroupFields fields_of(PixelFormat surface) {
    switch (raster::drawn(surface)) {
    case PixelFormat::rgb565_be:
        return {2, true, false, {{11, 5}, {5, 6}, {0, 5}}};
    case PixelFormat::rgb565_le:
        return {2, false, false, {{11, 5}, {5, 6}, {0, 5}}};
    case PixelFormat::rgb888:
        return {3, false, false, {{0, 8}, {8, 8}, {16, 8}}};
    case PixelFormat::rgba8888:
        return {4, false, false, {{0, 8}, {8, 8}, {16, 8}, {24, 8}}};
    case PixelFormat::rgb666:
        return {3, false, false, {{2, 6}, {10, 6}, {18, 6}}};
    case PixelFormat::rgb444:
        return {2, false, false, {{8, 4}, {4, 4}, {0, 4}}};
    case PixelFormat::rgb332:
        return {1, false, false, {{5, 3}, {2, 3}, {0, 2}}};
    case PixelFormat::grey4:
        return {2, false, false, {{0, 4}, {0, 4}, {0, 4}}};
    case PixelFormat::mono:
        return {2, false, false, {{0, 1}, {0, 1}, {0, 1}}};
    case PixelFormat::index8:
        break;
    }
    return {};
}

} // namespace spangle::gl

#endif

// Rows of pixel storage, transfer and maps (GL 1.3, tables 6.19 to 6.21).
#pragma once

#include "gl/context/state_row.hpp"

// Builds without an optional system may have no member for its state.
#if SPANGLE_FEATURE_PIXEL_TRANSFER
#define TRANSFER_ROW(NAME, MEMBER) STORED(NAME, pixel_mode.MEMBER)
#define PIXEL_MAP(NAME)                                                                                      \
    computed<computed_state::size_of_pixel_map>(GL_PIXEL_MAP_##NAME##_SIZE, Kind::integer, 1)
#else
#define TRANSFER_ROW(NAME, MEMBER) of_pixel_transfer(constant(NAME, 0))
#define PIXEL_MAP(NAME) of_pixel_transfer(constant(GL_PIXEL_MAP_##NAME##_SIZE, 1))
#endif
#if SPANGLE_FEATURE_DRAW_PIXELS
#define ZOOM_ROW(NAME, MEMBER) STORED(NAME, pixel_mode.MEMBER)
#else
#define ZOOM_ROW(NAME, MEMBER) of_draw_pixels(constant(NAME, 1))
#endif

namespace spangle::gl {

inline constexpr auto pixel_rows = std::to_array<WrittenRow>({
    in(Group::client_pixel_store),
    STORED(GL_UNPACK_SWAP_BYTES, pixel_store.unpack.swap_bytes),
    STORED(GL_UNPACK_LSB_FIRST, pixel_store.unpack.lsb_first),
    STORED(GL_UNPACK_IMAGE_HEIGHT, pixel_store.unpack.image_height),
    STORED(GL_UNPACK_SKIP_IMAGES, pixel_store.unpack.skip_images),
    STORED(GL_UNPACK_ROW_LENGTH, pixel_store.unpack.row_length),
    STORED(GL_UNPACK_SKIP_ROWS, pixel_store.unpack.skip_rows),
    STORED(GL_UNPACK_SKIP_PIXELS, pixel_store.unpack.skip_pixels),
    STORED(GL_UNPACK_ALIGNMENT, pixel_store.unpack.alignment),
    STORED(GL_PACK_SWAP_BYTES, pixel_store.pack.swap_bytes),
    STORED(GL_PACK_LSB_FIRST, pixel_store.pack.lsb_first),
    STORED(GL_PACK_IMAGE_HEIGHT, pixel_store.pack.image_height),
    STORED(GL_PACK_SKIP_IMAGES, pixel_store.pack.skip_images),
    STORED(GL_PACK_ROW_LENGTH, pixel_store.pack.row_length),
    STORED(GL_PACK_SKIP_ROWS, pixel_store.pack.skip_rows),
    STORED(GL_PACK_SKIP_PIXELS, pixel_store.pack.skip_pixels),
    STORED(GL_PACK_ALIGNMENT, pixel_store.pack.alignment),
    in(Group::pixel_mode),
    STORED(GL_READ_BUFFER, fragment_ops.read_buffer),
    TRANSFER_ROW(GL_MAP_COLOR, map_color),
    TRANSFER_ROW(GL_MAP_STENCIL, map_stencil),
    TRANSFER_ROW(GL_INDEX_SHIFT, index_shift),
    TRANSFER_ROW(GL_INDEX_OFFSET, index_offset),
    TRANSFER_ROW(GL_RED_SCALE, linear[0].scale),
    TRANSFER_ROW(GL_GREEN_SCALE, linear[1].scale),
    TRANSFER_ROW(GL_BLUE_SCALE, linear[2].scale),
    TRANSFER_ROW(GL_ALPHA_SCALE, linear[3].scale),
    TRANSFER_ROW(GL_RED_BIAS, linear[0].bias),
    TRANSFER_ROW(GL_GREEN_BIAS, linear[1].bias),
    TRANSFER_ROW(GL_BLUE_BIAS, linear[2].bias),
    TRANSFER_ROW(GL_ALPHA_BIAS, linear[3].bias),
    TRANSFER_ROW(GL_DEPTH_SCALE, linear[4].scale),
    TRANSFER_ROW(GL_DEPTH_BIAS, linear[4].bias),
    ZOOM_ROW(GL_ZOOM_X, zoom[0]),
    ZOOM_ROW(GL_ZOOM_Y, zoom[1]),
    in(Group::none),
    PIXEL_MAP(I_TO_I),
    PIXEL_MAP(S_TO_S),
    PIXEL_MAP(I_TO_R),
    PIXEL_MAP(I_TO_G),
    PIXEL_MAP(I_TO_B),
    PIXEL_MAP(I_TO_A),
    PIXEL_MAP(R_TO_R),
    PIXEL_MAP(G_TO_G),
    PIXEL_MAP(B_TO_B),
    PIXEL_MAP(A_TO_A),
    of_pixel_transfer(constant(GL_MAX_PIXEL_MAP_TABLE, max_pixel_map_table)),
});

#undef TRANSFER_ROW
#undef PIXEL_MAP
#undef ZOOM_ROW

} // namespace spangle::gl

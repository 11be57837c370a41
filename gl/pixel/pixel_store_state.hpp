// How pixels lie in client memory (GL 1.3, 3.6.1 and 4.3.2). PixelStore sets these values, which are client
// state.
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct PixelStore {
    bool swap_bytes = false;
    bool lsb_first = false;
    GLint row_length = 0, skip_rows = 0, skip_pixels = 0, alignment = 4;
    GLint skip_images = 0, image_height = 0;
};

struct PixelStoreState {
    PixelStore unpack, pack;
};

} // namespace spangle::gl

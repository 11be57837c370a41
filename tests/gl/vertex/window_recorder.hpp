// Records what GL hands to the rasterizer: vertices in window space, before they become pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/span/vertex.hpp"

namespace spangle::test {

struct Primitive {
    int corners = 0; ///< 1: point, 2: line, 3: triangle
    raster::FixedVertex corner[3];
    raster::FixedVertex provoking;
    std::int32_t size = 0;  ///< size of a point, or width of a line
    std::int64_t area2 = 0; ///< twice the signed area of a triangle, as GL tells it
};

/// While it exists, a recorder lists the program's primitives in place of drawing them. Only one may exist at
/// a time.
class WindowRecorder {
  public:
    WindowRecorder();
    ~WindowRecorder();
    WindowRecorder(const WindowRecorder&) = delete;
    WindowRecorder& operator=(const WindowRecorder&) = delete;

    std::vector<Primitive> primitives;
};

} // namespace spangle::test

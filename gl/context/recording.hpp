// A drawable whose frame is larger than memory. Drawing is recorded, and replayed later band by band.
#pragma once

#include <cstdint>

#include "gl/context/features.hpp"
#include "raster/surface/surface.hpp"

namespace spangle::raster {
class Record;
}

namespace spangle::gl {

struct Recording {
    raster::Record* record;
    /// Returns the drawable with the band that holds row y, as the record has drawn it so far. The result is
    /// valid until the next call or the next draw. Its area is empty if the band cannot be drawn.
    raster::Surface (*rows)(std::int32_t y);
    /// Counts the fragments of recorded primitives, if fragments are counted.
    void (*count)();
};

} // namespace spangle::gl

// A drawable of which memory holds no whole frame: what is drawn is recorded, and drawn later, band by band.
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
    /// The drawable with row y, and others beside it, as what was recorded makes it: until this is called
    /// again, or anything is drawn. Its area is empty where that cannot be had.
    raster::Surface (*rows)(std::int32_t y);
    /// What was recorded is counted, as far as somebody counts it.
    void (*count)();
};

} // namespace spangle::gl

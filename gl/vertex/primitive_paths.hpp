// Chooses the code that draws triangles, quads and lines.
#pragma once

#include <spangle/raster/limits.hpp>

#if SPANGLE_SHORTCUTS
#include "gl/vertex/speed/primitive_paths.hpp"
#else
#include "gl/vertex/size/primitive_paths.hpp"
#endif

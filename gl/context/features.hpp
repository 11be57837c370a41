// The optional systems of a build (design 5). CMake defines them; a build by hand has everything.
#pragma once

#include <spangle/raster/features.hpp>

#ifndef SPANGLE_FEATURE_LISTS
#define SPANGLE_FEATURE_LISTS 1
#endif
#ifndef SPANGLE_FEATURE_LIGHTING
#define SPANGLE_FEATURE_LIGHTING 1
#endif
#ifndef SPANGLE_FEATURE_FOG
#define SPANGLE_FEATURE_FOG 1
#endif
#ifndef SPANGLE_FEATURE_POLYGON_MODE
#define SPANGLE_FEATURE_POLYGON_MODE 1
#endif
#ifndef SPANGLE_FEATURE_COLOR_INDEX
#define SPANGLE_FEATURE_COLOR_INDEX 1
#endif
#ifndef SPANGLE_FEATURE_STENCIL_SIDES
#define SPANGLE_FEATURE_STENCIL_SIDES 1
#endif
#ifndef SPANGLE_FEATURE_ATTRIB_STACKS
#define SPANGLE_FEATURE_ATTRIB_STACKS 1
#endif
#ifndef SPANGLE_FEATURE_SELECTION
#define SPANGLE_FEATURE_SELECTION 1
#endif
#ifndef SPANGLE_FEATURE_FEEDBACK
#define SPANGLE_FEATURE_FEEDBACK 1
#endif
#ifndef SPANGLE_FEATURE_EVALUATORS
#define SPANGLE_FEATURE_EVALUATORS 1
#endif
#ifndef SPANGLE_FEATURE_FIXED_POINT
#define SPANGLE_FEATURE_FIXED_POINT 1
#endif
#ifndef SPANGLE_FEATURE_TEXGEN
#define SPANGLE_FEATURE_TEXGEN 1
#endif
#ifndef SPANGLE_FEATURE_RASTER_POS
#define SPANGLE_FEATURE_RASTER_POS 1
#endif
#ifndef SPANGLE_FEATURE_PIXEL_TRANSFER
#define SPANGLE_FEATURE_PIXEL_TRANSFER 1
#endif
#ifndef SPANGLE_FEATURE_BUFFERS
#define SPANGLE_FEATURE_BUFFERS 1
#endif
#ifndef SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS
#define SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS 1
#endif
#ifndef SPANGLE_FEATURE_PRIMITIVE_RESTART
#define SPANGLE_FEATURE_PRIMITIVE_RESTART 1
#endif
#ifndef SPANGLE_FEATURE_CLIP_PLANES
#define SPANGLE_FEATURE_CLIP_PLANES 1
#endif
#ifndef SPANGLE_FEATURE_GET_PROC_ADDRESS
#define SPANGLE_FEATURE_GET_PROC_ADDRESS 1
#endif

/// Texture units, 1 or 2; GL 1.3 asks for 2.
#ifndef SPANGLE_TEXTURE_UNITS
#define SPANGLE_TEXTURE_UNITS 2
#endif

/// How many vertices of array draws are kept for indices that come again, about 120 bytes each; at least 1. A
/// strip finds the vertices that it shares with the strip before it when both their rows fit less a few.
#ifndef SPANGLE_VERTEX_CACHE
#ifdef SPANGLE_FIRMWARE
#define SPANGLE_VERTEX_CACHE 80
#else
#define SPANGLE_VERTEX_CACHE 128
#endif
#endif

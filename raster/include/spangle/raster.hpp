// The rasterizer without GL: window-space triangles, lines and points into memory a display takes. Integers
// only, no heap, no state of its own; its fragments go through the operations of GL.
//
//     Surface surface;                                  // memory, strides, formats
//     clear(surface, {.area = {0, 0, 320, 240}, .channels = 0xF});
//     const Rasterizer draw(whole(surface), surface);   // the state, compiled once
//     draw.triangle(at(10, 10), at(200, 30), at(90, 220));
#pragma once

#include <spangle/format.hpp>
#include <spangle/raster/clear.hpp>
#include <spangle/raster/fragment_state.hpp>
#include <spangle/raster/rasterizer.hpp>
#include <spangle/raster/surface.hpp>
#include <spangle/raster/units.hpp>
#include <spangle/raster/vertex.hpp>

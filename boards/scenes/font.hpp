// A 5x7 font of the characters of dashboards, as an 8-bit alpha texture of 8x8 cells, 16 cells a row.
#pragma once

#include "boards/scenes/gl.hpp"

namespace spangle::scenes {

/// Makes and binds the 128x32 GL_ALPHA texture of the font.
void make_font();

/// Draws a quad for each character. A pixel of the font is `scale` pixels wide, and the top left corner of
/// the text is (x, y), with y down. Call it outside of glBegin/glEnd, with the font's texture bound and
/// enabled.
void draw_text(float x, float y, float scale, const char* text);

/// Draws a point for each pixel of the text, whose top left point is (x, y), with y down. Call it outside of
/// glBegin/glEnd, without textures.
void plot_text(int x, int y, const char* text);

} // namespace spangle::scenes

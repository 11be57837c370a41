// A 5x7 font of what dashboards write, as an 8-bit alpha texture: 16 glyphs a row in cells of 8x8.
#pragma once

#include "boards/scenes/gl.hpp"

namespace spangle::scenes {

/// Makes and binds the 128x32 GL_ALPHA texture of the font.
void make_font();

/// Two triangles' worth of quad per character, `scale` pixels per font pixel, top left corner at (x, y), y
/// down. Inside no Begin/End; the font texture is bound and enabled.
void draw_text(float x, float y, float scale, const char* text);

/// A point for each pixel of the text, top left one at (x, y), y down. Inside no Begin/End; without textures.
void plot_text(int x, int y, const char* text);

} // namespace spangle::scenes

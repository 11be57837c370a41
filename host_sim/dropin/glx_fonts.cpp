// glXUseXFont: makes display lists of Bitmap commands from the glyphs of an X font (GLX 1.4, 3.3.11).
#include <vector>

#include <spangle/GL/gl.h>

#include "host_sim/dropin/glx.hpp"

using namespace spangle::dropin::glx;

namespace {

/// Draws glyphs, one at a time, into a pixmap of one bit a pixel.
class Glyphs {
  public:
    Glyphs(Display* display, Font font) : display_(display), font_(font) {}

    /// The glyph as rows of bits, the lowest row first, as Bitmap takes them.
    std::vector<GLubyte> bits(int character, int left, int ascent, int width, int height) const {
        const Window root = DefaultRootWindow(display_);
        const auto w = static_cast<unsigned>(width), h = static_cast<unsigned>(height);
        const Pixmap pixmap = XCreatePixmap(display_, root, w, h, 1);
        XGCValues values = {};
        values.font = font_;
        const GC gc = XCreateGC(display_, pixmap, GCFont, &values);
        XSetForeground(display_, gc, 0);
        XFillRectangle(display_, pixmap, gc, 0, 0, w, h);
        XSetForeground(display_, gc, 1);
        const XChar2b text = {static_cast<unsigned char>(character >> 8),
                              static_cast<unsigned char>(character)};
        XDrawString16(display_, pixmap, gc, -left, ascent, &text, 1);
        XImage* const image = XGetImage(display_, pixmap, 0, 0, w, h, 1, XYPixmap);
        const std::size_t row = (static_cast<std::size_t>(width) + 7) / 8;
        std::vector<GLubyte> out(row * static_cast<std::size_t>(height));
        for (int y = 0; image != nullptr && y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (XGetPixel(image, x, y) != 0)
                    out[row * static_cast<std::size_t>(height - 1 - y) + static_cast<std::size_t>(x / 8)] |=
                        static_cast<GLubyte>(0x80 >> x % 8);
        if (image != nullptr)
            XDestroyImage(image);
        XFreeGC(display_, gc);
        XFreePixmap(display_, pixmap);
        return out;
    }

  private:
    Display* display_;
    Font font_;
};

/// The metrics of a character; all are zero where the font lacks the character.
XCharStruct metrics(XFontStruct& font, int character) {
    const auto c = static_cast<unsigned>(character);
    const unsigned row = c >> 8, column = c & 255;
    if (row < font.min_byte1 || row > font.max_byte1 || column < font.min_char_or_byte2 ||
        column > font.max_char_or_byte2)
        return {};
    if (font.per_char == nullptr)
        return font.max_bounds;
    const unsigned columns = font.max_char_or_byte2 - font.min_char_or_byte2 + 1;
    return font.per_char[(row - font.min_byte1) * columns + column - font.min_char_or_byte2];
}

void compile(GLuint list, const XCharStruct& c, const std::vector<GLubyte>& bits) {
    const int width = c.rbearing - c.lbearing, height = c.ascent + c.descent;
    glNewList(list, GL_COMPILE);
    glBitmap(width > 0 ? width : 0, height > 0 ? height : 0, static_cast<GLfloat>(-c.lbearing),
             static_cast<GLfloat>(c.descent), static_cast<GLfloat>(c.width), 0.0f,
             bits.empty() ? nullptr : bits.data());
    glEndList();
}

} // namespace

extern "C" {
void glXUseXFont(Font font, int first, int count, int list) {
    Display* const display = glXGetCurrentDisplay();
    if (display == nullptr)
        return;
    XFontStruct* const found = XQueryFont(display, font);
    if (found == nullptr)
        return report_core(display, BadFont, Request::use_x_font, font);
    glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_FALSE);
    glPixelStorei(GL_UNPACK_LSB_FIRST, GL_FALSE);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const Glyphs glyphs(display, font);
    for (int i = 0; i < count; ++i) {
        const XCharStruct c = metrics(*found, first + i);
        const int width = c.rbearing - c.lbearing, height = c.ascent + c.descent;
        const bool seen = width > 0 && height > 0;
        compile(static_cast<GLuint>(list + i), c,
                seen ? glyphs.bits(first + i, c.lbearing, c.ascent, width, height) : std::vector<GLubyte>());
    }
    glPopClientAttrib();
    XFreeFontInfo(nullptr, found, 1);
}
}

#include "tests/gl/api/command_seeds.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <random>
#include <string_view>
#include <utility>

#include <spangle/GL/gl.h>

#include "tests/gl/api/command_bands.hpp"
#include "tests/gl/api/command_stream.hpp"
#include "tests/gl/api/command_table.hpp"

namespace spangle::test {
namespace {

/// Writes calls as run_command_stream() reads them; arguments that do not matter are random.
class Writer {
  public:
    /// `plain` means the balanced tier on RGB565 with 16 bits of depth, as boards have it. `bands` means a
    /// window, drawn whole and in bands.
    Writer(unsigned seed, bool plain, bool bands) : random_(seed) {
        if (bands) {
            // The first byte chooses the tier, and whether bands are redrawn or recorded.
            put(first_of_bands + lot(256 - first_of_bands));
            for (int i = 0; i < 5; ++i)
                put(lot(256)); // one byte for depth, format, samples, height and record
            return;
        }
        for (const unsigned byte : {1u, 0u, 0u, 1u}) // bytes for tier, depth, format and direction
            put(plain ? byte : lot(first_of_bands));
    }
    std::vector<std::uint8_t> done() { return out_; }
    unsigned lot(unsigned n) { return static_cast<unsigned>(random_()) % n; }

    struct Fixed {
        std::size_t argument;
        unsigned byte;
    };
    /// Writes a call whose first enums and parameter names are `chosen`. Bytes that are `fixed` have
    /// priority.
    void call(std::string_view name, std::initializer_list<GLenum> chosen = {},
              std::initializer_list<Fixed> fixed = {}) {
        const std::span<const Command> table = commands();
        for (std::size_t i = 0; i < table.size(); ++i)
            if (table[i].name == name)
                return call(i, chosen, fixed);
        std::abort(); // there is no such command
    }
    void some_state() {
        const std::span<const Command> table = commands();
        for (int tries = 0; tries < 100; ++tries) {
            const std::size_t i = lot(static_cast<unsigned>(table.size()));
            if (!table[i].inside && std::string_view(table[i].family) != "NewList")
                return call(i, {}, {});
        }
    }
    void primitive(GLenum mode, unsigned vertices) {
        call("glBegin", {mode});
        for (unsigned v = 0; v < vertices; ++v) {
            constexpr const char* attributes[] = {"glColor3f",    "glColor4f",  "glColor4ub",
                                                  "glNormal3f",   "glNormal3b", "glTexCoord2f",
                                                  "glTexCoord4f", "glMaterialf"};
            call(attributes[lot(8)]);
            constexpr const char* positions[] = {"glVertex3f", "glVertex2f", "glVertex3d", "glVertex4f"};
            call(positions[lot(8) % 5 % 4]);
        }
        call("glEnd");
    }

  private:
    std::mt19937 random_;
    std::vector<std::uint8_t> out_;

    void put(unsigned byte) { out_.push_back(static_cast<std::uint8_t>(byte)); }
    void word(std::uint32_t w) {
        for (int i = 0; i < 4; ++i)
            put(w >> 8 * i);
    }

    /// Returns a byte that is not 0 modulo 8, for which the reader takes a sensible value.
    unsigned sensible() {
        for (;;)
            if (const unsigned how = lot(256); how % 8 != 0)
                return how;
    }

    /// Returns the byte that the reader takes for the `wanted` entry of a table; multiples of `avoid` mean
    /// something else.
    template <class Is> unsigned choice(std::size_t entries, unsigned avoid, Is is_wanted) {
        for (unsigned how = 1; how < 256; ++how)
            if (how % avoid != 0 && is_wanted(choice_of(static_cast<std::uint8_t>(how), avoid, entries)))
                return how;
        std::abort(); // the entry is not in this table
    }

    void call(std::size_t index, std::initializer_list<GLenum> chosen, std::initializer_list<Fixed> fixed) {
        put(static_cast<unsigned>(index));
        put(static_cast<unsigned>(index >> 8));
        const Command& c = commands()[index];
        auto next = chosen.begin();
        for (std::size_t i = 0; i < c.args.size(); ++i) {
            const Arg& arg = c.args[i];
            const auto known =
                std::find_if(fixed.begin(), fixed.end(), [i](const Fixed& f) { return f.argument == i; });
            if (known != fixed.end())
                put(known->byte);
            else if (arg.kind == Kind::enum_ && next != chosen.end())
                put(choice(arg.accepted.size(), 8,
                           [&, e = *next++](std::size_t n) { return arg.accepted[n] == e; }));
            else if (arg.kind == Kind::pname && next != chosen.end())
                put(choice(c.pnames.size(), 16,
                           [&, e = *next++](std::size_t n) { return c.pnames[n].name == e; }));
            else
                argument(arg);
        }
    }

    void argument(const Arg& arg) {
        const unsigned how = sensible();
        put(how);
        const bool any_enum = arg.kind == Kind::enum_ && arg.accepted.empty();
        const bool bits = (arg.kind == Kind::uint || arg.kind == Kind::bitfield) && how % 4 == 0;
        if (any_enum)
            word(GL_RGBA);
        else if (bits)
            word(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
};

using Fill = void (*)(Writer&);

constexpr GLenum modes[] = {GL_POINTS,         GL_LINES,        GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES,
                            GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,     GL_QUAD_STRIP, GL_POLYGON};

void shapes(Writer& w) {
    for (const GLenum mode : modes)
        w.primitive(mode, 3 + w.lot(5));
}

void lit(Writer& w) {
    for (const GLenum on :
         {GL_LIGHTING, GL_LIGHT0, GL_LIGHT1, GL_NORMALIZE, GL_COLOR_MATERIAL, GL_DEPTH_TEST})
        w.call("glEnable", {on});
    for (int i = 0; i < 6; ++i)
        w.call(i % 2 != 0 ? "glLightf" : "glMaterialfv");
    shapes(w);
}

/// Writes a level of a texture, as run_command_stream() reads sizes (value + 2), levels (value + 3, not 8)
/// and borders (value + 1).
void image(Writer& w, unsigned level, unsigned size, GLenum format, GLenum type) {
    const unsigned level_byte = level == 5 ? 76 : level + 3;
    w.call("glTexImage2D", {GL_TEXTURE_2D, format, type},
           {{1, level_byte}, {3, size + 2}, {4, size + 2}, {5, 1}});
}

void textured(Writer& w) {
    constexpr GLenum formats[] = {GL_RGB, GL_RGBA, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA};
    w.call("glEnable", {GL_TEXTURE_2D});
    for (int i = 0; i < 6; ++i) {
        const GLenum format = formats[w.lot(5)];
        for (unsigned level = 0; level <= 4; ++level)
            image(w, level, 16u >> level, format, w.lot(2) != 0 ? GL_UNSIGNED_BYTE : GL_FLOAT);
        // The reader picks a token by the byte modulo 19, NEAREST and LINEAR first, when the argument is 2 or
        // 3 modulo 4.
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            w.call("glTexParameteri", {GL_TEXTURE_2D, filter}, {{2, i % 2 != 0 ? 38u : 39u}});
        w.call("glTexParameteri", {GL_TEXTURE_2D});
        w.call("glTexEnvi", {GL_TEXTURE_ENV});
        w.primitive(modes[w.lot(10)], 6);
    }
    for (int i = 0; i < 4; ++i)
        w.call("glTexSubImage2D", {GL_TEXTURE_2D});
    w.primitive(GL_TRIANGLES, 6);
}

void fragments(Writer& w) {
    for (const GLenum on :
         {GL_ALPHA_TEST, GL_BLEND, GL_DEPTH_TEST, GL_DITHER, GL_FOG, GL_SCISSOR_TEST, GL_STENCIL_TEST}) {
        w.call("glEnable", {on});
        for (const char* name :
             {"glBlendFunc", "glStencilFunc", "glStencilOp", "glAlphaFunc", "glDepthFunc", "glFogf"})
            w.call(name);
        w.primitive(modes[w.lot(10)], 6);
    }
    textured(w);
    w.call("glReadPixels");
}

// Bytes that run_command_stream() reads as an internal format (modulo 20) or as a token (modulo 19).
constexpr unsigned rgb = 21, rgba = 20, rgb5 = 28, nearest = 38, linear = 39, replace = 51, modulate = 10;

/// A state that has a fused span: what is on, and the texture.
struct Preset {
    bool texture, depth, blend, fog;
    unsigned kept, filter, environment;
};
constexpr Preset presets[] = {
    {false, false, false, false, rgb, nearest, replace}, {false, true, false, false, rgb, nearest, replace},
    {false, false, true, false, rgb, nearest, replace},  {true, false, false, false, rgb5, nearest, replace},
    {true, false, false, false, rgb, nearest, replace},  {true, true, false, false, rgb5, nearest, replace},
    {true, true, false, false, rgb, nearest, replace},   {true, false, false, false, rgb, linear, replace},
    {true, false, false, false, rgb5, linear, replace},  {true, false, true, false, rgba, nearest, replace},
    {true, false, true, false, rgba, nearest, modulate}, {true, true, false, false, rgb, nearest, modulate},
    {true, true, false, false, rgb5, nearest, modulate}, {true, true, false, true, rgb, nearest, modulate},
    {true, true, false, true, rgb5, nearest, modulate},  {true, true, false, false, rgb, linear, modulate},
    {true, true, false, false, rgb5, linear, modulate},
};

void set(Writer& w, const Preset& p) {
    const unsigned width = 1u << w.lot(6), height = 1u << w.lot(6);
    w.call("glTexImage2D",
           {GL_TEXTURE_2D, p.kept == rgba ? GLenum{GL_RGBA} : GLenum{GL_RGB}, GL_UNSIGNED_BYTE},
           {{1, 3}, {2, p.kept}, {3, width + 2}, {4, height + 2}, {5, 1}});
    for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        w.call("glTexParameteri", {GL_TEXTURE_2D, name}, {{2, p.filter}});
    w.call("glTexEnvi", {GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE}, {{2, p.environment}});
    w.call("glFogi", {GL_FOG_MODE}, {{1, linear}});
    w.call("glBlendFunc", {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA});
    const std::pair<GLenum, bool> switches[] = {{GL_TEXTURE_2D, p.texture},
                                                {GL_DEPTH_TEST, p.depth},
                                                {GL_BLEND, p.blend},
                                                {GL_FOG, p.fog},
                                                {GL_DITHER, w.lot(2) != 0}};
    for (const auto& [name, on] : switches)
        w.call(on ? "glEnable" : "glDisable", {name});
}

void fused(Writer& w) {
    for (int i = 0; i < 8; ++i) {
        set(w, presets[w.lot(std::size(presets))]);
        w.call("glShadeModel", {w.lot(3) == 0 ? GLenum{GL_FLAT} : GLenum{GL_SMOOTH}});
        w.call("glClear");
        w.primitive(GL_TRIANGLE_STRIP, 5);
    }
}

void lists(Writer& w) {
    w.call("glGenLists");
    w.call("glNewList");
    shapes(w);
    w.call("glEndList");
    w.call("glCallList");
    w.call("glCallLists");
}

void arrays(Writer& w) {
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY})
        w.call("glEnableClientState", {array});
    for (const GLenum mode : modes) {
        w.call("glVertexPointer");
        w.call("glColorPointer");
        w.call("glDrawArrays", {mode});
        w.call("glDrawElements", {mode});
    }
}

/// Draws primitives in every mode that has stages of its own.
void modal(Writer& w) {
    w.call("glEnable", {GL_BLEND});
    for (const GLenum on : {GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH, GL_LINE_STIPPLE,
                            GL_POLYGON_STIPPLE, GL_POLYGON_OFFSET_FILL, GL_DEPTH_TEST, GL_STENCIL_TEST}) {
        w.call("glEnable", {on});
        for (const char* name : {"glLineStipple", "glPolygonOffset", "glLineWidth", "glPointSize",
                                 "glPolygonStipple", "glGetPolygonStipple", "glPolygonMode"})
            w.call(name);
        w.primitive(modes[w.lot(10)], 6);
        w.primitive(modes[w.lot(10)], 6);
    }
}

/// Draws into the buffers of selection and feedback, with names between and attribute stacks around.
void captured(Writer& w) {
    for (int i = 0; i < 3; ++i) {
        w.call("glPushAttrib");
        w.call("glPushClientAttrib");
        w.call("glFeedbackBuffer");
        w.call("glSelectBuffer");
        w.call("glRenderMode", {i % 2 != 0 ? GLenum{GL_FEEDBACK} : GLenum{GL_SELECT}});
        for (const char* name : {"glPushName", "glLoadName", "glPassThrough"})
            w.call(name);
        w.call("glPolygonMode");
        w.primitive(modes[w.lot(10)], 6);
        w.call("glPopName");
        w.primitive(modes[w.lot(10)], 6);
        w.call("glRenderMode", {GL_RENDER});
        w.call("glPopClientAttrib");
        w.call("glPopAttrib");
    }
}

/// Defines maps of every target, and draws points and meshes of them.
void evaluated(Writer& w) {
    for (const GLenum on : {GL_MAP1_VERTEX_3, GL_MAP2_VERTEX_4, GL_MAP2_COLOR_4, GL_MAP1_TEXTURE_COORD_2,
                            GL_AUTO_NORMAL, GL_LIGHTING, GL_LIGHT0})
        w.call("glEnable", {on});
    for (int i = 0; i < 12; ++i) {
        w.call(i % 2 != 0 ? "glMap1f" : "glMap2d");
        w.call(i % 2 != 0 ? "glMapGrid1f" : "glMapGrid2f");
        w.call("glBegin", {modes[w.lot(10)]});
        for (const char* name : {"glEvalCoord1f", "glEvalCoord2f", "glEvalPoint1", "glEvalPoint2"})
            w.call(name);
        w.call("glEnd");
        w.call(i % 2 != 0 ? "glEvalMesh1" : "glEvalMesh2");
        w.call("glGetMapfv");
    }
}

/// Reads, copies and counts pixels in the middle of a frame.
void copied(Writer& w) {
    w.call("glEnable", {GL_DEPTH_TEST});
    for (int i = 0; i < 5; ++i) {
        w.primitive(modes[w.lot(10)], 6);
        for (const char* name : {"glRasterPos2f", "glCopyPixels", "glReadPixels", "glBitmap", "glDrawPixels"})
            w.call(name);
        image(w, 0, 16, GL_RGBA, GL_UNSIGNED_BYTE);
        w.call("glEnable", {GL_TEXTURE_2D});
        w.primitive(GL_TRIANGLES, 6);
        w.call("glCopyTexSubImage2D", {GL_TEXTURE_2D});
        w.call("glTexSubImage2D", {GL_TEXTURE_2D});
        w.primitive(GL_TRIANGLES, 6);
        w.call("glAccum");
    }
}

void anything(Writer& w) {
    for (int i = 0; i < 30; ++i) {
        w.some_state();
        if (i % 3 == 0)
            w.primitive(modes[w.lot(10)], 4);
    }
}

} // namespace

std::vector<std::vector<std::uint8_t>> command_seeds() {
    constexpr Fill fills[] = {shapes, lit,      textured, fragments, fused,  lists,
                              arrays, captured, modal,    evaluated, copied, anything};
    std::vector<std::vector<std::uint8_t>> seeds;
    unsigned number = 0;
    for (int round = 0; round < 24; ++round)
        for (const Fill fill : fills) {
            Writer w(++number, fill == fused, round % 2 != 0);
            if (round >= 8 && fill != fused) // draws in the state that random calls have left
                for (int i = 0; i < 6; ++i)
                    w.some_state();
            fill(w);
            seeds.push_back(w.done());
        }
    return seeds;
}

} // namespace spangle::test

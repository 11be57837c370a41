// Draws primitives: single vertices, arrays, lists and evaluators.
#include "tests/system/streams/stream_scenes.hpp"

#include <iterator>
#include <type_traits>

#include <spangle/GL/gl.h>

namespace spangle::test {
namespace {

constexpr GLenum modes[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,  GL_QUAD_STRIP,
                            GL_POLYGON,   GL_LINES,          GL_LINE_STRIP,   GL_POINTS, GL_LINE_LOOP};

} // namespace

/// Sends a vertex, sometimes with attributes of its own.
void Scenes::vertex() {
    const unsigned what = in_.byte();
    if ((what & 1) != 0)
        glColor4f(unit_number(in_), unit_number(in_), unit_number(in_), unit_number(in_));
    if ((what & 2) != 0)
        glTexCoord2f(unit_number(in_) * 4, unit_number(in_) * 4);
    if ((what & 12) == 12)
        glMultiTexCoord4f(GL_TEXTURE1, unit_number(in_), unit_number(in_), unit_number(in_),
                          in_.byte() % 4 != 0 ? 1 : unit_number(in_));
    if ((what & 16) != 0)
        glNormal3f(unit_number(in_), unit_number(in_), unit_number(in_));
    if ((what & 96) == 96)
        glEdgeFlag(in_.byte() % 2);
    if ((what & 0x90) == 0x90)
        glFogCoordf(unit_number(in_));
    const float x = coordinate(in_, width_), y = coordinate(in_, height_);
    if ((what & 0x70) == 0)
        glVertex4f(x, y, unit_number(in_), in_.byte() % 4 != 0 ? 1 : unit_number(in_));
    else if ((what & 0x20) != 0)
        glVertex2f(x, y);
    else
        glVertex3f(x, y, unit_number(in_));
}

void Scenes::vertices() {
    glBegin(pick(in_, modes));
    for (unsigned left = 1 + pick(in_, 12); left > 0; --left)
        vertex();
    if (in_.byte() % 16 != 0) // otherwise what comes next is between Begin and End
        glEnd();
}

/// Draws an image at about one texel a pixel, over the whole surface or a part of it.
void Scenes::blit() {
    const float left = coordinate(in_, width_ / 2), bottom = coordinate(in_, height_ / 2),
                right = in_.byte() % 2 != 0 ? static_cast<float>(width_) : coordinate(in_, width_),
                top = in_.byte() % 2 != 0 ? static_cast<float>(height_) : coordinate(in_, height_);
    const float scale = in_.byte() % 4 != 0 ? 1.0f / 64 : unit_number(in_);
    const float turn = in_.byte() % 8 == 0 ? unit_number(in_) : 0;
    const float q = in_.byte() % 8 == 0 ? unit_number(in_) : 1;
    if (in_.byte() % 8 == 0)
        return glRectf(left, bottom, right, top);
    const float corners[][2] = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
    glBegin(GL_QUADS);
    for (const auto& corner : corners) {
        glTexCoord4f(corner[0] * scale + corner[1] * turn, corner[1] * scale - corner[0] * turn, 0, q);
        glVertex2f(corner[0], corner[1]);
    }
    glEnd();
}

/// Draws arrays of `count` vertices, each of exactly its memory. Afterwards no array is enabled, and all
/// point to memory that is large enough for later draws.
void Scenes::draw_arrays(int count, bool in_buffers) {
    const std::size_t kept = memory_.blocks();
    GLuint names[8] = {};
    unsigned made = 0;
    const auto floats = [&](int size, int& stride, auto number) -> const void* {
        stride = in_.byte() % 3 == 0 ? (size + static_cast<int>(pick(in_, 4))) * 4 : 0;
        const int step = stride != 0 ? stride : size * 4;
        const auto bytes = static_cast<std::size_t>((count - 1) * step + size * 4);
        std::uint8_t* const block = memory_.make(bytes);
        for (int i = 0; i < count; ++i)
            for (int c = 0; c < size; ++c) {
                const float value = number(c);
                std::memcpy(block + i * step + c * 4, &value, 4);
            }
        if (!in_buffers || made == std::size(names) || in_.byte() % 4 == 0)
            return block;
        glGenBuffers(1, &names[made]);
        glBindBuffer(GL_ARRAY_BUFFER, names[made++]);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), block, GL_STATIC_DRAW);
        return nullptr;
    };
    const auto unit = [&](int) { return unit_number(in_); };
    int stride = 0;
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    const int size = 2 + static_cast<int>(pick(in_, 3));
    const void* at = floats(size, stride, [&](int c) {
        return c == 0   ? coordinate(in_, width_)
               : c == 1 ? coordinate(in_, height_)
               : c == 3 ? 1.0f
                        : unit_number(in_);
    });
    glVertexPointer(size, GL_FLOAT, stride, at);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glEnableClientState(GL_VERTEX_ARRAY);
    const unsigned with = in_.byte();
    struct Array {
        unsigned bit;
        GLenum name;
        int size;
    };
    for (const Array& array : {Array{1, GL_COLOR_ARRAY, 4},
                               {2, GL_TEXTURE_COORD_ARRAY, 2},
                               {4, GL_NORMAL_ARRAY, 3},
                               {8, GL_FOG_COORD_ARRAY, 1},
                               {16, GL_SECONDARY_COLOR_ARRAY, 3}}) {
        if ((with & array.bit) == 0)
            continue;
        at = floats(array.size, stride, unit);
        switch (array.name) {
        case GL_COLOR_ARRAY:
            glColorPointer(4, GL_FLOAT, stride, at);
            break;
        case GL_TEXTURE_COORD_ARRAY:
            glTexCoordPointer(2, GL_FLOAT, stride, at);
            break;
        case GL_NORMAL_ARRAY:
            glNormalPointer(GL_FLOAT, stride, at);
            break;
        case GL_FOG_COORD_ARRAY:
            glFogCoordPointer(GL_FLOAT, stride, at);
            break;
        default:
            glSecondaryColorPointer(3, GL_FLOAT, stride, at);
        }
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glEnableClientState(array.name);
    }
    const GLenum mode = pick(in_, modes);
    const int indices = 1 + static_cast<int>(pick(in_, 40));
    const unsigned how = pick(in_, 6);
    const auto element = [&](auto* list) {
        for (int i = 0; i < indices; ++i)
            list[i] =
                static_cast<std::remove_pointer_t<decltype(list)>>(pick(in_, static_cast<unsigned>(count)));
        return list;
    };
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    if (how == 0) {
        const int first = static_cast<int>(pick(in_, static_cast<unsigned>(count)));
        glDrawArrays(mode, first, count - first);
    } else if (how == 1) {
        glDrawElements(mode, indices, GL_UNSIGNED_BYTE,
                       element(memory_.make(static_cast<std::size_t>(indices))));
    } else if (how == 2) {
        auto* const list = reinterpret_cast<GLushort*>(memory_.make(2 * static_cast<std::size_t>(indices)));
        glDrawElements(mode, indices, GL_UNSIGNED_SHORT, element(list));
    } else if (how == 3) {
        auto* const list = reinterpret_cast<GLuint*>(memory_.make(4 * static_cast<std::size_t>(indices)));
        glDrawRangeElements(mode, 0, static_cast<GLuint>(count - 1), indices, GL_UNSIGNED_INT, element(list));
    } else if (how == 4) {
        const GLint firsts[] = {0, count / 2};
        const GLsizei counts[] = {count / 2, count - count / 2};
        glMultiDrawArrays(mode, firsts, counts, 2);
    } else {
        glBegin(mode);
        for (int i = 0; i < indices; ++i)
            glArrayElement(static_cast<GLint>(pick(in_, static_cast<unsigned>(count))));
        glEnd();
    }
    glVertexPointer(4, GL_FLOAT, 0, source());
    glColorPointer(4, GL_FLOAT, 0, source());
    glTexCoordPointer(4, GL_FLOAT, 0, source());
    glNormalPointer(GL_FLOAT, 0, source());
    glFogCoordPointer(GL_FLOAT, 0, source());
    glSecondaryColorPointer(3, GL_FLOAT, 0, source());
    for (const GLenum name : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_NORMAL_ARRAY,
                              GL_FOG_COORD_ARRAY, GL_SECONDARY_COLOR_ARRAY})
        glDisableClientState(name);
    glDeleteBuffers(static_cast<GLsizei>(made), names);
    memory_.drop_to(kept);
}

/// Client memory ends with the last vertex, so no other array may be enabled.
void Scenes::arrays() {
    GLint index = -1;
    glGetIntegerv(GL_LIST_INDEX, &index);
    if (index == -1)
        return; // between Begin and End arrays do not change
    for (const GLenum name :
         {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_NORMAL_ARRAY, GL_INDEX_ARRAY,
          GL_EDGE_FLAG_ARRAY, GL_FOG_COORD_ARRAY, GL_SECONDARY_COLOR_ARRAY})
        glDisableClientState(name);
    draw_arrays(1 + static_cast<int>(pick(in_, 40)), in_.byte() % 2 != 0);
}

/// Fills buffers, maps them, and writes to their very end.
void Scenes::buffers() {
    const auto name = static_cast<GLuint>(1 + pick(in_, 4));
    const GLenum target = pick(in_, {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER});
    glBindBuffer(target, name);
    const auto size = static_cast<GLsizeiptr>(1 + pick(in_, 600));
    const std::size_t kept = memory_.blocks();
    // Indices of every type must stay small in buffers from which later draws may take them.
    const auto fill = [](std::uint8_t* bytes, GLsizeiptr count) {
        std::memset(bytes, 0, static_cast<std::size_t>(count));
    };
    std::uint8_t* const bytes = memory_.make(static_cast<std::size_t>(size));
    fill(bytes, size);
    glBufferData(target, size, bytes, pick(in_, {GL_STATIC_DRAW, GL_STREAM_READ, GL_DYNAMIC_COPY}));
    const auto from = static_cast<GLsizeiptr>(pick(in_, static_cast<unsigned>(size)));
    glBufferSubData(target, from, size - from, bytes + from);
    glGetBufferSubData(target, from, size - from, bytes + from);
    if (void* const mapped = glMapBuffer(target, pick(in_, {GL_READ_WRITE, GL_WRITE_ONLY, GL_READ_ONLY}))) {
        GLint length = 0;
        glGetBufferParameteriv(target, GL_BUFFER_SIZE, &length);
        fill(static_cast<std::uint8_t*>(mapped), length);
        if (in_.byte() % 8 != 0)
            glUnmapBuffer(target);
    }
    if (in_.byte() % 2 != 0)
        glBindBuffer(target, 0);
    memory_.drop_to(kept);
    arrays();
}

void Scenes::clears() {
    glClearColor(unit_number(in_), unit_number(in_), unit_number(in_), unit_number(in_));
    glClearDepth(in_.byte() / 255.0);
    glClearStencil(in_.byte());
    glClear(
        (in_.byte() % 4 != 0 ? GL_COLOR_BUFFER_BIT : 0) | (in_.byte() % 2 != 0 ? GL_DEPTH_BUFFER_BIT : 0) |
        (in_.byte() % 2 != 0 ? GL_STENCIL_BUFFER_BIT : 0) | (in_.byte() % 4 == 0 ? GL_ACCUM_BUFFER_BIT : 0));
    if (in_.byte() % 4 == 0)
        glAccum(pick(in_, {GL_LOAD, GL_ACCUM, GL_RETURN, GL_MULT, GL_ADD}), unit_number(in_));
}

/// Makes a list of a few pieces, none of which calls a list. If a list is being compiled, no other is made.
void Scenes::lists() {
    GLint index = -1;
    glGetIntegerv(GL_LIST_INDEX, &index);
    if (index != 0)
        return;
    const auto name = static_cast<GLuint>(40 + pick(in_, 8));
    glNewList(name, pick(in_, {GL_COMPILE, GL_COMPILE_AND_EXECUTE}));
    constexpr Piece pieces[] = {&Scenes::vertices, &Scenes::arrays,     &Scenes::fragments, &Scenes::blit,
                                &Scenes::texture,  &Scenes::images,     &Scenes::lights,    &Scenes::clears,
                                &Scenes::camera,   &Scenes::environment};
    for (unsigned left = 1 + pick(in_, 4); left > 0; --left)
        (this->*pick(in_, pieces))();
    glEnd(); // ends a primitive that a piece left open
    glEndList();
    glCallList(name);
    if (in_.byte() % 4 == 0) {
        const GLubyte two[] = {static_cast<GLubyte>(name), 41};
        glListBase(0);
        glCallLists(2, GL_UNSIGNED_BYTE, two);
    }
    if (in_.byte() % 8 == 0)
        glDeleteLists(name, 1);
}

/// Defines evaluators with control points of exactly their memory.
void Scenes::curves() {
    const std::size_t kept = memory_.blocks();
    struct Map {
        GLenum one, two;
        int size;
    };
    constexpr Map maps[] = {{GL_MAP1_VERTEX_3, GL_MAP2_VERTEX_3, 3},
                            {GL_MAP1_VERTEX_4, GL_MAP2_VERTEX_4, 4},
                            {GL_MAP1_COLOR_4, GL_MAP2_COLOR_4, 4},
                            {GL_MAP1_TEXTURE_COORD_2, GL_MAP2_TEXTURE_COORD_2, 2},
                            {GL_MAP1_NORMAL, GL_MAP2_NORMAL, 3}};
    for (unsigned left = 1 + pick(in_, 2); left > 0; --left) {
        const Map& map = pick(in_, maps);
        const int u = 1 + static_cast<int>(pick(in_, 8)), v = 1 + static_cast<int>(pick(in_, 8));
        auto* const points =
            reinterpret_cast<GLfloat*>(memory_.make(4 * static_cast<std::size_t>(u * v * map.size)));
        for (int i = 0; i < u * v * map.size; ++i)
            points[i] = i % map.size == 0   ? coordinate(in_, width_)
                        : i % map.size == 1 ? coordinate(in_, height_)
                                            : unit_number(in_);
        glMap2f(map.two, 0, 1, map.size * v, u, 0, 1, map.size, v, points);
        glMap1f(map.one, 0, 1, map.size, u * v < 9 ? u * v : 8, points);
        glEnable(map.one);
        glEnable(map.two);
    }
    in_.byte() % 2 != 0 ? glEnable(GL_AUTO_NORMAL) : glDisable(GL_AUTO_NORMAL);
    const auto n = static_cast<GLint>(1 + pick(in_, 6));
    glMapGrid2f(n, 0, 1, n, 0, 1);
    glMapGrid1f(n, 0, 1);
    if (in_.byte() % 2 != 0)
        glEvalMesh2(pick(in_, {GL_FILL, GL_LINE, GL_POINT}), 0, n, 0, n);
    else
        glEvalMesh1(pick(in_, {GL_LINE, GL_POINT}), 0, n);
    memory_.drop_to(kept);
}

/// Draws what most programs draw most of the time: a surface in perspective with a depth test, perhaps
/// textured, lit, in fog or translucent, and little else. Such states have fused spans.
void Scenes::usual() {
    plain();
    camera();
    const auto turn = [&](GLenum cap, unsigned one_of) {
        in_.byte() % one_of == 0 ? glEnable(cap) : glDisable(cap);
    };
    for (const GLenum unit : {GL_TEXTURE1, GL_TEXTURE0}) {
        glActiveTexture(unit);
        for (const GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP})
            glDisable(target);
    }
    if (in_.byte() % 4 != 0) {
        const unsigned log_width = pick(in_, 9), log_height = pick(in_, 9), filter = pick(in_, 4);
        const GLenum format = pick(in_, {GL_RGB, GL_RGBA, GL_LUMINANCE, GL_ALPHA});
        glBindTexture(GL_TEXTURE_2D, 1 + pick(in_, 3));
        glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, filter > 1);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                        filter > 1 ? static_cast<GLint>(GL_NEAREST_MIPMAP_NEAREST + pick(in_, 4))
                                   : static_cast<GLint>(GL_NEAREST + filter));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(GL_NEAREST + pick(in_, 2)));
        for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
            glTexParameteri(GL_TEXTURE_2D, axis,
                            static_cast<GLint>(pick(in_, {GL_REPEAT, GL_CLAMP_TO_EDGE})));
        glTexImage2D(GL_TEXTURE_2D, 0,
                     format == GL_RGB && in_.byte() % 2 != 0 ? GL_RGB5 : static_cast<GLint>(format),
                     1 << log_width, 1 << log_height, 0, format, GL_UNSIGNED_BYTE, source());
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
                  static_cast<GLint>(pick(in_, {GL_MODULATE, GL_REPLACE, GL_DECAL})));
        glEnable(GL_TEXTURE_2D);
    }
    turn(GL_DEPTH_TEST, 1 + pick(in_, 2));
    glDepthFunc(pick(in_, {GL_LESS, GL_LEQUAL}));
    turn(GL_LIGHTING, 2);
    glEnable(GL_LIGHT0);
    turn(GL_FOG, 4);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 1);
    glFogf(GL_FOG_END, 6);
    turn(GL_BLEND, 4);
    glBlendFunc(GL_SRC_ALPHA, pick(in_, {GL_ONE_MINUS_SRC_ALPHA, GL_ONE}));
    turn(GL_ALPHA_TEST, 8);
    glAlphaFunc(GL_GREATER, 0.5f);
    turn(GL_DITHER, 2);
    glShadeModel(pick(in_, {GL_SMOOTH, GL_SMOOTH, GL_FLAT}));
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const float scale = static_cast<float>(1 + pick(in_, 8)), wave = unit_number(in_);
    const int cells = 1 + static_cast<int>(pick(in_, 6));
    glLoadIdentity();
    glTranslatef(0, 0, -2.5f);
    glRotatef(static_cast<float>(in_.byte()), 1, unit_number(in_), 0);
    for (int y = 0; y < cells; ++y) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int i = 0; i < 2 * cells + 2; ++i) {
            const float u = static_cast<float>(i / 2) / static_cast<float>(cells),
                        v = static_cast<float>(y + i % 2) / static_cast<float>(cells);
            glColor4f(u, v, 1 - u, 0.5f + v / 2);
            glNormal3f(u - 0.5f, v - 0.5f, 1);
            glTexCoord2f(u * scale, v * scale);
            glVertex3f(4 * u - 2, 4 * v - 2, wave * (u - v));
        }
        glEnd();
    }
}

/// Queries state of any name; no state has more values than a pixel map.
void Scenes::questions() {
    for (unsigned left = 1 + pick(in_, 6); left > 0; --left) {
        const GLenum name = pick(in_, {0x0B00, 0x0C00, 0x0D00, 0x0DC0, 0x8000, 0x8060, 0x8450, 0x8500, 0x8640,
                                       0x8870, 0x8890}) +
                            in_.byte();
        switch (pick(in_, 4)) {
        case 0:
            glGetIntegerv(name, reinterpret_cast<GLint*>(result()));
            break;
        case 1:
            glGetDoublev(name, reinterpret_cast<GLdouble*>(result()));
            break;
        case 2:
            glGetBooleanv(name, result());
            break;
        default:
            glGetFloatv(name, reinterpret_cast<GLfloat*>(result()));
            glIsEnabled(name);
        }
    }
}

/// Uses feedback, selection and queries; the memory of their buffers must stay.
void Scenes::answers() {
    const auto room = static_cast<GLsizei>(pick(in_, 64));
    auto* const words = reinterpret_cast<GLuint*>(memory_.make(4 * static_cast<std::size_t>(room)));
    switch (pick(in_, 3)) {
    case 0:
        glFeedbackBuffer(room,
                         pick(in_, {GL_2D, GL_3D, GL_3D_COLOR, GL_3D_COLOR_TEXTURE, GL_4D_COLOR_TEXTURE}),
                         reinterpret_cast<GLfloat*>(words));
        glRenderMode(GL_FEEDBACK);
        vertices();
        glPassThrough(1);
        break;
    case 1:
        glSelectBuffer(room, words);
        glRenderMode(GL_SELECT);
        glInitNames();
        glPushName(in_.byte());
        vertices();
        glPushName(in_.byte());
        blit();
        break;
    default:
        glBeginQuery(GL_SAMPLES_PASSED, 1 + pick(in_, 3));
        vertices();
        glEndQuery(GL_SAMPLES_PASSED);
        GLuint passed = 0;
        glGetQueryObjectuiv(1 + pick(in_, 3), GL_QUERY_RESULT, &passed);
    }
    if (in_.byte() % 8 != 0)
        glRenderMode(GL_RENDER);
}

} // namespace spangle::test

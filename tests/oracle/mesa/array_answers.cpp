// Asks where vertices come from: buffers, draws of many primitives, fog coordinates, restarts, array objects.
#include <cstddef>
#include <initializer_list>

#include "tests/oracle/mesa/asker.hpp"

namespace spangle::oracle {

namespace {

struct Corner {
    GLubyte color[4];
    GLfloat at[3];
};

std::vector<Corner> mesh() {
    std::vector<Corner> out;
    for (int i = 0; i < 20; ++i) {
        const auto n = static_cast<float>(i);
        out.push_back({{static_cast<GLubyte>(12 * i), static_cast<GLubyte>(255 - 9 * i), 77, 255},
                       {0.15f * static_cast<float>(i % 6) - 0.4f, 0.2f * static_cast<float>(i / 6) - 0.3f,
                        n / 40 - 0.2f}});
    }
    return out;
}

const void* at(std::size_t offset) {
    return reinterpret_cast<const void*>(offset);
}

/// Points the arrays to the mesh in client memory, which must stay.
void point_to(const std::vector<Corner>& corners) {
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(3, GL_FLOAT, sizeof(Corner), corners[0].at);
    glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Corner), corners[0].color);
}

/// Points the arrays to the mesh in a buffer.
void buffered(const std::vector<Corner>& corners, GLuint name) {
    glBindBuffer(GL_ARRAY_BUFFER, name);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(Corner)), corners.data(),
                 GL_STATIC_DRAW);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(3, GL_FLOAT, sizeof(Corner), at(offsetof(Corner, at)));
    glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Corner), at(0));
}

/// Modes whose primitives every GL feeds back alike.
constexpr GLenum modes[] = {GL_POINTS,    GL_LINES,          GL_LINE_STRIP,  GL_LINE_LOOP,
                            GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN};

void parameters(Asker& asker, GLenum target) {
    for (const GLenum name :
         std::initializer_list<GLenum>{GL_BUFFER_SIZE, GL_BUFFER_USAGE, GL_BUFFER_ACCESS, GL_BUFFER_MAPPED,
                                       GL_BUFFER_ACCESS_FLAGS, GL_BUFFER_MAP_OFFSET, GL_BUFFER_MAP_LENGTH}) {
        GLint v = -1;
        glGetBufferParameteriv(target, name, &v);
        asker.note("parameter " + std::to_string(name), {static_cast<double>(v)});
    }
}

void contents(Asker& asker, GLsizeiptr size) {
    std::vector<GLubyte> bytes(static_cast<std::size_t>(size));
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, size, bytes.data());
    asker.note("contents", {bytes.begin(), bytes.end()});
}

} // namespace

Answers buffers() {
    Asker asker;
    perspective();
    const auto corners = mesh();
    GLuint names[3] = {};
    glGenBuffers(3, names);
    asker.note("names", {static_cast<double>(glIsBuffer(names[0])), static_cast<double>(glIsBuffer(0))});
    const GLubyte bytes[8] = {1, 2, 3, 4, 5, 6, 7, 8};
    glBindBuffer(GL_ARRAY_BUFFER, names[0]);
    parameters(asker, GL_ARRAY_BUFFER);
    glBufferData(GL_ARRAY_BUFFER, 8, bytes, GL_DYNAMIC_READ);
    glBufferSubData(GL_ARRAY_BUFFER, 2, 3, bytes);
    contents(asker, 8);
    parameters(asker, GL_ARRAY_BUFFER);
    auto* const part =
        static_cast<GLubyte*>(glMapBufferRange(GL_ARRAY_BUFFER, 2, 4, GL_MAP_WRITE_BIT | GL_MAP_READ_BIT));
    asker.note("mapped", {part[0] * 1.0, part[3] * 1.0});
    part[1] = 99;
    parameters(asker, GL_ARRAY_BUFFER);
    glMapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
    asker.error("mapped twice");
    glBufferSubData(GL_ARRAY_BUFFER, 0, 1, bytes);
    asker.error("written while mapped");
    asker.note("unmapped", {static_cast<double>(glUnmapBuffer(GL_ARRAY_BUFFER)),
                            static_cast<double>(glUnmapBuffer(GL_ARRAY_BUFFER))});
    asker.error("unmapped twice");
    contents(asker, 8);
    glMapBufferRange(GL_ARRAY_BUFFER, 0, 9, GL_MAP_READ_BIT);
    asker.error("too long");
    glMapBufferRange(GL_ARRAY_BUFFER, 0, 4, 0);
    asker.error("neither read nor written");
    glBufferSubData(GL_ARRAY_BUFFER, 7, 2, bytes);
    asker.error("beyond");
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBufferData(GL_ARRAY_BUFFER, 1, bytes, GL_STATIC_DRAW);
    asker.error("none bound");

    buffered(corners, names[1]);
    const GLushort index[12] = {0, 7, 13, 2, 9, 15, 4, 11, 17, 6, 12, 19};
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[2]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof index, index, GL_STATIC_DRAW);
    for (const GLenum mode : modes) {
        asker.feedback("arrays", GL_3D_COLOR, [mode] { glDrawArrays(mode, 3, 9); });
        asker.feedback("elements", GL_3D_COLOR,
                       [mode] { glDrawElements(mode, 10, GL_UNSIGNED_SHORT, at(4)); });
    }
    for (const GLenum binding : std::initializer_list<GLenum>{
             GL_ARRAY_BUFFER_BINDING, GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BUFFER_BINDING,
             GL_COLOR_ARRAY_BUFFER_BINDING, GL_NORMAL_ARRAY_BUFFER_BINDING,
             GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING})
        asker.state(binding, 1);
    glDeleteBuffers(2, names + 1);
    for (const GLenum binding : std::initializer_list<GLenum>{
             GL_ARRAY_BUFFER_BINDING, GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BUFFER_BINDING})
        asker.state(binding, 1);
    return asker.answers;
}

Answers multi_draw() {
    Asker asker;
    perspective();
    const auto corners = mesh();
    point_to(corners);
    const GLint first[4] = {0, 5, 2, 8};
    const GLsizei count[4] = {4, 0, 3, 7};
    const GLubyte a[4] = {0, 3, 5, 7}, b[3] = {1, 2, 9}, c[7] = {4, 6, 8, 10, 11, 13, 15};
    const void* indices[4] = {a, a, b, c};
    for (const GLenum mode : modes) {
        asker.feedback("arrays", GL_3D_COLOR, [&] { glMultiDrawArrays(mode, first, count, 4); });
        asker.feedback("elements", GL_3D_COLOR,
                       [&] { glMultiDrawElements(mode, count, GL_UNSIGNED_BYTE, indices, 4); });
    }
    glMultiDrawArrays(0xDEAD, first, count, 4);
    asker.error("mode");
    return asker.answers;
}

/// Asks for fog coordinates by queries, arrays and the raster position. Their fog is compared as a picture.
/// Mesa's attribute stacks do not save them.
Answers fog_coordinates() {
    Asker asker;
    const auto ask = [&asker] {
        for (const GLenum name : std::initializer_list<GLenum>{
                 GL_CURRENT_FOG_COORDINATE, GL_FOG_COORDINATE_SOURCE, GL_FOG_INDEX, GL_FOG_COORDINATE_ARRAY,
                 GL_FOG_COORDINATE_ARRAY_TYPE, GL_FOG_COORDINATE_ARRAY_STRIDE})
            asker.state(name, 1);
    };
    ask();
    glFogCoordf(2.5f);
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    glFogf(GL_FOG_INDEX, 7);
    ask();
    const GLdouble coords[3] = {-1, 4.25, 1000};
    glEnableClientState(GL_FOG_COORDINATE_ARRAY);
    glFogCoordPointer(GL_DOUBLE, 8, coords);
    for (int i = 0; i < 3; ++i) {
        glBegin(GL_POINTS);
        glArrayElement(i);
        glEnd();
        ask();
        glRasterPos2f(0, 0);
        asker.state(GL_CURRENT_RASTER_DISTANCE, 1);
        glWindowPos2i(i, i);
        asker.state(GL_CURRENT_RASTER_DISTANCE, 1);
    }
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_LINEAR);
    asker.error("source");
    glFogCoordPointer(GL_SHORT, 0, coords);
    asker.error("type");
    glFogCoordPointer(GL_FLOAT, -1, coords);
    asker.error("stride");
    return asker.answers;
}

/// Asks for secondary colours by queries, arrays and errors. Their sum is compared as a picture. Mesa has
/// COLOR_SUM in another attribute group.
Answers secondary_colors() {
    Asker asker;
    const auto ask = [&asker] {
        asker.state(GL_CURRENT_SECONDARY_COLOR, 4);
        for (const GLenum name : std::initializer_list<GLenum>{
                 GL_COLOR_SUM, GL_SECONDARY_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY_SIZE,
                 GL_SECONDARY_COLOR_ARRAY_TYPE, GL_SECONDARY_COLOR_ARRAY_STRIDE})
            asker.state(name, 1);
    };
    ask();
    glSecondaryColor3f(0.25f, 1, -0.5f);
    glEnable(GL_COLOR_SUM);
    ask();
    glSecondaryColor3ub(51, 102, 255);
    ask();
    glPushAttrib(GL_CURRENT_BIT);
    glSecondaryColor3d(0, 0.5, 0);
    ask();
    glPopAttrib();
    ask();
    const GLushort colors[3][3] = {{0, 65535, 13107}, {1, 2, 3}, {65535, 0, 0}};
    glEnableClientState(GL_SECONDARY_COLOR_ARRAY);
    glSecondaryColorPointer(3, GL_UNSIGNED_SHORT, 0, colors);
    for (int i = 0; i < 3; ++i) {
        glBegin(GL_POINTS);
        glArrayElement(i);
        glEnd();
        ask();
    }
    glSecondaryColorPointer(2, GL_FLOAT, 0, colors);
    asker.error("size");
    glSecondaryColorPointer(3, GL_FIXED, 0, colors);
    asker.error("type");
    glSecondaryColorPointer(3, GL_FLOAT, -1, colors);
    // Mesa keeps the stride nevertheless, and InterleavedArrays leaves the array enabled.
    asker.error("stride");
    return asker.answers;
}

Answers primitive_restart() {
    Asker asker;
    perspective();
    const auto corners = mesh();
    point_to(corners);
    const GLubyte index[] = {0, 1, 2, 3, 9, 4, 5, 6, 9, 9, 7, 9, 8, 10, 11, 12};
    asker.state(GL_PRIMITIVE_RESTART, 1);
    asker.state(GL_PRIMITIVE_RESTART_INDEX, 1);
    glPrimitiveRestartIndex(9);
    for (const bool on : {false, true}) {
        (on ? glEnable : glDisable)(GL_PRIMITIVE_RESTART);
        asker.state(GL_PRIMITIVE_RESTART, 1);
        asker.state(GL_PRIMITIVE_RESTART_INDEX, 1);
        for (const GLenum mode : modes)
            asker.feedback("elements", GL_3D_COLOR,
                           [&] { glDrawElements(mode, sizeof index, GL_UNSIGNED_BYTE, index); });
    }
    return asker.answers;
}

Answers vertex_array_objects() {
    Asker asker;
    perspective();
    const auto corners = mesh();
    GLuint names[2] = {}, buffers[2] = {};
    glGenVertexArrays(2, names);
    glGenBuffers(2, buffers);
    const auto ask = [&] {
        GLint bound = 0;
        glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
        asker.note("bound", {static_cast<double>(bound == 0                              ? 0
                                                 : bound == static_cast<GLint>(names[0]) ? 1
                                                                                         : 2)});
        for (const GLenum name : std::initializer_list<GLenum>{
                 GL_VERTEX_ARRAY, GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_STRIDE, GL_COLOR_ARRAY,
                 GL_COLOR_ARRAY_TYPE, GL_COLOR_ARRAY_STRIDE, GL_VERTEX_ARRAY_BUFFER_BINDING,
                 GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_ARRAY_BUFFER_BINDING})
            asker.state(name, 1);
    };
    asker.note("names", {static_cast<double>(glIsVertexArray(names[0]))});
    ask();
    glBindVertexArray(names[0]);
    buffered(corners, buffers[0]);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    ask();
    glBindVertexArray(names[1]);
    ask();
    glBindVertexArray(0);
    ask();
    glBindVertexArray(names[0]);
    ask();
    asker.feedback("arrays", GL_3D_COLOR, [] { glDrawArrays(GL_TRIANGLE_STRIP, 2, 9); });
    asker.note("names", {static_cast<double>(glIsVertexArray(names[0])),
                         static_cast<double>(glIsVertexArray(names[1]))});
    glDeleteVertexArrays(1, names);
    ask();
    glBindVertexArray(names[0]);
    asker.error("deleted");
    return asker.answers;
}

} // namespace spangle::oracle

// Asks about selection, feedback and lists.
#include <initializer_list>

#include "tests/oracle/mesa/asker.hpp"

namespace spangle::oracle {

Answers selection() {
    Asker asker;
    perspective();
    asker.selection("primitives", [] {
        glPushName(100);
        for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
            glPushName(mode);
            ring(mode, 8, 1);
            glPopName();
        }
    });
    asker.selection("names", [] {
        ring(GL_TRIANGLES, 3, 1);
        glPushName(5);
        glPushName(6);
        ring(GL_TRIANGLES, 3, 0.5f);
        ring(GL_POINTS, 8, 0.25f);
        glLoadName(7);
        glPopName();
        ring(GL_LINES, 2, 1);
        glInitNames();
        glPushName(8);
    });
    asker.selection("cut", [] {
        glPushName(1);
        ring(GL_QUADS, 4, 40);
        glLoadName(2);
        ring(GL_LINES, 8, 30);
        glLoadName(3);
        glTranslatef(0, 0, 100);
        ring(GL_TRIANGLES, 6, 2);
        glTranslatef(0, 0, -100);
    });
    glEnable(GL_CULL_FACE);
    asker.selection("culled", [] {
        glPushName(1);
        ring(GL_POLYGON, 8, 1);
        glCullFace(GL_FRONT);
        glLoadName(2);
        ring(GL_POLYGON, 8, 1);
    });
    glDisable(GL_CULL_FACE);
    asker.selection(
        "overflow", [] { ring(GL_POINTS, 8, 1); }, 2);
    GLuint word = 0;
    glSelectBuffer(-1, &word);
    asker.error("negative size");
    glSelectBuffer(1, &word);
    glRenderMode(GL_SELECT);
    glPopName();
    asker.error("underflow");
    glLoadName(1);
    asker.error("no name");
    glSelectBuffer(1, &word);
    asker.error("in use");
    glRenderMode(GL_RENDER);
    return asker.answers;
}

/// Feeds back lines and unclipped triangles only: GLs differ in polygons that are clipped or have more
/// vertices. Mesa does not flatten colours that it feeds back.
Answers feedback() {
    Asker asker;
    perspective();
    texture();
    glMatrixMode(GL_TEXTURE);
    glRotatef(20, 0, 0, 1);
    glScalef(2, 3, 1);
    glMatrixMode(GL_MODELVIEW);
    for (const GLenum type :
         std::initializer_list<GLenum>{GL_2D, GL_3D, GL_3D_COLOR, GL_3D_COLOR_TEXTURE, GL_4D_COLOR_TEXTURE})
        for (const GLenum mode :
             std::initializer_list<GLenum>{GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP, GL_TRIANGLES,
                                           GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN})
            asker.feedback("primitive " + std::to_string(mode) + " type " + std::to_string(type), type,
                           [mode] { ring(mode, 8, 1); });
    asker.feedback("cut lines", GL_4D_COLOR_TEXTURE, [] { ring(GL_LINES, 8, 8); });
    asker.feedback("markers", GL_2D, [] {
        glPassThrough(1.5f);
        ring(GL_POINTS, 2, 1);
        glPassThrough(-3);
    });
    asker.feedback(
        "overflow", GL_2D, [] { ring(GL_POINTS, 8, 1); }, 5);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    const GLfloat red[4] = {0.9f, 0.1f, 0.2f, 0.5f};
    glMaterialfv(GL_BACK, GL_DIFFUSE, red);
    glNormal3f(0.2f, 0.4f, 0.9f);
    asker.feedback("lit from both sides", GL_3D_COLOR, [] { ring(GL_TRIANGLE_STRIP, 8, 1); });
    GLfloat word = 0;
    glFeedbackBuffer(-1, GL_2D, &word);
    asker.error("negative size");
    glFeedbackBuffer(1, GL_RGBA, &word);
    asker.error("no type");
    return asker.answers;
}

Answers lists() {
    Asker asker;
    perspective();
    const GLuint base = glGenLists(70);
    for (GLuint i = 0; i < 70; ++i) { // makes a chain: each list calls the one before
        glNewList(base + i, GL_COMPILE);
        glPassThrough(static_cast<GLfloat>(i));
        if (i != 0)
            glCallList(base + i - 1);
        glEndList();
    }
    for (const GLuint top : {5u, 62u, 63u})
        asker.feedback("nested", GL_2D, [=] { glCallList(base + top); });
    const GLubyte bytes[] = {0, 3, 1, 2}, two[] = {0, 5, 0, 3}, three[] = {0, 0, 4}, four[] = {0, 0, 0, 2};
    const GLbyte negative[] = {-1, -2};
    const GLshort shorts[] = {2, -1};
    const GLfloat floats[] = {2.75f, 1.25f};
    asker.feedback("every type", GL_2D, [&] {
        glListBase(base);
        glCallLists(4, GL_UNSIGNED_BYTE, bytes);
        glCallLists(2, GL_2_BYTES, two);
        glCallLists(1, GL_3_BYTES, three);
        glCallLists(1, GL_4_BYTES, four);
        glCallLists(2, GL_FLOAT, floats);
        glListBase(base + 5);
        glCallLists(2, GL_BYTE, negative);
        glCallLists(2, GL_SHORT, shorts);
    });
    GLfloat v[] = {0, 0, 0.5f, 0, 0, 0.5f};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, v);
    glNewList(base, GL_COMPILE_AND_EXECUTE);
    glColor3f(0.25f, 0.5f, 0.75f);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glMatrixMode(0xDEAD);
    glEndList();
    asker.error("executed");
    glNewList(base + 1, GL_COMPILE);
    glMatrixMode(0xDEAD);
    glEndList();
    asker.error("compiled");
    glCallList(base + 1);
    asker.error("called");
    v[2] = 0.125f; // the list has read the arrays when it was compiled
    asker.feedback("arrays", GL_3D_COLOR, [=] { glCallList(base); });
    glNewList(0, GL_COMPILE);
    asker.error("list 0");
    glEndList();
    asker.error("no list");
    glDeleteLists(base, -1);
    asker.error("range");
    glDeleteLists(base, 2);
    asker.note("lists", {static_cast<double>(glIsList(base)), static_cast<double>(glIsList(base + 2))});
    return asker.answers;
}

} // namespace spangle::oracle

#include "tests/oracle/mesa/asker.hpp"

#include <algorithm>

namespace spangle::oracle {

void Asker::note(std::string question, std::vector<double> values) {
    answers.push_back({std::move(question), std::move(values)});
}
void Asker::error(const std::string& question) {
    note(question + " error", {static_cast<double>(glGetError())});
}

void Asker::state(GLenum name, int count) {
    GLdouble d[16] = {};
    GLfloat f[16] = {};
    GLint i[16] = {};
    GLboolean b[16] = {};
    glGetDoublev(name, d);
    glGetFloatv(name, f);
    glGetIntegerv(name, i);
    glGetBooleanv(name, b);
    std::vector<double> values(d, d + count);
    values.insert(values.end(), f, f + count);
    if (count != 16)
        values.insert(values.end(), i, i + count);
    values.insert(values.end(), b, b + count);
    note("state " + std::to_string(name), std::move(values));
}

void Asker::feedback(const std::string& question, GLenum type, const std::function<void()>& draw,
                     std::size_t size) {
    std::vector<GLfloat> buffer(size);
    glFeedbackBuffer(static_cast<GLsizei>(size), type, buffer.data());
    glRenderMode(GL_FEEDBACK);
    draw();
    const GLint count = glRenderMode(GL_RENDER);
    std::vector<double> values = {static_cast<double>(count)};
    for (GLint i = 0; i < count; ++i) { // without a stipple Mesa does not report line resets
        const GLfloat v = buffer[static_cast<std::size_t>(i)];
        values.push_back(v == GL_LINE_RESET_TOKEN ? GL_LINE_TOKEN : static_cast<double>(v));
    }
    note(question, std::move(values));
}

void Asker::selection(const std::string& question, const std::function<void()>& draw, std::size_t size) {
    std::vector<GLuint> buffer(size);
    glSelectBuffer(static_cast<GLsizei>(size), buffer.data());
    glRenderMode(GL_SELECT);
    glInitNames();
    draw();
    const GLint hits = glRenderMode(GL_RENDER);
    std::vector<double> values = {static_cast<double>(hits)};
    for (std::size_t at = 0, hit = 0; hit < static_cast<std::size_t>(std::max(hits, 0)); ++hit) {
        const GLuint names = buffer[at];
        values.push_back(names);
        for (int z = 1; z <= 2; ++z) // depth from 0 to 1
            values.push_back(buffer[at + static_cast<std::size_t>(z)] / 4294967295.0);
        for (GLuint n = 0; n < names; ++n)
            values.push_back(buffer[at + 3 + n]);
        at += 3 + names;
    }
    note(question, std::move(values));
}

void perspective() {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1, 1, -1, 1, 2, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0.1f, -0.2f, -5);
    glRotatef(30, 1, 0.5f, 0.25f);
}

void ring(GLenum mode, int n, float size) {
    static const float unit[8][2] = {{1, 0.1f},   {0.7f, 0.8f},   {-0.1f, 1}, {-0.8f, 0.6f},
                                     {-1, -0.2f}, {-0.6f, -0.7f}, {0.2f, -1}, {0.9f, -0.5f}};
    glBegin(mode);
    for (int i = 0; i < n; ++i) {
        const auto v = static_cast<float>(i) / 8;
        glColor4f(v, 1 - v, 0.5f, 0.25f + v / 2);
        glTexCoord4f(v, 2 * v, 3 - v, 1 + v);
        glVertex3f(size * unit[i][0], size * unit[i][1], v);
    }
    glEnd();
}

void texture() {
    const GLubyte texel[4] = {255, 255, 255, 255};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_2D);
}

} // namespace spangle::oracle

// Asks about texture images and objects: the error of every wrong argument, levels, parameters and
// environments, and images that are read back.
#include "tests/oracle/mesa/asker.hpp"

namespace spangle::oracle {

namespace {

void refused(Asker& ask, const std::string& question, const std::function<void()>& command) {
    command();
    ask.error(question);
}

void level(Asker& ask, const std::string& question, GLenum target, GLint n) {
    constexpr GLenum names[] = {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH, GL_TEXTURE_BORDER};
    std::vector<double> values;
    for (const GLenum name : names) {
        GLint i = -1;
        GLfloat f = -1;
        glGetTexLevelParameteriv(target, n, name, &i);
        glGetTexLevelParameterfv(target, n, name, &f);
        values.insert(values.end(), {static_cast<double>(i), static_cast<double>(f)});
    }
    ask.note(question, values);
    ask.error(question);
}

void wrong_images(Asker& ask) {
    static const GLubyte texels[4096] = {};
    const auto image = [&](const std::string& what, GLenum target, GLint n, GLint internal, GLsizei w,
                           GLsizei h, GLint border, GLenum format, GLenum type) {
        refused(ask, what, [=] { glTexImage2D(target, n, internal, w, h, border, format, type, texels); });
    };
    constexpr GLenum t = GL_TEXTURE_2D, rgba = GL_RGBA, bytes = GL_UNSIGNED_BYTE;
    image("level -1", t, -1, GL_RGBA, 4, 4, 0, rgba, bytes);
    image("level 40", t, 40, GL_RGBA, 1, 1, 0, rgba, bytes);
    image("width -1", t, 0, GL_RGBA, -1, 4, 0, rgba, bytes);
    image("height -1", t, 0, GL_RGBA, 4, -1, 0, rgba, bytes);
    image("border 2", t, 0, GL_RGBA, 4, 4, 2, rgba, bytes);
    image("border -1", t, 0, GL_RGBA, 4, 4, -1, rgba, bytes);
    image("huge", t, 0, GL_RGBA, 1 << 20, 1, 0, rgba, bytes);
    image("internal format 0", t, 0, 0, 4, 4, 0, rgba, bytes);
    image("internal format 5", t, 0, 5, 4, 4, 0, rgba, bytes);
    image("format 0", t, 0, GL_RGBA, 4, 4, 0, 0, bytes);
    image("type 0", t, 0, GL_RGBA, 4, 4, 0, rgba, 0);
    image("bitmap", t, 0, GL_RGBA, 4, 4, 0, rgba, GL_BITMAP);
    image("packed of four as three", t, 0, GL_RGBA, 4, 4, 0, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4);
    image("packed of three as four", t, 0, GL_RGBA, 4, 4, 0, rgba, GL_UNSIGNED_SHORT_5_6_5);
    image("depths into colours", t, 0, GL_RGBA, 4, 4, 0, GL_DEPTH_COMPONENT, bytes);
    image("colours into depths", t, 0, GL_DEPTH_COMPONENT, 4, 4, 0, rgba, bytes);
    image("target 1D", GL_TEXTURE_1D, 0, GL_RGBA, 4, 4, 0, rgba, bytes);
    image("target cube", GL_TEXTURE_CUBE_MAP, 0, GL_RGBA, 4, 4, 0, rgba, bytes);
    image("face not square", GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 4, 8, 0, rgba, bytes);
    image("empty", t, 0, GL_RGBA, 0, 0, 0, rgba, bytes);
    level(ask, "empty level", t, 0);
}

void parts(Asker& ask) {
    static const GLubyte texels[4096] = {};
    const auto part = [&](const std::string& what, GLint n, GLint x, GLint y, GLsizei w, GLsizei h) {
        refused(ask, what,
                [=] { glTexSubImage2D(GL_TEXTURE_2D, n, x, y, w, h, GL_RGBA, GL_UNSIGNED_BYTE, texels); });
    };
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    level(ask, "8 x 4", GL_TEXTURE_2D, 0);
    part("all", 0, 0, 0, 8, 4);
    part("none", 0, 3, 3, 0, 0);
    part("left", 0, -1, 0, 2, 2);
    part("below", 0, 0, -1, 2, 2);
    part("right", 0, 7, 0, 2, 2);
    part("above", 0, 0, 3, 2, 2);
    part("negative", 0, 0, 0, -1, 2);
    part("no level", 1, 0, 0, 1, 1);
    part("level -1", -1, 0, 0, 1, 1);
    refused(ask, "copy 1..4", [] { glCopyTexImage2D(GL_TEXTURE_2D, 0, 5, 0, 0, 4, 4, 0); });
    refused(ask, "copy border", [] { glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 2); });
    refused(ask, "copy negative", [] { glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, -4, 4, 0); });
    refused(ask, "copy beyond", [] { glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 5, 0, 0, 0, 4, 4); });
    refused(ask, "copy of 1D", [] { glCopyTexImage1D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 0); });
    GLubyte out[4096];
    refused(ask, "read level -1", [&] { glGetTexImage(GL_TEXTURE_2D, -1, GL_RGBA, GL_UNSIGNED_BYTE, out); });
    refused(ask, "read format 0", [&] { glGetTexImage(GL_TEXTURE_2D, 0, 0, GL_UNSIGNED_BYTE, out); });
    refused(ask, "read depths", [&] { glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, out); });
    refused(ask, "read cube", [&] { glGetTexImage(GL_TEXTURE_CUBE_MAP, 0, GL_RGBA, GL_UNSIGNED_BYTE, out); });
    refused(ask, "read proxy",
            [&] { glGetTexImage(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, out); });
}

void proxies(Asker& ask) {
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA8, 16, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    ask.error("proxy");
    level(ask, "proxy 16 x 32", GL_PROXY_TEXTURE_2D, 0);
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA8, 1 << 20, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    ask.error("proxy too large");
    level(ask, "proxy without image", GL_PROXY_TEXTURE_2D, 0);
    refused(ask, "bind proxy", [] { glBindTexture(GL_PROXY_TEXTURE_2D, 1); });
    refused(ask, "parameter of proxy",
            [] { glTexParameteri(GL_PROXY_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR); });
}

/// Reads back each base format by table 6.1. Luminance is R + G + B here, as with ReadPixels, and R in Mesa.
void read_back(Asker& ask) {
    const GLubyte texels[16] = {10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120, 130, 140, 150, 160};
    constexpr GLint internal[] = {GL_ALPHA8,     GL_LUMINANCE8, GL_LUMINANCE8_ALPHA8,
                                  GL_INTENSITY8, GL_RGB8,       GL_RGBA8};
    constexpr GLenum formats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_RGBA, GL_BGRA};
    for (const GLint i : internal) {
        glTexImage2D(GL_TEXTURE_2D, 0, i, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
        for (const GLenum format : formats) {
            GLubyte out[16] = {};
            glGetTexImage(GL_TEXTURE_2D, 0, format, GL_UNSIGNED_BYTE, out);
            ask.note("image of " + std::to_string(i) + " as " + std::to_string(format),
                     std::vector<double>(out, out + 16));
        }
    }
}

void parameters(Asker& ask) {
    const auto set = [&](const std::string& what, GLenum name, GLint v) {
        refused(ask, what, [=] { glTexParameteri(GL_TEXTURE_2D, name, v); });
        GLint i = -1;
        GLfloat f = -1;
        glGetTexParameteriv(GL_TEXTURE_2D, name, &i);
        glGetTexParameterfv(GL_TEXTURE_2D, name, &f);
        ask.note(what, {static_cast<double>(i), static_cast<double>(f)});
        ask.error(what + " query");
    };
    set("wrap", GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    set("wrap of a filter", GL_TEXTURE_WRAP_S, GL_LINEAR);
    set("mag of mipmaps", GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    set("min", GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    set("base -1", GL_TEXTURE_BASE_LEVEL, -1);
    set("base 3", GL_TEXTURE_BASE_LEVEL, 3);
    set("max -1", GL_TEXTURE_MAX_LEVEL, -1);
    set("min lod", GL_TEXTURE_MIN_LOD, -3);
    set("compare", GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    set("compare wrong", GL_TEXTURE_COMPARE_MODE, GL_LEQUAL);
    set("compare func", GL_TEXTURE_COMPARE_FUNC, GL_GREATER);
    set("depth mode", GL_DEPTH_TEXTURE_MODE, GL_INTENSITY);
    set("depth mode wrong", GL_DEPTH_TEXTURE_MODE, GL_RGB);
    set("generate", GL_GENERATE_MIPMAP, GL_TRUE);
    set("nonsense", GL_TEXTURE_ENV_MODE, GL_REPLACE);
    refused(ask, "colour as scalar", [] { glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 1); });
    refused(ask, "target",
            [] { glTexParameteri(GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_TEXTURE_WRAP_S, GL_REPEAT); });
}

void environments(Asker& ask) {
    const auto set = [&](const std::string& what, GLenum name, GLfloat v) {
        refused(ask, what, [=] { glTexEnvf(GL_TEXTURE_ENV, name, v); });
        GLint i[4] = {};
        glGetTexEnviv(GL_TEXTURE_ENV, name, i);
        ask.note(what, {static_cast<double>(i[0])});
        ask.error(what + " query");
    };
    set("mode", GL_TEXTURE_ENV_MODE, GL_DECAL);
    set("mode wrong", GL_TEXTURE_ENV_MODE, GL_ALWAYS);
    set("combine", GL_COMBINE_RGB, GL_DOT3_RGBA);
    set("combine alpha wrong", GL_COMBINE_ALPHA, GL_DOT3_RGB);
    set("source", GL_SOURCE1_RGB, GL_PRIMARY_COLOR);
    set("source of a unit", GL_SOURCE2_ALPHA, GL_TEXTURE1);
    set("source wrong", GL_SOURCE0_RGB, GL_SRC_COLOR);
    set("operand", GL_OPERAND0_RGB, GL_ONE_MINUS_SRC_ALPHA);
    set("operand alpha of a colour", GL_OPERAND0_ALPHA, GL_SRC_COLOR);
    set("scale", GL_RGB_SCALE, 4);
    set("scale 3", GL_RGB_SCALE, 3);
    set("scale 0", GL_ALPHA_SCALE, 0);
    set("nonsense", GL_TEXTURE_WRAP_S, GL_REPEAT);
    refused(ask, "target", [] { glTexEnvi(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, GL_REPLACE); });
    refused(ask, "unit beyond", [] { glActiveTexture(GL_TEXTURE0 + 4000); });
}

void objects(Asker& ask) {
    GLuint names[3] = {};
    glGenTextures(3, names);
    const auto is = [&](const std::string& what, GLuint name) {
        ask.note(what, {static_cast<double>(glIsTexture(name))});
    };
    is("reserved", names[0]);
    glBindTexture(GL_TEXTURE_2D, names[0]);
    is("bound", names[0]);
    refused(ask, "another dimension", [&] { glBindTexture(GL_TEXTURE_1D, names[0]); });
    refused(ask, "gen -1", [&] { glGenTextures(-1, names); });
    refused(ask, "delete -1", [&] { glDeleteTextures(-1, names); });
    GLint bound = -1;
    glDeleteTextures(1, names);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    ask.note("bound one deleted", {static_cast<double>(bound)});
    is("deleted", names[0]);
    is("zero", 0);
    glDeleteTextures(3, names);
    ask.error("deleted again");
}

} // namespace

Answers texture_images() {
    Asker ask;
    wrong_images(ask);
    parts(ask);
    proxies(ask);
    read_back(ask);
    return ask.answers;
}

Answers texture_parameters() {
    Asker ask;
    parameters(ask);
    environments(ask);
    objects(ask);
    return ask.answers;
}

} // namespace spangle::oracle

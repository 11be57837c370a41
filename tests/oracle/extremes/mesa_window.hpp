// An image of OSMesa with a context. Mesa has neither tiers nor fixed-point commands, so fixed-point numbers
// are handed over as doubles, which hold them exactly.
#pragma once

#include <cstddef>
#include <vector>

#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <GL/glext.h>

using GLfixed = GLint;
using EGLint = int;
inline constexpr EGLint EGL_PRECISION_FAST_SPANGLE = 2; // a token that no context of Mesa has

namespace spangle::test {

inline constexpr EGLint tiers[] = {0};

constexpr double of_fixed(GLfixed v) {
    return v / 65536.0;
}

/// A context that is current while the object lives.
class Window {
  public:
    Window(EGLint, int size, EGLint depth, EGLint red)
        : context_(OSMesaCreateContextExt(red == 8 ? OSMESA_RGBA : OSMESA_RGB_565, depth, 8, 0, nullptr)),
          pixels_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 4) {
        EXPECT_TRUE(OSMesaMakeCurrent(context_, pixels_.data(),
                                      red == 8 ? GL_UNSIGNED_BYTE : GL_UNSIGNED_SHORT_5_6_5, size, size));
    }
    ~Window() { OSMesaDestroyContext(context_); }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

  private:
    OSMesaContext context_;
    std::vector<unsigned char> pixels_;
};

} // namespace spangle::test

inline void glVertex4xOES(GLfixed x, GLfixed y, GLfixed z, GLfixed w) {
    using spangle::test::of_fixed;
    glVertex4d(of_fixed(x), of_fixed(y), of_fixed(z), of_fixed(w));
}
inline void glColor4xOES(GLfixed r, GLfixed g, GLfixed b, GLfixed a) {
    using spangle::test::of_fixed;
    glColor4d(of_fixed(r), of_fixed(g), of_fixed(b), of_fixed(a));
}
inline void glNormal3xOES(GLfixed x, GLfixed y, GLfixed z) {
    using spangle::test::of_fixed;
    glNormal3d(of_fixed(x), of_fixed(y), of_fixed(z));
}
inline void glTexCoord2xOES(GLfixed s, GLfixed t) {
    using spangle::test::of_fixed;
    glTexCoord2d(of_fixed(s), of_fixed(t));
}
inline void glTexCoord4xOES(GLfixed s, GLfixed t, GLfixed r, GLfixed q) {
    using spangle::test::of_fixed;
    glTexCoord4d(of_fixed(s), of_fixed(t), of_fixed(r), of_fixed(q));
}
inline void glRotatexOES(GLfixed angle, GLfixed x, GLfixed y, GLfixed z) {
    using spangle::test::of_fixed;
    glRotated(of_fixed(angle), of_fixed(x), of_fixed(y), of_fixed(z));
}
inline void glTranslatexOES(GLfixed x, GLfixed y, GLfixed z) {
    using spangle::test::of_fixed;
    glTranslated(of_fixed(x), of_fixed(y), of_fixed(z));
}
inline void glScalexOES(GLfixed x, GLfixed y, GLfixed z) {
    using spangle::test::of_fixed;
    glScaled(of_fixed(x), of_fixed(y), of_fixed(z));
}
inline void glFrustumxOES(GLfixed l, GLfixed r, GLfixed b, GLfixed t, GLfixed n, GLfixed f) {
    using spangle::test::of_fixed;
    glFrustum(of_fixed(l), of_fixed(r), of_fixed(b), of_fixed(t), of_fixed(n), of_fixed(f));
}
inline void glDepthRangef(GLfloat n, GLfloat f) {
    glDepthRange(double{n}, double{f});
}
inline void glDepthRangexOES(GLfixed n, GLfixed f) {
    glDepthRange(spangle::test::of_fixed(n), spangle::test::of_fixed(f));
}
inline void glPointSizexOES(GLfixed size) {
    glPointSize(static_cast<GLfloat>(spangle::test::of_fixed(size)));
}
inline void glPolygonOffsetxOES(GLfixed factor, GLfixed units) {
    glPolygonOffset(static_cast<GLfloat>(spangle::test::of_fixed(factor)),
                    static_cast<GLfloat>(spangle::test::of_fixed(units)));
}
inline void glLightxOES(GLenum light, GLenum name, GLfixed v) {
    glLightf(light, name, static_cast<GLfloat>(spangle::test::of_fixed(v)));
}
inline void glFogxOES(GLenum name, GLfixed v) {
    glFogf(name, static_cast<GLfloat>(spangle::test::of_fixed(v)));
}
inline void glClipPlanexOES(GLenum plane, const GLfixed* v) {
    using spangle::test::of_fixed;
    const GLdouble equation[] = {of_fixed(v[0]), of_fixed(v[1]), of_fixed(v[2]), of_fixed(v[3])};
    glClipPlane(plane, equation);
}
inline void glClipPlanefOES(GLenum plane, const GLfloat* v) {
    const GLdouble equation[] = {double{v[0]}, double{v[1]}, double{v[2]}, double{v[3]}};
    glClipPlane(plane, equation);
}

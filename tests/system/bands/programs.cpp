#include "tests/system/bands/programs.hpp"

#include <array>
#include <cmath>

namespace spangle::test {
void start_program(int w, int h) {
    glViewport(0, 0, w, h);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, w, 0, h, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

namespace {

void clear(float r, float g, float b) {
    glClearColor(r, g, b, 1.F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT);
}

/// Draws some triangles of all sizes.
void triangles(int frame, float z = 0.F) {
    std::uint32_t seed = 12345 + static_cast<std::uint32_t>(frame);
    const auto next = [&](int limit) {
        seed = seed * 1664525 + 1013904223;
        return static_cast<float>(seed >> 8 & 0xFFFF) * static_cast<float>(limit) / 65536.F;
    };
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 90; ++i) {
        glColor4f(next(1), next(1), next(1), next(1));
        const float size = i % 9 == 0 ? 120.F : 9.F;
        const float x = next(160), y = next(80);
        for (int k = 0; k < 3; ++k)
            glVertex3f(x + next(1) * size - size / 2, y + next(1) * size - size / 2, z + next(1));
    }
    glEnd();
}

void lines(int frame) {
    glBegin(GL_LINE_STRIP);
    for (int i = 0; i < 60; ++i) {
        glColor3f(static_cast<float>(i % 7) / 7, static_cast<float>(i % 5) / 5, 1.F);
        glVertex2f(static_cast<float>(i * 53 % 161) + 0.3F * static_cast<float>(frame),
                   static_cast<float>(i * 37 % 83) + 0.4F);
    }
    glEnd();
}

void points() {
    glBegin(GL_POINTS);
    for (int i = 0; i < 80; ++i) {
        glColor3f(1.F, static_cast<float>(i % 9) / 9, 0.2F);
        glVertex2f(static_cast<float>(i * 61 % 160) + 0.6F, static_cast<float>(i * 41 % 80) + 0.1F);
    }
    glEnd();
}

/// Returns 16 x 16 pixels of all colours.
const std::array<GLubyte, 1024>& image() {
    static const auto made = [] {
        std::array<GLubyte, 1024> bytes{};
        for (unsigned i = 0; i < 256; ++i) {
            bytes[4 * i] = static_cast<GLubyte>(i);
            bytes[4 * i + 1] = static_cast<GLubyte>(i * 7);
            bytes[4 * i + 2] = static_cast<GLubyte>(255 - i);
            bytes[4 * i + 3] = static_cast<GLubyte>(i * 3);
        }
        return bytes;
    }();
    return made;
}

void textured(int frame) {
    glEnable(GL_TEXTURE_2D);
    glBegin(GL_QUADS);
    glColor3f(1.F, 1.F, 1.F);
    for (const auto& [s, t] : {std::pair{0.F, 0.F}, {3.F, 0.F}, {3.F, 2.F}, {0.F, 2.F}}) {
        glTexCoord2f(s + 0.1F * static_cast<float>(frame), t);
        glVertex2f(5.F + s * 48.7F, 3.F + t * 36.1F);
    }
    glEnd();
    glDisable(GL_TEXTURE_2D);
}

void make_texture() {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, image().data());
}

Program dithered(bool dither) {
    return {dither ? "dither" : "no dither",
            [dither](int w, int h) {
                start_program(w, h);
                (dither ? glEnable : glDisable)(GL_DITHER);
            },
            [](int f) {
                clear(0.31F, 0.17F, 0.77F);
                triangles(f);
            }};
}

Program stippled() {
    return {"stipple", start_program, [](int f) {
                clear(0, 0, 0);
                static std::array<GLubyte, 128> pattern;
                for (unsigned i = 0; i < 128; ++i)
                    pattern[i] = static_cast<GLubyte>(i * 37 ^ i >> 2);
                glPolygonStipple(pattern.data());
                glEnable(GL_POLYGON_STIPPLE);
                triangles(f);
                glDisable(GL_POLYGON_STIPPLE);
                glEnable(GL_LINE_STIPPLE);
                glLineStipple(3, 0xC5A7);
                lines(f);
                glLineWidth(4.F);
                lines(f + 3);
                glLineWidth(1.F);
                glDisable(GL_LINE_STIPPLE);
            }};
}

Program wide() {
    return {"wide", start_program, [](int f) {
                clear(0.1F, 0, 0);
                lines(f);
                glLineWidth(5.F);
                lines(f + 1);
                glPointSize(7.F);
                points();
                glPointSize(1.F);
                glLineWidth(1.F);
                points();
            }};
}

Program smooth() {
    return {"smooth", start_program, [](int f) {
                clear(0, 0, 0.2F);
                glEnable(GL_BLEND);
                glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
                for (const GLenum cap : {GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH})
                    glEnable(cap);
                triangles(f);
                glLineWidth(2.5F);
                lines(f);
                glEnable(GL_LINE_STIPPLE);
                glLineStipple(2, 0x3C5A);
                lines(f + 4);
                glDisable(GL_LINE_STIPPLE);
                glPointSize(5.5F);
                points();
                for (const GLenum cap : {GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH, GL_BLEND})
                    glDisable(cap);
                glLineWidth(1.F);
                glPointSize(1.F);
            }};
}

/// Polygons with more vertices than an item of a record has; stippled, flat, with an offset.
Program polygons() {
    return {"polygons", start_program, [](int f) {
                clear(0.1F, 0.1F, 0);
                std::array<GLubyte, 128> pattern;
                pattern.fill(0x6D);
                glPolygonStipple(pattern.data());
                glEnable(GL_POLYGON_SMOOTH);
                glEnable(GL_BLEND);
                glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
                glEnable(GL_DEPTH_TEST);
                for (int n = 0; n < 6; ++n) {
                    (n % 2 != 0 ? glEnable : glDisable)(GL_POLYGON_STIPPLE);
                    (n % 3 != 0 ? glEnable : glDisable)(GL_POLYGON_OFFSET_FILL);
                    glPolygonOffset(0, n % 3 == 1 ? 3e6F : -3e6F);
                    glShadeModel(n == 4 ? GL_FLAT : GL_SMOOTH);
                    const float x = 30.F + 13.F * static_cast<float>(n),
                                y = 20.F + 5.F * static_cast<float>(n);
                    glBegin(GL_POLYGON);
                    for (int i = 0; i < 40; ++i) {
                        const float t = static_cast<float>(i + f) * 0.157F;
                        glColor4f(0.5F + 0.5F * std::cos(t), 0.5F + 0.5F * std::sin(t),
                                  0.2F * static_cast<float>(n % 5), 1);
                        glVertex3f(x + 20 * std::cos(t), y + 15 * std::sin(t), -0.5F);
                    }
                    glEnd();
                }
                for (const GLenum cap :
                     {GL_POLYGON_SMOOTH, GL_BLEND, GL_DEPTH_TEST, GL_POLYGON_STIPPLE, GL_POLYGON_OFFSET_FILL})
                    glDisable(cap);
                glShadeModel(GL_SMOOTH);
            }};
}

Program pixels() {
    return {"pixels", start_program, [](int f) {
                clear(0.3F, 0.3F, 0.3F);
                glColor3f(1.F, 0.5F, 0.F); // the colour of the raster positions
                glRasterPos2f(10.F + static_cast<float>(f), 11.F);
                glPixelZoom(2.5F, 3.25F);
                glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, image().data());
                glPixelZoom(1.F, -1.F);
                glEnable(GL_BLEND);
                glBlendFunc(GL_SRC_ALPHA, GL_ONE);
                glRasterPos2f(70.F, 60.F);
                glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, image().data());
                glDisable(GL_BLEND);
                glPixelZoom(1.F, 1.F);
                glRasterPos2f(100.F, 5.F);
                glDrawPixels(16, 16, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, image().data());
                glEnable(GL_DEPTH_TEST);
                glRasterPos2f(130.F, 40.F);
                glDrawPixels(8, 8, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, image().data());
                triangles(f);
                glDisable(GL_DEPTH_TEST);
                // Fractions between whole 255ths, which a record must not truncate: 247.6 is 31 of 31, 247 is
                // 30.
                std::array<GLfloat, 192> parts;
                for (std::size_t i = 0; i < parts.size(); ++i)
                    parts[i] = (static_cast<float>(i / 6) * 8.F + 7.6F) / 255.F;
                glRasterPos2f(140.F, 60.F);
                glDrawPixels(8, 8, GL_RGB, GL_FLOAT, parts.data());
                glColor3f(1.F, 1.F, 0.F);
                glRasterPos2f(30.F, 40.F);
                glBitmap(32, 30, 0, 0, 0, 0, image().data());
            }};
}

Program stencilled() {
    return {"stencil", start_program, [](int f) {
                clear(0, 0, 0);
                glEnable(GL_STENCIL_TEST);
                glStencilFunc(GL_ALWAYS, 1, 0xFF);
                glStencilOp(GL_KEEP, GL_INCR, GL_INCR);
                triangles(f);
                glRasterPos2f(100.F, 13.F);
                glDrawPixels(16, 16, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, image().data());
                glStencilFunc(GL_LESS, 1, 0xFF);
                glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
                triangles(f + 7);
                glDisable(GL_STENCIL_TEST);
            }};
}

Program blended() {
    return {"blend",
            [](int w, int h) {
                start_program(w, h);
                make_texture();
            },
            [](int f) {
                clear(0.2F, 0.4F, 0.6F);
                textured(f);
                glEnable(GL_BLEND);
                glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
                triangles(f);
                glDisable(GL_BLEND);
                glEnable(GL_COLOR_LOGIC_OP);
                glLogicOp(GL_XOR);
                triangles(f + 5);
                glDisable(GL_COLOR_LOGIC_OP);
                glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
                glEnable(GL_SCISSOR_TEST);
                glScissor(20, 17, 70, 30);
                clear(0.5F, 1.F, 0.F);
                triangles(f + 6);
                glDisable(GL_SCISSOR_TEST);
                glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
            }};
}

Program accumulated() {
    return {"accumulation", start_program, [](int f) {
                for (int pass = 0; pass < 3; ++pass) {
                    clear(0.1F, 0.2F, 0.3F);
                    triangles(f + pass);
                    glAccum(pass == 0 ? GL_LOAD : GL_ACCUM, 0.33F);
                }
                glAccum(GL_ADD, 0.05F);
                glAccum(GL_MULT, 0.9F);
                glAccum(GL_RETURN, 1.F);
            }};
}

Program outlined() {
    return {"outline", start_program, [](int f) {
                clear(0, 0, 0);
                glEnable(GL_DEPTH_TEST);
                glEnable(GL_POLYGON_OFFSET_FILL);
                glPolygonOffset(1.F, 2.F);
                triangles(f);
                glDisable(GL_POLYGON_OFFSET_FILL);
                glShadeModel(GL_FLAT);
                glBegin(GL_QUAD_STRIP);
                for (int i = 0; i < 12; ++i) {
                    glColor3f(static_cast<float>(i % 5) / 5, static_cast<float>(i % 3) / 3, 0.5F);
                    glVertex3f(static_cast<float>(i / 2) * 29.F, i % 2 == 0 ? 11.F : 38.F, 0.2F);
                }
                glEnd();
                glShadeModel(GL_SMOOTH);
                glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
                triangles(f);
                glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
                glDisable(GL_DEPTH_TEST);
            }};
}

/// State of samples; on surfaces without samples it has no effect.
Program sampled() {
    return {"samples", start_program, [](int f) {
                clear(0.1F, 0.3F, 0.2F);
                glEnable(GL_DEPTH_TEST);
                triangles(f);
                glDisable(GL_DEPTH_TEST);
                glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
                glEnable(GL_SAMPLE_ALPHA_TO_ONE);
                triangles(f + 2);
                glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
                glDisable(GL_SAMPLE_ALPHA_TO_ONE);
                glEnable(GL_SAMPLE_COVERAGE);
                glSampleCoverage(0.4F, GL_TRUE);
                glPixelZoom(3.3F, 2.7F);
                glRasterPos2f(90.4F, 20.7F);
                glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, image().data());
                glPixelZoom(1.F, 1.F);
                glDisable(GL_SAMPLE_COVERAGE);
                glPointSize(6.5F);
                points();
                glEnable(GL_LINE_STIPPLE);
                glLineStipple(2, 0x35A3);
                glLineWidth(3.5F);
                lines(f);
                glDisable(GL_LINE_STIPPLE);
                glDisable(GL_MULTISAMPLE);
                lines(f + 1);
                points();
                glRasterPos2f(20.F, 50.F);
                glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, image().data());
                glEnable(GL_MULTISAMPLE);
                glLineWidth(1.F);
                glPointSize(1.F);
            }};
}

/// Viewports beside each other within the window: primitives of a view volume end at its viewport, in every
/// band.
Program viewports() {
    return {"viewports", start_program, [](int f) {
                clear(0.2F, 0.1F, 0);
                glPushAttrib(GL_VIEWPORT_BIT | GL_LINE_BIT | GL_POINT_BIT | GL_POLYGON_BIT);
                for (int n = 0; n < 4; ++n) {
                    if (n < 3)
                        glViewport(7 + 45 * n + f, 5 + 7 * n, 37, 41);
                    else // some bands lie inside of this rectangle
                        glViewport(0, 29, 160, 40);
                    glPushMatrix();
                    glScalef(3.F, 2.F, 1.F);
                    glTranslatef(-60.F, -20.F, 0.F);
                    triangles(f + n);
                    glLineWidth(1.F + 4.F * static_cast<float>(n));
                    lines(f);
                    glPointSize(1.F + 5.F * static_cast<float>(n));
                    points();
                    glPolygonMode(GL_FRONT, n == 1 ? GL_LINE : GL_FILL);
                    triangles(f + 3 * n);
                    glPopMatrix();
                }
                glPopAttrib();
                triangles(f + 5);
            }};
}

} // namespace

const std::vector<Program>& programs() {
    static const std::vector<Program> all = {
        dithered(true), dithered(false), stippled(),    wide(),     smooth(),  pixels(),   stencilled(),
        blended(),      polygons(),      accumulated(), outlined(), sampled(), viewports()};
    return all;
}

} // namespace spangle::test

// Asks about vertices: raster positions, lighting, generated coordinates, clip planes.
#include <cmath>
#include <initializer_list>
#include <random>

#include "tests/oracle/mesa/asker.hpp"

namespace spangle::oracle {

namespace {

/// Random numbers that are the same everywhere.
class Numbers {
  public:
    float operator()(float low, float high) {
        return low + (high - low) * static_cast<float>(random_() >> 8) / 16777216.0f;
    }
    bool flip() { return (random_() & 1) != 0; }

  private:
    std::mt19937 random_{29};
};

void note_raster_position(Asker& asker, const std::string& question) {
    GLfloat v[12] = {};
    GLint valid = 0;
    glGetIntegerv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
    std::vector<double> values = {static_cast<double>(valid)};
    if (valid != 0) { // an invalid raster position has no other values
        glGetFloatv(GL_CURRENT_RASTER_POSITION, v);
        glGetFloatv(GL_CURRENT_RASTER_COLOR, v + 4);
        glGetFloatv(GL_CURRENT_RASTER_TEXTURE_COORDS, v + 8);
        values.insert(values.end(), v, v + 12);
    }
    asker.note(question, std::move(values));
}

void directional_light() {
    const GLfloat from[4] = {0.3f, 0.5f, 1, 0}, material[4] = {0.9f, 0.6f, 0.3f, 0.7f};
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, from);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, material);
}

} // namespace

/// The distance is not compared: Mesa's is that from the eye, Spangle's is |z_e| (GL 1.3, 3.10 allows both).
Answers raster_positions() {
    Asker asker;
    Numbers number;
    perspective();
    texture();
    glDepthRange(0.25, 0.75);
    const GLdouble plane[4] = {1, 0.25, 0, 0.5};
    glClipPlane(GL_CLIP_PLANE1, plane);
    for (int kind = 0; kind < 4; ++kind) {
        if (kind == 1)
            glEnable(GL_CLIP_PLANE1);
        if (kind == 2)
            directional_light();
        if (kind == 3)
            for (const GLenum coord : std::initializer_list<GLenum>{GL_S, GL_T}) {
                const GLfloat equation[4] = {0.5f, coord == GL_S ? 1.0f : 0, 0.25f, 0.125f};
                glTexGenfv(coord, GL_OBJECT_PLANE, equation);
                glTexGeni(coord, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
                glEnable(coord == GL_S ? GL_TEXTURE_GEN_S : GL_TEXTURE_GEN_T);
            }
        for (int i = 0; i < 60; ++i) {
            glColor4f(number(0, 1), number(0, 1), number(0, 1), number(0, 1));
            glNormal3f(0, 0.6f, 0.8f);
            glTexCoord4f(number(-2, 2), number(-2, 2), number(-2, 2), 1);
            const float x = number(-4, 4), y = number(-4, 4), z = number(-4, 4), w = number(0.5f, 2);
            i % 3 == 0   ? glRasterPos2f(x, y)
            : i % 3 == 1 ? glRasterPos3f(x, y, z)
                         : glRasterPos4f(x * w, y * w, z * w, w);
            note_raster_position(asker, "position " + std::to_string(kind));
        }
    }
    glDisable(GL_LIGHTING);
    for (int i = 0; i < 20; ++i) {
        glColor4f(number(0, 1), number(0, 1), number(0, 1), number(0, 1));
        i % 2 == 0 ? glWindowPos2f(number(-100, 100), number(-100, 100))
                   : glWindowPos3f(number(-100, 100), number(-100, 100), number(-1, 2));
        note_raster_position(asker, "window position");
    }
    return asker.answers;
}

/// Lights of every kind on points and on both sides of triangles. Exponents have exact powers, and steep ones
/// are used only where the highlight is not at the limit of a float's power.
Answers lighting() {
    Asker asker;
    Numbers number;
    perspective();
    glEnable(GL_LIGHTING);
    glEnable(GL_NORMALIZE);
    const auto color = [&](GLenum light, GLenum name) {
        const GLfloat v[4] = {number(0, 0.4f), number(0, 0.4f), number(0, 0.4f), 1};
        glLightfv(light, name, v);
    };
    const auto material = [&](GLenum face, GLenum name) {
        const GLfloat v[4] = {number(0, 1), number(0, 1), number(0, 1), number(0, 1)};
        glMaterialfv(face, name, v);
    };
    for (int scene = 0; scene < 60; ++scene) {
        for (GLenum light = GL_LIGHT0; light < GL_LIGHT0 + 3; ++light) {
            (light == GL_LIGHT0 || number.flip() ? glEnable : glDisable)(light);
            for (const GLenum name : std::initializer_list<GLenum>{GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR})
                color(light, name);
            const GLfloat at[4] = {number(-3, 3), number(-3, 3), number(-1, 3), number.flip() ? 1.0f : 0.0f};
            const GLfloat toward[3] = {-at[0], -at[1], -at[2] - 0.5f};
            glLightfv(light, GL_POSITION, at);
            glLightfv(light, GL_SPOT_DIRECTION, toward);
            const int spot = scene % 4; // cutoffs 180 and 90, exponents 0 and 128, and values between
            glLightf(light, GL_SPOT_CUTOFF, spot == 0 ? 180.0f : spot == 1 ? 90.0f : 60.0f);
            glLightf(light, GL_SPOT_EXPONENT, spot == 1 ? 0.0f : spot == 2 ? 128.0f : 1.0f);
            glLightf(light, GL_LINEAR_ATTENUATION, number(0, 0.2f));
            glLightf(light, GL_QUADRATIC_ATTENUATION, number(0, 0.1f));
        }
        for (const GLenum face : std::initializer_list<GLenum>{GL_FRONT, GL_BACK}) {
            for (const GLenum name :
                 std::initializer_list<GLenum>{GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION})
                material(face, name);
            const float shininess[4] = {2, 1, 8, 128}; // for 0 Mesa takes 0^0 as 0 (GL 1.3, 2.13.1: 1)
            glMaterialf(face, GL_SHININESS, shininess[scene / 4 % 4]);
        }
        glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, scene / 2 % 2);
        glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, scene % 2);
        glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                      scene % 5 == 0 ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
        const bool tracked = scene % 3 == 0; // on GL_BACK alone Mesa loses green and blue
        glColorMaterial(scene % 2 == 0 ? GL_FRONT_AND_BACK : GL_FRONT, GL_DIFFUSE);
        (tracked ? glEnable : glDisable)(GL_COLOR_MATERIAL);
        const auto corner = [&](float x, float y) {
            glColor4f(number(0, 1), number(0, 1), number(0, 1), number(0, 1));
            glNormal3f(number(-0.5f, 0.5f), number(-0.5f, 0.5f), number(0.2f, 1));
            glVertex3f(x, y, number(-0.5f, 0.5f));
        };
        asker.feedback("points", GL_3D_COLOR, [&] {
            glBegin(GL_POINTS);
            for (int i = 0; i < 6; ++i)
                corner(number(-1, 1), number(-1, 1));
            glEnd();
        });
        asker.feedback("both sides", GL_3D_COLOR, [&] {
            glBegin(GL_TRIANGLES);
            for (int side = 0; side < 2; ++side) {
                corner(-0.5f, -0.5f);
                corner(side == 0 ? 0.5f : -0.5f, side == 0 ? -0.5f : 0.5f);
                corner(side == 0 ? -0.5f : 0.5f, side == 0 ? 0.5f : -0.5f);
            }
            glEnd();
        });
        glDisable(GL_COLOR_MATERIAL);
        for (const GLenum face : std::initializer_list<GLenum>{GL_FRONT, GL_BACK})
            for (const GLenum name :
                 std::initializer_list<GLenum>{GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}) {
                GLfloat v[4] = {};
                glGetMaterialfv(face, name, v);
                asker.note("material", {v, v + 4});
            }
    }
    return asker.answers;
}

Answers generated_coordinates() {
    Asker asker;
    Numbers number;
    perspective();
    texture();
    glEnable(GL_NORMALIZE);
    for (const GLenum mode : std::initializer_list<GLenum>{GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP,
                                                           GL_REFLECTION_MAP, GL_NORMAL_MAP}) {
        const GLenum last = mode == GL_SPHERE_MAP       ? GL_T
                            : mode == GL_REFLECTION_MAP ? GL_R
                            : mode == GL_NORMAL_MAP     ? GL_R
                                                        : GL_Q;
        for (GLenum coord = GL_S; coord <= last; ++coord) {
            glTexGeni(coord, GL_TEXTURE_GEN_MODE, static_cast<GLint>(mode));
            const GLfloat plane[4] = {number(-1, 1), number(-1, 1), number(-1, 1), number(0.5f, 1)};
            glTexGenfv(coord, GL_OBJECT_PLANE, plane);
            glPushMatrix();
            glRotatef(number(-90, 90), number(-1, 1), 1, number(-1, 1));
            glTexGenfv(coord, GL_EYE_PLANE, plane);
            glPopMatrix();
            GLdouble kept[4] = {};
            glGetTexGendv(coord, GL_EYE_PLANE, kept);
            asker.note("eye plane", {kept, kept + 4});
            glEnable(GL_TEXTURE_GEN_S + coord - GL_S);
        }
        asker.feedback("mode " + std::to_string(mode), GL_4D_COLOR_TEXTURE, [&] {
            glBegin(GL_POINTS);
            for (int i = 0; i < 20; ++i) {
                glTexCoord4f(number(-2, 2), number(-2, 2), number(-2, 2), number(0.5f, 2));
                glNormal3f(number(-1, 1), number(-1, 1), number(0.1f, 1));
                glVertex3f(number(-1, 1), number(-1, 1), number(-1, 1));
            }
            glEnd();
        });
        for (GLenum coord = GL_S; coord <= GL_Q; ++coord)
            glDisable(GL_TEXTURE_GEN_S + coord - GL_S);
    }
    return asker.answers;
}

/// Lines are cut by planes and by their complements. Mesa cuts from the end that is inside, so its place is
/// rounded in another way.
Answers clip_planes() {
    Asker asker;
    Numbers number;
    perspective();
    for (int scene = 0; scene < 30; ++scene) {
        GLdouble plane[4], other[4];
        for (int i = 0; i < 4; ++i) {
            plane[i] = static_cast<double>(number(-1, 1));
            other[i] = -plane[i];
        }
        const GLenum which = GL_CLIP_PLANE0 + static_cast<GLenum>(scene % 6);
        float at[8][3];
        for (float(&v)[3] : at)
            for (float& c : v)
                c = number(-1, 1);
        glEnable(which);
        for (const GLdouble* equation : {plane, other}) {
            glClipPlane(which, equation);
            GLdouble kept[4] = {};
            glGetClipPlane(which, kept);
            asker.note("plane", {kept, kept + 4});
            asker.feedback("lines", GL_3D_COLOR, [&] {
                glBegin(GL_LINES);
                for (int i = 0; i < 8; ++i) {
                    glColor4f(static_cast<float>(i) / 8, 1 - static_cast<float>(i) / 8, 0.5f, 1);
                    glVertex3fv(at[i]);
                }
                glEnd();
            });
            asker.feedback("points", GL_2D, [&] {
                glBegin(GL_POINTS);
                for (const float(&v)[3] : at)
                    glVertex3fv(v);
                glEnd();
            });
        }
        glDisable(which);
    }
    return asker.answers;
}

} // namespace spangle::oracle

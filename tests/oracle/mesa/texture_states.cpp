// Texturing (GL 1.3, 3.8; GL 1.4, 3.8.8, 3.8.13, 3.8.14): rectangles with any texture, coordinates, levels
// and environments.
#include <algorithm>
#include <cmath>

#include "tests/oracle/mesa/random_texture.hpp"
#include "tests/oracle/mesa/state_families.hpp"

namespace spangle::oracle {

namespace {

using test::Random;

/// The plane a x + b y + c over the window.
struct Plane {
    double a = 0, b = 0, c = 0;
    double at(double x, double y) const { return a * x + b * y + c; }
};

struct Rectangle {
    int x0, y0, x1, y1;
    explicit Rectangle(Random& random) {
        x0 = whole(random, 0, state_size - 4), y0 = whole(random, 0, state_size - 4);
        x1 = whole(random, x0 + 2, state_size), y1 = whole(random, y0 + 2, state_size);
    }
};

/// The coordinates s, t, r, q of a texture unit.
struct Coordinates {
    Plane texel[3]; ///< u, v, w of level 0; for a cube map's face u and v
    int size[3];
    int face = -1; ///< face of a cube map; -1: none
    Plane q{0, 0, 1};
    double times = 1; ///< factor of s, t and r

    void of_vertex(GLenum unit, double x, double y) const {
        double c[3];
        for (int axis = 0; axis < 3; ++axis)
            c[axis] = texel[axis].at(x, y) / size[axis];
        if (face >= 0)
            turn_to_face(c);
        glMultiTexCoord4d(unit, c[0] * times, c[1] * times, c[2] * times, q.at(x, y));
    }

  private:
    /// Turns coordinates on a face into a direction (GL 1.3, table 3.20).
    void turn_to_face(double (&c)[3]) const {
        const double sc = 2 * c[0] - 1, tc = 2 * c[1] - 1;
        const double directions[6][3] = {{1, -tc, -sc}, {-1, -tc, sc}, {sc, 1, tc},
                                         {sc, -1, -tc}, {sc, -tc, 1},  {-sc, -tc, -1}};
        std::copy_n(directions[face], 3, c);
    }
};

/// From pixel to pixel coordinates move by multiples of 1/8 texel, or by 2^n, whose log2 is exact. No pixel's
/// centre is nearer to a texel's edge than 1/128, and all weights of level 0 are 256ths.
Coordinates affine(Random& random, const RandomTexture& texture, const Rectangle& at, bool powers) {
    Coordinates out;
    std::copy_n(texture.size, 3, out.size);
    const auto step = [&] {
        const double sign = maybe(random) ? 1 : -1;
        return powers ? sign * std::ldexp(1.0, whole(random, -4, 3)) * (often(random, 3) ? 1 : 0)
                      : whole(random, -24, 24) / 8.0;
    };
    if (texture.cube())
        out.face = whole(random, 0, 5);
    for (int axis = 0; axis < texture.dimensions(); ++axis) {
        Plane& plane = out.texel[axis];
        for (int tries = 0; tries < 40; ++tries) {
            plane.a = step(), plane.b = step();
            plane.c = whole(random, -32 * out.size[axis], 48 * out.size[axis]) / 16.0 + 1 / 128.0;
            if (powers) // halves of a step stay on the same grid
                plane.c -= (plane.a + plane.b) / 2;
            if (!texture.cube())
                break;
            const auto inside = [&](double x, double y) {
                return plane.at(x, y) > 0 && plane.at(x, y) < out.size[axis];
            };
            if (inside(at.x0, at.y0) && inside(at.x1, at.y0) && inside(at.x0, at.y1) && inside(at.x1, at.y1))
                break;
            plane = {0, 0, whole(random, 0, 16 * out.size[axis] - 1) / 16.0 + 1 / 128.0};
        }
    }
    constexpr double qs[] = {1, 1, 2, 0.5, 3};
    if (!texture.cube())
        out.q.c = out.times = one_of(random, qs);
    return out;
}

/// Returns any planes that keep q above 0; for a cube map s, t and r. No pixel's centre meets the middle of a
/// texel, where Mesa's MIRRORED_REPEAT takes another texel, nor an edge of a cube.
Coordinates projective(Random& random, const RandomTexture& texture) {
    Coordinates out;
    std::copy_n(texture.size, 3, out.size);
    const auto any = [&](double most) { return most * whole(random, -1000, 1000) / 1000; };
    for (int axis = 0; axis < 3; ++axis)
        out.texel[axis] = {any(1.5), any(1.5), any(1.5 * out.size[axis]) + 0.000371 * (axis + 1)};
    out.q = {0.02 * whole(random, 0, 10), 0.02 * whole(random, 0, 10), 0.5 + 0.01 * whole(random, 0, 300)};
    return out;
}

void draw(const Rectangle& at, const Coordinates* coordinates, int units) {
    const int corners[4][2] = {{at.x0, at.y0}, {at.x1, at.y0}, {at.x1, at.y1}, {at.x0, at.y1}};
    glBegin(GL_QUADS);
    for (const auto& [x, y] : corners) {
        for (int unit = 0; unit < units; ++unit)
            coordinates[unit].of_vertex(GL_TEXTURE0 + static_cast<GLenum>(unit), x, y);
        glVertex2i(x, y);
    }
    glEnd();
}

void color(Random& random) {
    const GLfloat r = unit(random), g = unit(random), b = unit(random), a = unit(random);
    glColor4f(r, g, b, a);
}

/// Shows the colour that the unit gets, with what a base format lacks.
void show_texture() {
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_REPLACE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_REPLACE);
}

void start(Random& random) {
    glClearColor(0.2f, 0.4f, 0.6f, 0.8f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    color(random);
}

void images(Random& random, Quads&) {
    start(random);
    show_texture();
    for (int i = 0; i < 3; ++i) {
        const RandomTexture texture(random, {});
        glEnable(texture.target);
        for (int k = 0; k < 3; ++k) {
            const Rectangle at(random);
            const Coordinates coordinates = affine(random, texture, at, false);
            draw(at, &coordinates, 1);
        }
        glDisable(texture.target);
    }
}

/// lambda is never at a border between levels or filters: it is an odd number of 16ths. Where LINEAR
/// magnification ends, Mesa does not take the minification into account (c = 1/2, GL 1.3, 3.8.8).
void lod(Random& random, const RandomTexture& texture) {
    const auto sixteenths = [&](int low, int high) {
        return static_cast<GLfloat>(2 * whole(random, low, high) + 1) / 16;
    };
    const auto set = [&](GLenum name, GLfloat v) { glTexParameterf(texture.target, name, v); };
    if (maybe(random))
        set(GL_TEXTURE_MIN_LOD, sixteenths(-8, 16));
    if (maybe(random))
        set(GL_TEXTURE_MAX_LOD, sixteenths(16, 32));
    if (texture.linear &&
        (texture.min == GL_NEAREST_MIPMAP_NEAREST || texture.min == GL_NEAREST_MIPMAP_LINEAR))
        set(GL_TEXTURE_MIN_LOD, sixteenths(4, 16));
    set(GL_TEXTURE_LOD_BIAS, sixteenths(-16, 16));
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, static_cast<GLfloat>(whole(random, -8, 8)) / 8);
    if (random.below(4) == 0)
        glTexParameteri(texture.target, GL_TEXTURE_MAX_LEVEL, whole(random, 1, 5));
}

void levels(Random& random, bool powers) {
    start(random);
    show_texture();
    for (int i = 0; i < 3; ++i) {
        RandomTexture::Wishes wishes;
        wishes.mipmaps = true;
        const RandomTexture texture(random, wishes);
        lod(random, texture);
        glEnable(texture.target);
        for (int k = 0; k < 3; ++k) {
            const Rectangle at(random);
            const Coordinates coordinates = affine(random, texture, at, powers);
            draw(at, &coordinates, 1);
        }
        glDisable(texture.target);
    }
}

/// Uses LINEAR, whose colours do not jump from texel to texel.
void perspective(Random& random, Quads&) {
    start(random);
    show_texture();
    for (int i = 0; i < 3; ++i) {
        const RandomTexture texture(random, {});
        glTexParameteri(texture.target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(texture.target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glEnable(texture.target);
        const Rectangle at(random);
        const Coordinates coordinates = projective(random, texture);
        draw(at, &coordinates, 1);
        glDisable(texture.target);
    }
}

/// Spangle compares depths one by one, Mesa compares after filtering. No reference equals a stored depth.
void depths(Random& random, Quads&) {
    constexpr GLenum modes[] = {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA};
    start(random);
    show_texture();
    for (int i = 0; i < 4; ++i) {
        const bool compares = often(random, 3);
        RandomTexture::Wishes wishes;
        wishes.depths = true;
        wishes.linear = !compares;
        const RandomTexture texture(random, wishes);
        const auto set = [&](GLenum name, GLenum v) {
            glTexParameteri(texture.target, name, static_cast<GLint>(v));
        };
        set(GL_DEPTH_TEXTURE_MODE, one_of(random, modes));
        set(GL_TEXTURE_COMPARE_MODE, compares ? GL_COMPARE_R_TO_TEXTURE : GL_NONE);
        set(GL_TEXTURE_COMPARE_FUNC, GL_NEVER + random.below(8));
        glEnable(texture.target);
        const Rectangle at(random);
        Coordinates coordinates = affine(random, texture, at, false);
        coordinates.texel[2].c = (whole(random, -4, 258) + 0.5) / 255;
        coordinates.size[2] = 1;
        if (texture.target == GL_TEXTURE_1D) // Mesa compares t
            coordinates.texel[1] = coordinates.texel[2], coordinates.size[1] = 1;
        draw(at, &coordinates, 1);
        glDisable(texture.target);
    }
}

/// Sets COMBINE for all units, `on` of which have a texture.
void combine(Random& random, int on) {
    constexpr GLenum functions[] = {GL_REPLACE,     GL_MODULATE, GL_ADD,      GL_ADD_SIGNED,
                                    GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};
    constexpr GLenum sources[] = {GL_TEXTURE,  GL_CONSTANT, GL_PRIMARY_COLOR,
                                  GL_PREVIOUS, GL_TEXTURE0, GL_TEXTURE1};
    constexpr GLenum operands[] = {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_COLOR,
                                   GL_ONE_MINUS_SRC_COLOR};
    const auto set = [](GLenum name, GLenum v) { glTexEnvi(GL_TEXTURE_ENV, name, static_cast<GLint>(v)); };
    set(GL_COMBINE_RGB, functions[random.below(8)]);
    set(GL_COMBINE_ALPHA, functions[random.below(6)]);
    for (GLenum i = 0; i < 3; ++i) {
        const std::uint32_t known = on == 2 ? 6 : 5;
        set(GL_SOURCE0_RGB + i, sources[random.below(known)]);
        set(GL_SOURCE0_ALPHA + i, sources[random.below(known)]);
        set(GL_OPERAND0_RGB + i, operands[random.below(4)]);
        set(GL_OPERAND0_ALPHA + i, operands[random.below(2)]);
    }
    set(GL_RGB_SCALE, 1u << random.below(3));
    set(GL_ALPHA_SCALE, 1u << random.below(3));
}

void environment(Random& random, GLenum base, int on) {
    constexpr GLenum modes[] = {GL_REPLACE, GL_MODULATE, GL_BLEND, GL_ADD, GL_COMBINE, GL_COMBINE, GL_DECAL};
    const bool decal = base == GL_RGB || base == GL_RGBA; // GL defines DECAL for these formats only
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(modes[random.below(decal ? 7 : 6)]));
    GLfloat constant[4];
    for (GLfloat& c : constant)
        c = unit(random);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
    combine(random, on);
}

void environments(Random& random, Quads&) {
    start(random);
    for (int i = 0; i < 3; ++i) {
        const int units = whole(random, 1, 2);
        RandomTexture::Wishes wishes;
        wishes.linear = false; // scales would enlarge the differences of filters
        const RandomTexture first(random, wishes);
        glActiveTexture(GL_TEXTURE1);
        const RandomTexture second(random, wishes);
        const RandomTexture* const textures[] = {&first, &second};
        const auto toggle = [&](bool on) {
            for (int u = 0; u < units; ++u) {
                glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(u));
                on ? glEnable(textures[u]->target) : glDisable(textures[u]->target);
            }
        };
        toggle(true);
        for (int k = 0; k < 4; ++k) {
            const Rectangle at(random);
            Coordinates coordinates[2];
            for (int u = 0; u < units; ++u) {
                glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(u));
                environment(random, textures[u]->base, units);
                coordinates[u] = affine(random, *textures[u], at, false);
            }
            color(random);
            draw(at, coordinates, units);
        }
        toggle(false);
        glActiveTexture(GL_TEXTURE0);
    }
}

} // namespace

void add_texture_families(std::vector<Family>& all) {
    // Mesa's weights are floats, and Spangle's are 256ths by definition: less than a step of 255 for each
    // axis, and one step for the level.
    all.push_back({"TextureImages", 2000, 2, 0.95, images});
    all.push_back({"TextureLevels", 2000, 3, 0.955, [](Random& random, Quads&) { levels(random, true); }});
    all.push_back(
        {"TextureLevelsOfAnySteps", 2000, 3, 0.95, [](Random& random, Quads&) { levels(random, false); }});
    all.push_back({"TexturePerspective", 2000, 2, 0.92, perspective});
    all.push_back({"TextureDepths", 2000, 2, 0.99, depths});
    all.push_back({"TextureEnvironments", 3000, 1, 0.99, environments});
}

} // namespace spangle::oracle

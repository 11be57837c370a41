#include "tests/tools/bench/states/shapes.hpp"

#include "tests/support/random.hpp"
#include "tests/tools/bench/states/apply.hpp"
#include "tests/tools/bench/states/textures.hpp"

namespace spangle::bench::states {

namespace {

using test::Random;

struct Vertex {
    GLfloat place[3];
    GLfloat normal[3];
    GLfloat coordinates[2][3];
    GLubyte color[4];
};

/// A kind of primitive: its vertices, how many primitives are enough to count and to time, and how far they
/// reach in pixels.
struct Kind {
    GLenum mode;
    int corners;
    int count, time;
    int reach;
};
constexpr Kind kinds[] = {
    {GL_TRIANGLES, 3, 3, 16, 52},      {GL_TRIANGLES, 3, 24, 400, 6}, {GL_LINES, 2, 16, 200, 36},
    {GL_LINES, 2, 8, 120, 36},         {GL_POINTS, 1, 64, 1500, 0},   {GL_POINTS, 1, 12, 300, 0},
    {GL_QUADS, 4, 3, 24, sprite_size},
};
#ifdef SPANGLE_FIRMWARE
constexpr int most_vertices = 24 * 3;
#else
constexpr int most_vertices = 2000;
#endif
Vertex vertices[most_vertices];

const Kind& kind_of(const State& state) {
    return kinds[state[Word::shape]];
}

/// The place of a vertex in the window in 16ths of a pixel, and its distance in 16ths.
struct Corner {
    int x, y, distance;
};

int between(Random& random, int low, int high) {
    return low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low + 1)));
}

int double_area(const Corner* c) {
    return (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x);
}

/// Places vertices without slivers: a triangle has at least a fifth of the square around it.
void place_corners(Random& random, const Kind& kind, Corner* corner) {
    const int reach = kind.reach * 16;
    for (;;) {
        const int x = between(random, reach, canvas_width * 16 - reach),
                  y = between(random, reach, canvas_height * 16 - reach);
        for (int i = 0; i < kind.corners; ++i) {
            corner[i].x = x + between(random, -reach, reach);
            corner[i].y = y + between(random, -reach, reach);
        }
        const int area = kind.corners == 3 ? double_area(corner) : 0;
        if (kind.corners < 3 || (area < 0 ? -area : area) > 8 * reach * reach / 5)
            return;
    }
}

/// Places sprites at whole pixels.
void place_sprite(Random& random, Corner* corner) {
    const int x = between(random, 0, canvas_width - sprite_size) * 16,
              y = between(random, 0, canvas_height - sprite_size) * 16;
    for (int i = 0; i < 4; ++i)
        corner[i] = {x + (i == 1 || i == 2 ? sprite_size * 16 : 0), y + (i > 1 ? sprite_size * 16 : 0), 0};
}

void place_depths(Random& random, const Kind& kind, std::uint8_t view, Corner* corner) {
    const int base = between(random, 32, 160);
    for (int i = 0; i < kind.corners; ++i)
        corner[i].distance = view == harsh           ? (i == 0 ? 20 : between(random, 20, 200))
                             : kind.mode == GL_QUADS ? base
                                                     : base + base * between(random, 0, 80) / 256;
}

void set_coordinates(const State& state, Vertex& vertex, const Corner& at, const Corner& first, int corner) {
    const bool sprite = state[Word::shape] == sprites;
    const auto scale =
        state.has(Word::texture) && !sprite ? static_cast<int>(state.value(Word::scale)[0]) : 16;
    for (int unit = 0; unit < 2; ++unit) {
        // Coordinates are 256ths of a texel, from a place that differs from primitive to primitive.
        const int s = (at.x - first.x) * scale + (first.x * 7 & 0x7FF) * 4,
                  t = (at.y - first.y) * scale + (first.y * 5 & 0x7FF) * 4;
        GLfloat* const out = vertex.coordinates[unit];
        out[0] = static_cast<GLfloat>(s) / (256 * texture_size);
        out[1] = static_cast<GLfloat>(t) / (256 * texture_size);
        if (sprite) {
            out[0] = static_cast<GLfloat>(corner == 1 || corner == 2);
            out[1] = static_cast<GLfloat>(corner > 1);
        }
        out[2] = (out[0] + out[1]) / 2;
    }
    if (state.has(Word::texture) && state.value(Word::texture)[0] == GL_TEXTURE_CUBE_MAP) {
        // The direction is about the face +Z, and goes past its edges.
        GLfloat* const out = vertex.coordinates[0];
        out[0] = 2 * out[0] - 1, out[1] = 2 * out[1] - 1, out[2] = 1;
    }
}

void set_color(Random& random, const State& state, Vertex& vertex) {
    for (int c = 0; c < 3; ++c)
        vertex.color[c] = static_cast<GLubyte>(random.below(256));
    vertex.color[3] = static_cast<GLubyte>(32 + random.below(224));
    if (!state.has(Word::alpha))
        vertex.color[3] = 255;
    vertex.normal[0] = static_cast<GLfloat>(between(random, -8, 8)) / 16;
    vertex.normal[1] = static_cast<GLfloat>(between(random, -8, 8)) / 16;
    vertex.normal[2] = 0.75f;
}

/// Sets the eye coordinates of a vertex (apply.cpp has the projection).
void set_place(const State& state, Vertex& vertex, const Corner& at) {
    const GLfloat x = static_cast<GLfloat>(at.x) / 16, y = static_cast<GLfloat>(at.y) / 16,
                  distance = static_cast<GLfloat>(at.distance) / 16;
    vertex.place[0] = state.has(Word::view) ? (x * 2 / canvas_width - 1) * distance : x;
    vertex.place[1] = state.has(Word::view) ? (y * 2 / canvas_height - 1) * distance : y;
    vertex.place[2] = -distance;
}

void use_arrays(const State& state) {
    constexpr GLsizei stride = sizeof(Vertex);
    glVertexPointer(3, GL_FLOAT, stride, vertices[0].place);
    glEnableClientState(GL_VERTEX_ARRAY);
    glNormalPointer(GL_FLOAT, stride, vertices[0].normal);
    if (state[Word::shade] == lit || state[Word::shade] == lit_specular)
        glEnableClientState(GL_NORMAL_ARRAY);
    glColor4ubv(vertices[0].color);
    glColorPointer(4, GL_UNSIGNED_BYTE, stride, vertices[0].color);
    if (state[Word::shade] == flat || state[Word::shade] == smooth_color)
        glEnableClientState(GL_COLOR_ARRAY);
    for (int unit = 0; unit < 2; ++unit) {
        if (!state.has(unit == 0 ? Word::texture : Word::texture2))
            continue;
        glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glTexCoordPointer(unit == 0 ? 3 : 2, GL_FLOAT, stride, vertices[0].coordinates[unit]);
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    }
    glClientActiveTexture(GL_TEXTURE0);
}

} // namespace

int amount_to_count(const State& state) {
    return kind_of(state).count;
}

int amount_to_time(const State& state) {
    return kind_of(state).time;
}

void set_vertices(const State& state, int amount) {
    const Kind& kind = kind_of(state);
    Random random{state[Word::shape] * 977u + 5u};
    Vertex* out = vertices;
    for (int i = 0; i < amount && (i + 1) * kind.corners <= most_vertices; ++i) {
        Corner corner[4];
        if (kind.mode == GL_QUADS)
            place_sprite(random, corner);
        else
            place_corners(random, kind, corner);
        place_depths(random, kind, state[Word::view], corner);
        for (int k = 0; k < kind.corners; ++k, ++out) {
            set_place(state, *out, corner[k]);
            set_coordinates(state, *out, corner[k], corner[0], k);
            set_color(random, state, *out);
        }
    }
    use_arrays(state);
}

void draw(const State& state, int amount) {
    const Kind& kind = kind_of(state);
    glDrawArrays(kind.mode, 0, amount * kind.corners);
}

} // namespace spangle::bench::states

// S5: three gears in display lists, after the oldest demo of GL.
#include "boards/scenes/scene.hpp"
#include "boards/scenes/trig.hpp"
#include "boards/scenes/view.hpp"

namespace spangle::scenes {

namespace {

struct Gear {
    float inner, outer, width;
    int teeth;
    float tooth_depth;
    float x, y;
    GLfloat color[4];
};

constexpr Gear gear_data[3] = {
    {1.0f, 4.0f, 1.0f, 20, 0.7f, -3.0f, -2.0f, {0.8f, 0.1f, 0.0f, 1.0f}},
    {0.5f, 2.0f, 2.0f, 10, 0.7f, 3.1f, -2.0f, {0.0f, 0.8f, 0.2f, 1.0f}},
    {1.3f, 2.0f, 0.5f, 10, 0.7f, -3.1f, 4.2f, {0.2f, 0.2f, 1.0f, 1.0f}},
};

/// The directions of the four corners of a tooth, a quarter of the pitch apart. The corners are at the foot,
/// the top, the top, and the foot.
struct Direction {
    float x, y;
};
template <int Teeth> constexpr auto make_directions() {
    std::array<Direction, Teeth * 4 + 4> table{};
    for (int i = 0; i < Teeth * 4 + 4; ++i) {
        const double a = turn * (i % (Teeth * 4)) / (Teeth * 4);
        table[static_cast<unsigned>(i)] = {static_cast<float>(cosine(a)), static_cast<float>(sine(a))};
    }
    return table;
}
constexpr auto directions_20 = make_directions<20>();
constexpr auto directions_10 = make_directions<10>();

/// The outline of a gear. Corners 0 and 3 of each tooth lie at its foot, corners 1 and 2 at its top.
struct Outline {
    const Gear& gear;
    const Direction* at;

    float foot() const { return gear.outer - gear.tooth_depth / 2.0f; }
    float top() const { return gear.outer + gear.tooth_depth / 2.0f; }
    Direction point(int i) const {
        const int corner = i & 3;
        const float r = corner == 1 || corner == 2 ? top() : foot();
        return {r * at[i].x, r * at[i].y};
    }
};

/// Draws the ring between the hole and the feet of the teeth, at height `z`. The ring faces up for z > 0,
/// else down.
void face(const Outline& o, float z) {
    glNormal3f(0.0f, 0.0f, z > 0.0f ? 1.0f : -1.0f);
    const bool up = z > 0.0f;
    glBegin(GL_QUAD_STRIP);
    for (int tooth = 0; tooth <= o.gear.teeth; ++tooth) {
        const Direction* d = o.at + 4 * (tooth % o.gear.teeth);
        const auto inner = [&] { glVertex3f(o.gear.inner * d[0].x, o.gear.inner * d[0].y, z); };
        const auto outer = [&](int i) { glVertex3f(o.foot() * d[i].x, o.foot() * d[i].y, z); };
        if (up) {
            inner();
            outer(0);
            if (tooth < o.gear.teeth)
                inner(), outer(3);
        } else {
            outer(0);
            inner();
            if (tooth < o.gear.teeth)
                outer(3), inner();
        }
    }
    glEnd();
}

/// Draws the flat sides of the teeth at height `z`.
void tooth_sides(const Outline& o, float z) {
    const bool up = z > 0.0f;
    glBegin(GL_QUADS);
    for (int tooth = 0; tooth < o.gear.teeth; ++tooth)
        for (int k = 0; k < 4; ++k) {
            const Direction p = o.point(4 * tooth + (up ? k : 3 - k));
            glVertex3f(p.x, p.y, z);
        }
    glEnd();
}

/// Draws the outside of the teeth: four quads a tooth, each with the normal of its flank. The normals are not
/// unit vectors; GL_NORMALIZE makes them so.
void rim(const Outline& o) {
    const float z = o.gear.width / 2.0f;
    glBegin(GL_QUADS);
    for (int i = 0; i < 4 * o.gear.teeth; ++i) {
        const Direction a = o.point(i), b = o.point((i + 1) % (4 * o.gear.teeth));
        glNormal3f(b.y - a.y, a.x - b.x, 0.0f);
        glVertex3f(a.x, a.y, -z);
        glVertex3f(b.x, b.y, -z);
        glVertex3f(b.x, b.y, z);
        glVertex3f(a.x, a.y, z);
    }
    glEnd();
}

/// Draws the inside of the hole, the only part of a gear that is shaded smoothly.
void hole(const Outline& o) {
    const float z = o.gear.width / 2.0f, r = o.gear.inner;
    glBegin(GL_QUAD_STRIP);
    for (int tooth = 0; tooth <= o.gear.teeth; ++tooth) {
        const Direction d = o.at[4 * (tooth % o.gear.teeth)];
        glNormal3f(-d.x, -d.y, 0.0f);
        glVertex3f(r * d.x, r * d.y, -z);
        glVertex3f(r * d.x, r * d.y, z);
    }
    glEnd();
}

void compile(GLuint list, const Gear& gear, const Direction* directions) {
    const Outline o{gear, directions};
    glNewList(list, GL_COMPILE);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, gear.color);
    glShadeModel(GL_FLAT);
    for (const float side : {0.5f, -0.5f}) {
        face(o, side * gear.width);
        tooth_sides(o, side * gear.width);
    }
    rim(o);
    glShadeModel(GL_SMOOTH);
    hole(o);
    glEndList();
}

GLuint lists;

void setup(int width, int height) {
    static constexpr GLfloat light[4] = {5.0f, 5.0f, 10.0f, 0.0f};
    clear_color();
    perspective(width, height, 5.0f, 60.0f);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    lists = glGenLists(3);
    compile(lists, gear_data[0], directions_20.data());
    compile(lists + 1, gear_data[1], directions_10.data());
    compile(lists + 2, gear_data[2], directions_10.data());
}

void draw(int frame) {
    const float angle = static_cast<float>(2 * (frame % 90));
    const float spin[3] = {angle, -2.0f * angle - 9.0f, -2.0f * angle - 25.0f};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -40.0f);
    glRotatef(20.0f, 1.0f, 0.0f, 0.0f);
    glRotatef(30.0f, 0.0f, 1.0f, 0.0f);
    for (unsigned i = 0; i < 3; ++i) {
        glPushMatrix();
        glTranslatef(gear_data[i].x, gear_data[i].y, 0.0f);
        glRotatef(spin[i], 0.0f, 0.0f, 1.0f);
        glCallList(lists + i);
        glPopMatrix();
    }
}

} // namespace

const Scene gears{"S5", "three gears in display lists", setup, draw};

} // namespace spangle::scenes

// State that vertices derive is derived again if that part of the state changed, and only then.
#include <random>

#include "gl/context/context.hpp"
#include "tests/gl/vertex/lighting_canvas.hpp"

namespace spangle::test {
namespace {

class Derived : public Lighting {
  protected:
    void SetUp() override {
        Lighting::SetUp();
        glEnable(GL_LIGHT0);
    }

    static gl::Context& context() { return *gl::current_context(); }

    static raster::FixedVertex drawn() {
        WindowRecorder recorder;
        glBegin(GL_POINTS);
        glVertex3f(3, -5, 7);
        glEnd();
        EXPECT_EQ(recorder.primitives.size(), 1u);
        return recorder.primitives.empty() ? raster::FixedVertex{} : recorder.primitives[0].corner[0];
    }

    static void expect_equal(const raster::FixedVertex& a, const raster::FixedVertex& b, const char* after) {
        EXPECT_EQ(a.x, b.x) << after;
        EXPECT_EQ(a.y, b.y) << after;
        EXPECT_EQ(a.z, b.z) << after;
        for (int c = 0; c < 4; ++c)
            EXPECT_EQ(a.color[c], b.color[c]) << after << ", component " << c;
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(a.secondary[c], b.secondary[c]) << after << ", secondary component " << c;
    }
};

using Random = std::mt19937;

GLfloat number(Random& random, float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
}

struct Change {
    const char* name;
    void (*make)(Random&);
};

const Change changes[] = {
    {"Rotate", [](Random& r) { glRotatef(number(r, -90, 90), number(r, -1, 1), number(r, -1, 1), 1); }},
    {"Scale", [](Random& r) { glScalef(number(r, 0.5f, 2), number(r, 0.5f, 2), number(r, 0.5f, 2)); }},
    {"Scale alike", [](Random&) { glScalef(0.5f, 0.5f, 0.5f); }},
    {"Translate", [](Random& r) { glTranslatef(number(r, -5, 5), number(r, -5, 5), 0); }},
    {"LoadIdentity", [](Random&) { glLoadIdentity(); }},
    {"PushMatrix and PopMatrix",
     [](Random&) {
         glPushMatrix();
         glScalef(2, 1, 1);
         glBegin(GL_POINTS);
         glVertex2f(0, 0);
         glEnd();
         glPopMatrix();
     }},
    {"projection",
     [](Random& r) {
         glMatrixMode(GL_PROJECTION);
         glLoadIdentity();
         glOrtho(-200, number(r, 100, 200), -200, 200, -200, 200);
         glMatrixMode(GL_MODELVIEW);
     }},
    {"Viewport", [](Random& r) { glViewport(0, 0, 40 + static_cast<GLint>(r() % 20), 64); }},
    {"DepthRange", [](Random& r) { glDepthRange(number(r, 0, 1), number(r, 0, 1)); }},
    {"Material",
     [](Random& r) {
         const GLfloat v[4] = {number(r, 0, 1), number(r, 0, 1), number(r, 0, 1), number(r, 0, 1)};
         const GLenum property[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION};
         glMaterialfv(GL_FRONT_AND_BACK, property[r() % 4], v);
     }},
    {"Material without light of its own",
     [](Random&) {
         const GLfloat black[4] = {0, 0, 0, 1};
         glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, black);
     }},
    {"Shininess", [](Random& r) { glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, number(r, 0, 128)); }},
    {"Color", [](Random& r) { glColor3f(number(r, 0, 1), number(r, 0, 1), number(r, 0, 1)); }},
    {"COLOR_MATERIAL on", [](Random&) { glEnable(GL_COLOR_MATERIAL); }},
    {"COLOR_MATERIAL off", [](Random&) { glDisable(GL_COLOR_MATERIAL); }},
    {"Light's colour",
     [](Random& r) {
         const GLfloat v[4] = {number(r, 0, 1), number(r, 0, 1), number(r, 0, 1), 1};
         glLightfv(GL_LIGHT0 + r() % 2, r() % 2 != 0 ? GL_DIFFUSE : GL_AMBIENT, v);
     }},
    {"Light's position",
     [](Random& r) {
         const GLfloat v[4] = {number(r, -9, 9), number(r, -9, 9), 10, static_cast<GLfloat>(r() % 4 == 0)};
         glLightfv(GL_LIGHT0 + r() % 2, GL_POSITION, v);
     }},
    {"Light's cone",
     [](Random& r) {
         const GLfloat v[3] = {number(r, -1, 1), number(r, -1, 1), -1};
         glLightfv(GL_LIGHT0 + r() % 2, GL_SPOT_DIRECTION, v);
         glLightf(GL_LIGHT0 + r() % 2, GL_SPOT_CUTOFF, r() % 2 != 0 ? 180 : number(r, 30, 90));
         glLightf(GL_LIGHT0 + r() % 2, GL_SPOT_EXPONENT, number(r, 0, 10));
     }},
    {"LightModel",
     [](Random& r) {
         const GLfloat v[4] = {number(r, 0, 1), number(r, 0, 1), number(r, 0, 1), 1};
         glLightModelfv(GL_LIGHT_MODEL_AMBIENT, v);
     }},
    {"LIGHT1", [](Random& r) { (r() % 2 != 0 ? glEnable : glDisable)(GL_LIGHT1); }},
    {"NORMALIZE", [](Random& r) { (r() % 2 != 0 ? glEnable : glDisable)(GL_NORMALIZE); }},
    {"LIGHTING", [](Random& r) { (r() % 4 != 0 ? glEnable : glDisable)(GL_LIGHTING); }},
    {"Normal", [](Random& r) { glNormal3f(number(r, -1, 1), number(r, -1, 1), number(r, 0.2f, 1)); }},
};

TEST_F(Derived, AnyChangesLeaveWhatIsDerivedAllAtOnce) {
    Random random(11);
    for (int i = 0; i < 20000 && !HasFailure(); ++i) {
        const Change& change = changes[random() % std::size(changes)];
        change.make(random);
        if (random() % 3 == 0)
            continue; // makes several changes before the next vertex
        const raster::FixedVertex now = drawn();
        context().changed(gl::dirty_all);
        expect_equal(now, drawn(), change.name);
    }
}

/// The state is changed behind the context's back, so a new value shows what is derived again.
TEST_F(Derived, AMaterialLeavesTheMatrices) {
    const raster::FixedVertex before = drawn();
    gl::TransformState& transform = context().transform;
    transform.modelview.entry[transform.modelview.top].set(0, 3, numeric::to_element(numeric::one));
    const GLfloat green[4] = {0, 1, 0, 1};
    glMaterialfv(GL_FRONT, GL_EMISSION, green);
    const raster::FixedVertex after = drawn();
    EXPECT_EQ(after.x, before.x);
    EXPECT_NE(after.color[1], before.color[1]);
    context().changed(gl::dirty_matrices);
    EXPECT_NE(drawn().x, before.x);
}

TEST_F(Derived, AMatrixLeavesTheLights) {
    const raster::FixedVertex before = drawn();
    context().lighting.light[0].diffuse[1] = numeric::zero;
    glTranslatef(20, 0, 0);
    const raster::FixedVertex after = drawn();
    EXPECT_NE(after.x, before.x);
    EXPECT_EQ(after.color[1], before.color[1]);
    context().changed(gl::dirty_lights);
    EXPECT_NE(drawn().color[1], before.color[1]);
}

TEST_F(Derived, ALightLeavesTheMatrices) {
    const raster::FixedVertex before = drawn();
    gl::TransformState& transform = context().transform;
    transform.modelview.entry[transform.modelview.top].set(0, 3, numeric::to_element(numeric::one));
    const GLfloat black[4] = {0, 0, 0, 1};
    glLightfv(GL_LIGHT0, GL_DIFFUSE, black);
    const raster::FixedVertex after = drawn();
    EXPECT_EQ(after.x, before.x);
    EXPECT_NE(after.color[1], before.color[1]);
}

} // namespace
} // namespace spangle::test

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
        if (glIsEnabled(GL_TEXTURE_2D) == GL_FALSE)
            return;
        EXPECT_EQ(a.tex[0].s, b.tex[0].s) << after;
        EXPECT_EQ(a.tex[0].t, b.tex[0].t) << after;
        EXPECT_EQ(a.tex[0].q, b.tex[0].q) << after;
        EXPECT_EQ(a.tex[0].exponent, b.tex[0].exponent) << after;
    }

    /// Returns the corners of the triangles that clipping makes of a triangle of the enabled arrays.
    static std::vector<raster::FixedVertex> drawn_from_arrays() {
        WindowRecorder recorder;
        glDrawArrays(GL_TRIANGLES, 0, 3);
        std::vector<raster::FixedVertex> out;
        for (const Primitive& primitive : recorder.primitives)
            out.insert(out.end(), std::begin(primitive.corner), std::end(primitive.corner));
        return out;
    }

    /// Moves the modelview matrix behind the context's back, so that only a new derivation shows it.
    static void move_modelview() {
        gl::TransformState& transform = context().transform;
        numeric::Matrix& top = transform.modelview.entry[transform.modelview.top];
        top.set(0, 3, numeric::to_element(numeric::one));
        top.set(2, 2, numeric::to_element(numeric::from_i32(3)));
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
    {"texture matrix",
     [](Random& r) {
         glMatrixMode(GL_TEXTURE);
         glLoadIdentity();
         glTranslatef(number(r, -1, 1), number(r, -1, 1), 0);
         glMatrixMode(GL_MODELVIEW);
     }},
    {"TexCoord", [](Random& r) { glTexCoord2f(number(r, -1, 1), number(r, -1, 1)); }},
    {"TEXTURE_2D", [](Random& r) { (r() % 2 != 0 ? glEnable : glDisable)(GL_TEXTURE_2D); }},
    {"TEXTURE_GEN_S", [](Random& r) { (r() % 2 != 0 ? glEnable : glDisable)(GL_TEXTURE_GEN_S); }},
    {"TexGen",
     [](Random& r) {
         const GLint mode[] = {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_NORMAL_MAP};
         glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, mode[r() % 4]);
     }},
    {"RESCALE_NORMAL", [](Random& r) { (r() % 2 != 0 ? glEnable : glDisable)(GL_RESCALE_NORMAL); }},
    {"popped attributes",
     [](Random& r) {
         const GLfloat v[4] = {number(r, 0, 1), number(r, 0, 1), number(r, 0, 1), 1};
         glPushAttrib(GL_ALL_ATTRIB_BITS);
         glViewport(0, 0, 30, 30);
         glLightfv(GL_LIGHT0, GL_DIFFUSE, v);
         glMaterialfv(GL_FRONT, GL_AMBIENT, v);
         glDisable(GL_LIGHT0);
         if (r() % 2 != 0) {
             glBegin(GL_POINTS);
             glVertex2f(0, 0);
             glEnd();
         }
         glPopAttrib();
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

/// Elements of arrays are kept with their positions, while lights, materials and the current colour change.
TEST_F(Derived, AnyChangesReachElementsOfArrays) {
    const GLfloat positions[] = {3, -5, 7, 30, -5, 7, 3, 40, -9};
    const GLfloat normals[] = {0, 0, 1, 0.6f, 0, 0.8f, 0, 1, 0};
    glVertexPointer(3, GL_FLOAT, 0, positions);
    glNormalPointer(GL_FLOAT, 0, normals);
    glEnableClientState(GL_VERTEX_ARRAY);
    Random random(12);
    std::size_t seen = 0;
    for (int i = 0; i < 6000 && !HasFailure(); ++i) {
        const Change& change = changes[random() % std::size(changes)];
        change.make(random);
        (random() % 3 != 0 ? glEnableClientState : glDisableClientState)(GL_NORMAL_ARRAY);
        if (random() % 3 == 0)
            continue; // several changes before a draw
        const std::vector<raster::FixedVertex> now = drawn_from_arrays();
        context().changed(gl::dirty_all);
        const std::vector<raster::FixedVertex> anew = drawn_from_arrays();
        ASSERT_EQ(now.size(), anew.size()) << change.name;
        for (std::size_t v = 0; v < now.size(); ++v)
            expect_equal(now[v], anew[v], change.name);
        seen += now.size();
    }
    EXPECT_GT(seen, 3000u);
}

TEST_F(Derived, AViewportLeavesTheMatrices) {
    const raster::FixedVertex before = drawn();
    move_modelview();
    glDepthRange(0.5, 1);
    const raster::FixedVertex after = drawn();
    EXPECT_EQ(after.x, before.x);
    EXPECT_EQ(after.color[0], before.color[0]);
    EXPECT_NE(after.z, before.z);
    glViewport(10, 0, 64, 64);
    EXPECT_NE(drawn().x, before.x);
}

TEST_F(Derived, AProjectionLeavesTheNormals) {
    const raster::FixedVertex before = drawn();
    move_modelview();
    glMatrixMode(GL_PROJECTION);
    glScalef(0.5f, 1, 1);
    const raster::FixedVertex after = drawn();
    EXPECT_NE(after.x, before.x);
    EXPECT_EQ(after.color[0], before.color[0]);
    context().changed(gl::dirty_modelview);
    EXPECT_NE(drawn().color[0], before.color[0]);
}

/// A light faces normals that were derived before it changed.
TEST_F(Derived, ALightLeavesTheNormals) {
    const GLfloat bright[4] = {1, 1, 1, 1};
    glLightfv(GL_LIGHT0, GL_DIFFUSE, bright);
    const raster::FixedVertex before = drawn();
    move_modelview();
    glLightfv(GL_LIGHT0, GL_DIFFUSE, bright);
    EXPECT_EQ(drawn().color[0], before.color[0]);
    context().changed(gl::dirty_modelview);
    EXPECT_NE(drawn().color[0], before.color[0]);
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
    context().changed(gl::dirty_transform);
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

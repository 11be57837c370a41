// Tests occlusion queries (GL 1.5, 4.1.7): what they count in every way of drawing, and the life of their
// objects.
#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "tests/gl/vertex/canvas.hpp"

namespace spangle::test {
namespace {

class OcclusionQuery : public Canvas {
  protected:
    void SetUp() override {
        Canvas::SetUp();
        glOrtho(0, size, 0, size, -1, 1);
        glClear(GL_DEPTH_BUFFER_BIT);
    }
    static GLuint result(GLuint id) {
        GLuint available = 0, value = 12345;
        glGetQueryObjectuiv(id, GL_QUERY_RESULT_AVAILABLE, &available);
        EXPECT_EQ(available, GLuint{GL_TRUE});
        glGetQueryObjectuiv(id, GL_QUERY_RESULT, &value);
        GLint also = 0;
        glGetQueryObjectiv(id, GL_QUERY_RESULT, &also);
        EXPECT_EQ(static_cast<GLuint>(also), value);
        return value;
    }
    template <class Draw> static GLuint count(Draw draw) {
        glBeginQuery(GL_SAMPLES_PASSED, 7);
        draw();
        glEndQuery(GL_SAMPLES_PASSED);
        return result(7);
    }
    static GLenum take_error() { return glGetError(); }
};

TEST_F(OcclusionQuery, CountsWhatPassesAllTests) {
    const auto box = [] { glRecti(10, 10, 30, 20); };
    EXPECT_EQ(count([] {}), 0u);
    EXPECT_EQ(count(box), 200u) << "without a depth test, too";
    EXPECT_EQ(count([&] { box(), box(); }), 400u);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    EXPECT_EQ(count([&] { box(), box(); }), 200u);
    glDepthFunc(GL_NEVER);
    EXPECT_EQ(count(box), 0u);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 15, 64);
    EXPECT_EQ(count(box), 50u);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.5f);
    glColor4f(1, 1, 1, 0.25f);
    EXPECT_EQ(count(box), 0u);
    glDisable(GL_ALPHA_TEST);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    EXPECT_EQ(count(box), 200u) << "nothing is written, but it passes";
    box();
    EXPECT_EQ(result(7), 200u) << "nothing counts after the end";
    EXPECT_EQ(count([] {
                  glBegin(GL_POINTS);
                  glVertex2f(5.5f, 5.5f);
                  glEnd();
                  glBegin(GL_LINES);
                  glVertex2f(5.5f, 40.5f), glVertex2f(25.5f, 40.5f);
                  glEnd();
              }),
              21u);
}

/// A tool with counters counts the same, whether it begins before, within or after a query.
TEST_F(OcclusionQuery, BesideTheCountersOfTools) {
    gl::Context& context = *gl::current_context();
    raster::Counters tool;
    const auto box = [] { glRecti(0, 0, 10, 10); };
    glBeginQuery(GL_SAMPLES_PASSED, 3);
    box();
    gl::observe(context, &tool, true);
    box();
    box();
    gl::observe(context, nullptr, false);
    box();
    glEndQuery(GL_SAMPLES_PASSED);
    EXPECT_EQ(result(3), 400u);
    EXPECT_EQ(tool.passed, 200u);
    gl::observe(context, &tool, true);
    box();
    EXPECT_EQ(count(box), 100u);
    gl::observe(context, nullptr, false);
    EXPECT_EQ(tool.passed, 400u);
    EXPECT_EQ(count(box), 100u);
}

TEST_F(OcclusionQuery, NamesAndErrors) {
    const auto error = [](GLenum code) { EXPECT_EQ(take_error(), code); };
    constexpr GLenum operation = GL_INVALID_OPERATION, none = GL_NO_ERROR;
    GLuint ids[2] = {};
    glGenQueries(2, ids);
    EXPECT_NE(ids[0], 0u);
    EXPECT_FALSE(glIsQuery(ids[0])) << "until it has begun";
    GLuint value = 9;
    glGetQueryObjectuiv(ids[0], GL_QUERY_RESULT, &value);
    error(operation);
    GLint current = -1;
    glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &current);
    EXPECT_EQ(current, 0);
    glGetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &current);
    EXPECT_EQ(current, 32);
    glEndQuery(GL_SAMPLES_PASSED);
    error(operation);
    glBeginQuery(GL_SAMPLES_PASSED, 0);
    error(operation);
    glBeginQuery(GL_QUERY_RESULT, ids[0]);
    error(GL_INVALID_ENUM);
    glBeginQuery(GL_SAMPLES_PASSED, ids[0]);
    error(none);
    EXPECT_TRUE(glIsQuery(ids[0]));
    glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &current);
    EXPECT_EQ(static_cast<GLuint>(current), ids[0]);
    glBeginQuery(GL_SAMPLES_PASSED, ids[1]);
    error(operation);
    glGetQueryObjectuiv(ids[0], GL_QUERY_RESULT_AVAILABLE, &value);
    error(operation);
    EXPECT_EQ(value, 9u);
    glEndQuery(GL_QUERY_RESULT);
    error(GL_INVALID_ENUM);
    glRecti(0, 0, 3, 3);
    glDeleteQueries(2, ids);
    error(none);
    EXPECT_FALSE(glIsQuery(ids[0]));
    glEndQuery(GL_SAMPLES_PASSED);
    error(operation);
    glGetQueryObjectuiv(ids[0], GL_QUERY_RESULT, &value);
    error(operation);
    glGenQueries(-1, ids);
    error(GL_INVALID_VALUE);
    glDeleteQueries(-1, ids);
    error(GL_INVALID_VALUE);
    EXPECT_EQ(count([] { glRecti(0, 0, 3, 3); }), 9u) << "a name of one's own, as of textures";
    glGetQueryObjectuiv(7, GL_QUERY_COUNTER_BITS, &value);
    error(GL_INVALID_ENUM);
}

TEST_F(OcclusionQuery, InDisplayLists) {
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glBeginQuery(GL_SAMPLES_PASSED, 5);
    glRecti(0, 0, 4, 4);
    glEndQuery(GL_SAMPLES_PASSED);
    glEndList();
    EXPECT_FALSE(glIsQuery(5));
    glCallList(list);
    EXPECT_EQ(result(5), 16u);
    glDeleteLists(list, 1);
}

} // namespace
} // namespace spangle::test

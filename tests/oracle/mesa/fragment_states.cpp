// Tests and operations of fragments (GL 1.3, chapter 4): rectangles over a background of all values.
#include "tests/oracle/mesa/random_values.hpp"
#include "tests/oracle/mesa/state_families.hpp"

namespace spangle::oracle {

namespace {

using test::Random;

void toggle(Random& random, GLenum cap, std::uint32_t of) {
    often(random, of) ? glEnable(cap) : glDisable(cap);
}
GLenum compare(Random& random) {
    return GL_NEVER + random.below(8);
}

/// Returns a random component that is often 0 or 255.
GLubyte component(Random& random) {
    const std::uint32_t v = random.below(8);
    return static_cast<GLubyte>(v == 0 ? 0 : v == 1 ? 255 : random.below(256));
}
void color(Random& random) {
    const GLubyte r = component(random), g = component(random), b = component(random), a = component(random);
    glColor4ub(r, g, b, a);
}

/// Draws a rectangle of either facing, at one of eight depths.
void rectangle(Random& random) {
    const auto place = [&] { return static_cast<GLfloat>(random.below(state_size + 1)); };
    const GLfloat x0 = place(), y0 = place(), x1 = place(), y1 = place();
    const GLfloat z = static_cast<GLfloat>(random.below(8)) / 4 - 0.875f;
    color(random);
    glBegin(GL_QUADS);
    glVertex3f(x0, y0, z);
    glVertex3f(x1, y0, z);
    glVertex3f(x1, y1, z);
    glVertex3f(x0, y1, z);
    glEnd();
}

/// Draws colours, stencil values and depths to test against.
void background(Random& random) {
    glClearColor(0.2f, 0.4f, 0.6f, 0.8f);
    glClearStencil(static_cast<GLint>(random.below(256)));
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
    for (int i = 0; i < 12; ++i) {
        glStencilFunc(GL_ALWAYS, static_cast<GLint>(random.below(256)), ~0u);
        rectangle(random);
    }
}

void stencil_side(Random& random, GLenum face) {
    constexpr GLenum ops[] = {GL_KEEP, GL_ZERO,   GL_REPLACE,   GL_INCR,
                              GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP};
    const GLenum func = compare(random);
    const auto ref = static_cast<GLint>(random.below(256));
    const GLuint mask = random.below(256), written = often(random, 3) ? ~0u : random.below(256);
    const GLenum fail = one_of(random, ops), zfail = one_of(random, ops), zpass = one_of(random, ops);
    glStencilFuncSeparate(face, func, ref, mask);
    glStencilOpSeparate(face, fail, zfail, zpass);
    glStencilMaskSeparate(face, written);
}

void random_tests(Random& random) {
    toggle(random, GL_ALPHA_TEST, 3);
    const GLenum alpha = compare(random);
    glAlphaFunc(alpha, static_cast<GLfloat>(random.below(256)) / 255);
    toggle(random, GL_STENCIL_TEST, 4);
    stencil_side(random, often(random, 2) ? GL_FRONT_AND_BACK : GL_FRONT);
    if (often(random, 2))
        stencil_side(random, GL_BACK);
    toggle(random, GL_DEPTH_TEST, 4);
    glDepthFunc(compare(random));
    glDepthMask(often(random, 3));
    toggle(random, GL_SCISSOR_TEST, 2);
    const auto x = static_cast<GLint>(random.below(12)) - 4, y = static_cast<GLint>(random.below(12)) - 4;
    const auto w = static_cast<GLint>(random.below(24)), h = static_cast<GLint>(random.below(24));
    glScissor(x, y, w, h);
}

void masks(Random& random) {
    GLboolean open[4];
    for (auto& m : open)
        m = often(random, 4);
    glColorMask(open[0], open[1], open[2], open[3]);
}

void tests(Random& random, Quads&) {
    background(random);
    for (int i = 0; i < 6; ++i) {
        random_tests(random);
        masks(random);
        rectangle(random);
        if (!often(random, 4)) {
            glClearColor(1, 0, 0.6f, 0.2f);
            glClearStencil(0x5A);
            const GLbitfield colors = often(random, 2) ? GL_COLOR_BUFFER_BIT : 0u;
            glClear(colors | (often(random, 2) ? GL_STENCIL_BUFFER_BIT : 0u));
        }
    }
}

void logic(Random& random, Quads&) {
    background(random);
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_BLEND); // must have no effect
    glBlendFunc(GL_ONE, GL_ONE);
    for (int i = 0; i < 6; ++i) {
        toggle(random, GL_COLOR_LOGIC_OP, 6);
        if (glIsEnabled(GL_COLOR_LOGIC_OP) == GL_FALSE)
            glDisable(GL_BLEND);
        glLogicOp(GL_CLEAR + random.below(16));
        masks(random);
        rectangle(random);
    }
}

GLenum factor(Random& random, bool source) {
    constexpr GLenum factors[] = {GL_ZERO,
                                  GL_ONE,
                                  GL_SRC_COLOR,
                                  GL_ONE_MINUS_SRC_COLOR,
                                  GL_SRC_ALPHA,
                                  GL_ONE_MINUS_SRC_ALPHA,
                                  GL_DST_ALPHA,
                                  GL_ONE_MINUS_DST_ALPHA,
                                  GL_DST_COLOR,
                                  GL_ONE_MINUS_DST_COLOR,
                                  GL_CONSTANT_COLOR,
                                  GL_ONE_MINUS_CONSTANT_COLOR,
                                  GL_CONSTANT_ALPHA,
                                  GL_ONE_MINUS_CONSTANT_ALPHA,
                                  GL_SRC_ALPHA_SATURATE};
    return factors[random.below(source ? 15 : 14)];
}

/// Draws one layer of blending. How far a difference of 1/255 grows in further layers is not compared.
void blending(Random& random, Quads&) {
    constexpr GLenum equations[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
    background(random);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    GLenum f[4];
    for (int i = 0; i < 4; ++i)
        f[i] = factor(random, i % 2 == 0);
    const GLenum rgb = one_of(random, equations), alpha = one_of(random, equations);
    if (often(random, 3)) {
        glBlendFuncSeparate(f[0], f[1], f[2], f[3]);
        glBlendEquationSeparate(rgb, alpha);
    } else {
        glBlendFunc(f[0], f[1]);
        glBlendEquation(rgb);
    }
    GLfloat constant[4];
    for (auto& c : constant)
        c = static_cast<GLfloat>(component(random)) / 255;
    glBlendColor(constant[0], constant[1], constant[2], constant[3]);
    masks(random);
    color(random);
    glRecti(0, 0, state_size, state_size);
}

/// Accumulates a weighted sum of pictures, and adds a value. Sums stay below 1, beyond which Mesa's wrap.
void accumulation(Random& random, Quads&) {
    background(random);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_DEPTH_TEST);
    const auto share = [&] { return static_cast<GLfloat>(random.below(257)) / 2048; };
    // Declarators are evaluated in their order, unlike arguments, so every compiler draws the same numbers.
    const GLfloat red = share(), green = -share(), blue = share();
    glClearAccum(red, green, blue, 0);
    glClear(GL_ACCUM_BUFFER_BIT);
    if (often(random, 2))
        glAccum(GL_LOAD, share());
    for (int i = 0; i < 3; ++i) {
        rectangle(random);
        toggle(random, GL_SCISSOR_TEST, 2);
        glScissor(4, 4, 12, 15);
        glAccum(GL_ACCUM, share());
    }
    glAccum(GL_MULT, 1 - share());
    glAccum(GL_ADD, share() - 0.06f);
    masks(random);
    glAccum(GL_RETURN, 0.5f + 16 * share());
}

} // namespace

void add_fragment_families(std::vector<Family>& all) {
    all.push_back({"tests", 1000, 0, 1, tests});
    all.push_back({"logic", 300, 0, 1, logic});
    all.push_back({"blending", 2000, 0, 1, blending});
    all.push_back({"accumulation", 500, 1, 0.92, accumulation}); // Mesa truncates where Spangle rounds
}

} // namespace spangle::oracle

// Draws one state in a context of its own, so that no earlier state matters. What is drawn once is drawn
// again between `begin` and `end`.
#pragma once

#include <initializer_list>

#include "tests/tools/bench/picture_hash.hpp"
#include "tests/tools/bench/states/canvas.hpp"
#include "tests/tools/bench/states/grammar.hpp"
#include "tests/tools/bench/states/shapes.hpp"
#include "tests/tools/bench/states/textures.hpp"

namespace spangle::bench::states {

struct Counted {
    bool good = false;         ///< whether there is such a context, and GL reports no error
    GLuint fragments = 0;      ///< fragments that the shape covers inside the scissor rectangle
    std::uint32_t picture = 0; ///< hash of the picture
};

/// Counts by an occlusion query what bare() covers.
inline GLuint fragments_of(const State& state, int amount) {
    const State alone = bare(state);
    Headless gl;
    if (!open_for(gl, alone))
        return 0;
    apply(alone);
    set_vertices(alone, amount);
    prepare(alone, amount);
    GLuint query = 0, passed = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_SAMPLES_PASSED, query);
    draw(alone, amount);
    glEndQuery(GL_SAMPLES_PASSED);
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
    glDeleteQueries(1, &query);
    gl.close();
    return passed;
}

template <class Begin, class End> Counted count(const State& state, Begin begin, End end) {
    Counted out;
    const int amount = amount_to_count(state);
    out.fragments = fragments_of(state, amount);
    Headless gl;
    if (!open_for(gl, state))
        return out;
    apply(state);
    set_vertices(state, amount);
    for (const bool counts : {false, true}) { // work that is done once is not counted
        prepare(state, amount);
        if (counts)
            begin();
        draw(state, amount);
        if (counts)
            end();
    }
    out.picture = picture_hash(canvas_width, canvas_height);
    out.good = glGetError() == GL_NO_ERROR;
    forget_textures();
    gl.close();
    return out;
}

} // namespace spangle::bench::states

// A context of Spangle for a state, with the state's surface and in its tier.
#pragma once

#include "tests/tools/bench/headless.hpp"
#include "tests/tools/bench/states/apply.hpp"

namespace spangle::bench::states {

inline bool open_for(Headless& gl, const State& state) {
    constexpr Buffers rgb565{0, 16, 0, 0}, rgba8888{8, 24, 8, 0};
    Buffers buffers = state[Word::surface] == surface_565_z16 ? rgb565 : rgba8888;
    buffers.samples = state.has(Word::samples) ? 4 : 0;
    return gl.open(canvas_width, canvas_height, EGL_PRECISION_EXACT_SPANGLE + state[Word::tier], buffers);
}

} // namespace spangle::bench::states

// A program that can be measured: anything that draws numbered frames with public GL, as often as it is asked
// to.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace spangle::trade {

class Recording;

struct Program {
    std::string name;
    std::function<void(int width, int height)> setup; ///< called in a fresh context
    std::function<void(int frame)> draw;              ///< draws a frame, which depends on no other
    bool stencil = false;                             ///< true: the program needs a stencil buffer
    /// If not null, a process of its own draws the program, and the functions above are empty
    /// (recording.hpp).
    std::shared_ptr<Recording> recording{};
    /// What images of firmware draw, where that differs: a model as it was baked.
    std::shared_ptr<const Program> on_board{};
};

} // namespace spangle::trade

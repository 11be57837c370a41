// What is measured: anything that draws numbered frames with public GL, as often as it is asked to.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace spangle::trade {

class Recording;

struct Program {
    std::string name;
    std::function<void(int width, int height)> setup; ///< in a fresh context
    std::function<void(int frame)> draw;              ///< frames do not depend on each other
    bool stencil = false;                             ///< it needs a stencil buffer
    /// Not null: a process of its own draws it, and the functions are empty (recording.hpp).
    std::shared_ptr<Recording> recording{};
    /// What images of firmware draw, where that is not the same: a model as it was baked.
    std::shared_ptr<const Program> on_board{};
};

} // namespace spangle::trade

// What is measured: anything that draws numbered frames with public GL, as often as it is asked to.
#pragma once

#include <functional>
#include <string>

namespace spangle::trade {

struct Program {
    std::string name;
    std::function<void(int width, int height)> setup; ///< in a fresh context
    std::function<void(int frame)> draw;              ///< frames do not depend on each other
};

} // namespace spangle::trade

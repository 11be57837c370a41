// Finds programs and scenes by their names, for code that records or draws them.
#pragma once

#include <cstring>

#include "boards/scenes/scene.hpp"
#include "tests/tools/profile/programs/program.hpp"

namespace spangle::programs {

/// Returns the program of this name, or the scene with this id. If there is neither, the result has no name.
inline Program find(const char* name) {
    for (const Program* const program : all)
        if (std::strcmp(program->name, name) == 0)
            return *program;
    if (const scenes::Scene* const scene = scenes::find(name); scene != nullptr)
        return {scene->id, scene->setup, scene->draw};
    return {};
}

} // namespace spangle::programs

// What can be wrong in a panel's description, one thing at a time: for pictures of how each looks.
#pragma once

#include <span>

#include "host_sim/bringup/wizard.hpp"

namespace spangle::bringup {

struct Wrong {
    const char* name;
    const char* fix; ///< what mends it
    void (*spoil)(Guess& guess);
    bool swapped = false; ///< the bytes of a pixel
};

std::span<const Wrong> wrongs();
const Wrong* find_wrong(const std::string& name);

} // namespace spangle::bringup

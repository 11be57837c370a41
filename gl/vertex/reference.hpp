// The reference engines for hosts: one in double, and one in fixed point with a double twin of each number.
#pragma once

#include "gl/vertex/engine.hpp"

namespace spangle::gl {

extern const Engine double_engine;
extern const Engine shadow_engine;

} // namespace spangle::gl

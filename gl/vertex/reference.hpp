// The reference engines, for hosts: double, and integers with a double twin.
#pragma once

#include "gl/vertex/engine.hpp"

namespace spangle::gl {

extern const Engine double_engine;
extern const Engine shadow_engine;

} // namespace spangle::gl

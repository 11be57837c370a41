// The engines of the reference precisions, for hosts.
#pragma once

#include "gl/vertex/engine.hpp"

namespace spangle::gl {

extern const Engine double_engine;
extern const Engine shadow_engine;

} // namespace spangle::gl

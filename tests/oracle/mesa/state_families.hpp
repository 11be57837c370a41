// The chapters of GL that have families of random states.
#pragma once

#ifdef SPANGLE_SCENES_ON_OTHER_GL
#include <GL/gl.h>
#include <GL/glext.h>
#else
#include <spangle/GL/gl.h>
#endif

#include "tests/oracle/mesa/states.hpp"

namespace spangle::oracle {

void add_fragment_families(std::vector<Family>& all);
void add_pixel_families(std::vector<Family>& all);
void add_primitive_families(std::vector<Family>& all);
void add_texture_families(std::vector<Family>& all);
void add_texture_update_families(std::vector<Family>& all);
void add_sample_families(std::vector<Family>& all);

} // namespace spangle::oracle

// Current vertex attributes (GL 1.3, 2.7; appendix D.1).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct CurrentState {
    Real color[4] = {numeric::real_one, numeric::real_one, numeric::real_one, numeric::real_one};
    Real normal[3] = {numeric::real_zero, numeric::real_zero, numeric::real_one};
    Real tex_coord[texture_units][4] = {{numeric::real_zero, numeric::real_zero, numeric::real_zero, numeric::real_one}};
};

} // namespace spangle::gl

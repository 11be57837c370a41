// Scenes use public OpenGL only, so the same source draws on any GL. The oracle and the benchmark compile the
// scenes against Mesa, too.
#pragma once

#ifdef SPANGLE_SCENES_ON_OTHER_GL
#include <GL/gl.h>
#else
#include <spangle/GL/gl.h>
#endif

// Scenes use public OpenGL only, so the same source draws on Spangle and on any other GL: the oracle and the
// benchmark compile it against Mesa.
#pragma once

#ifdef SPANGLE_SCENES_ON_OTHER_GL
#include <GL/gl.h>
#else
#include <spangle/GL/gl.h>
#endif

// Included before every source of the drop-in pair: GL's and EGL's functions are seen from outside.
#pragma once

#define GLAPI extern __attribute__((visibility("default")))
#define EGLAPI extern __attribute__((visibility("default")))

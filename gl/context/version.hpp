// The version of the library, as GL_VERSION and `spangle --version` tell it. A test compares it with the
// version of the build.
#pragma once

#define SPANGLE_VERSION "0.2.0"

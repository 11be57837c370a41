// The version in GL_VERSION; a test holds it against the build's.
#pragma once

#define SPANGLE_VERSION "0.1.0"

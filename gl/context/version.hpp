// The version in GL_VERSION; a test compares it with the version of the build.
#pragma once

#define SPANGLE_VERSION "0.1.0"

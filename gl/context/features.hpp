// The optional systems of a build (design 5). CMake defines them; a build by hand has everything.
#pragma once

#ifndef SPANGLE_FEATURE_LISTS
#define SPANGLE_FEATURE_LISTS 1
#endif
#ifndef SPANGLE_FEATURE_LIGHTING
#define SPANGLE_FEATURE_LIGHTING 1
#endif
#ifndef SPANGLE_FEATURE_FOG
#define SPANGLE_FEATURE_FOG 1
#endif
#ifndef SPANGLE_FEATURE_GET_PROC_ADDRESS
#define SPANGLE_FEATURE_GET_PROC_ADDRESS 1
#endif

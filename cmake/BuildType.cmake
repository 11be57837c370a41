# Chooses how a build is optimized when nobody else chose. This file is included before project(), which fills in CMake's own choices.

# Spangle's own builds measure -O2. A cache entry that exists before project() keeps CMake from making its own, and a value from the command
# line stays as it is.
if(CMAKE_SOURCE_DIR STREQUAL CMAKE_CURRENT_SOURCE_DIR)
    set(CMAKE_CXX_FLAGS_RELEASE "-O2" CACHE STRING "Flags of Release builds")
endif()

# Without a build type CMake compiles with -O0, where spans take about twenty times as long. As a subdirectory of another project, Spangle
# sets the type in its own scope only, so the targets of that project are compiled as its author said. A type, an -O flag in CMAKE_CXX_FLAGS
# (or CXXFLAGS), or a generator with several configurations is a choice, and stays.
function(spangle_default_build_type)
    if(CMAKE_BUILD_TYPE OR CMAKE_CONFIGURATION_TYPES OR CMAKE_CXX_FLAGS MATCHES "(^| )-O")
        return()
    endif()
    if(CMAKE_SOURCE_DIR STREQUAL PROJECT_SOURCE_DIR)
        set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
        return()
    endif()
    message(STATUS "Spangle: Release, for this project chose no build type (-DCMAKE_BUILD_TYPE=... changes that)")
    set(CMAKE_BUILD_TYPE Release PARENT_SCOPE)
    set(CMAKE_CXX_FLAGS_RELEASE "-O2" PARENT_SCOPE)
endfunction()

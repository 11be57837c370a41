# Scene profiles say what a build holds (docs/profiles.md). SPANGLE_PROFILE names a file of cmake/profiles, or your own file by its path,
# which sets some of
#   SPANGLE_PROFILE_FEATURES  the optional systems that are on, or all (cmake/Features.cmake); -DSPANGLE_FEATURE_... overrides the profile
#   SPANGLE_FUSED             the list of fused spans: a file of cmake/profiles/spans, a file beside the profile, or a path
#   SPANGLE_RANGES            how far the recorded program went, as NAME=NUMBER (gl/context/ranges.inc). Debug builds, and builds with
#                             SPANGLE_CHECK_RANGES, stop a program that goes farther, after a message
#   SPANGLE_OPTIMIZE          speed or size
#   any limit                 numbers, or lists of names as in set(SPANGLE_COLOR_FORMATS rgb565 grey4) (cmake/Limits.cmake)
# What a profile does not set is built whole. Builds without CMake take the same definitions from boards/tools/profile.py.
set(SPANGLE_PROFILE "" CACHE STRING "What the build holds: a file of cmake/profiles without its ending, or a path; empty: everything")

function(spangle_find_profile name folder ending out)
    foreach(file ${PROJECT_SOURCE_DIR}/cmake/profiles/${folder}${name}.${ending} ${ARGN}/${name} ${name})
        if(EXISTS ${file} AND NOT IS_DIRECTORY ${file})
            set(${out} ${file} PARENT_SCOPE)
            return()
        endif()
    endforeach()
    message(FATAL_ERROR "no profile '${name}': neither cmake/profiles/${folder}${name}.${ending} nor a path")
endfunction()

if(SPANGLE_PROFILE)
    spangle_find_profile(${SPANGLE_PROFILE} "" cmake profile_file)
    get_filename_component(profile_file ${profile_file} ABSOLUTE BASE_DIR ${CMAKE_SOURCE_DIR})
    get_filename_component(SPANGLE_PROFILE_FOLDER ${profile_file} DIRECTORY)
    include(${profile_file})
endif()

# The recorded ranges are checked only in builds that look for faults; the code of a release is the same without them.
option(SPANGLE_CHECK_RANGES "Builds of every type check the ranges of the profile, not Debug ones alone" OFF)
function(spangle_ranges target)
    if(NOT DEFINED SPANGLE_RANGES)
        return()
    endif()
    file(STRINGS ${PROJECT_SOURCE_DIR}/gl/context/ranges.inc known REGEX "^RANGE")
    list(TRANSFORM known REPLACE "^RANGE.([A-Z_]+),.*" "\\1")
    set(definitions SPANGLE_CHECK_RANGES=1)
    foreach(range ${SPANGLE_RANGES})
        string(REGEX MATCH "^([A-Z_]+)=[0-9]+$" matches ${range})
        if(NOT matches OR NOT CMAKE_MATCH_1 IN_LIST known)
            message(FATAL_ERROR "SPANGLE_RANGES: '${range}' is none of ${known} with a number")
        endif()
        list(APPEND definitions SPANGLE_RANGE_${range})
    endforeach()
    target_compile_definitions(${target} PUBLIC "$<$<OR:$<CONFIG:Debug>,$<BOOL:${SPANGLE_CHECK_RANGES}>>:${definitions}>")
endfunction()

# Makes the target use the profile's own list of fused spans.
function(spangle_fused target)
    if(DEFINED SPANGLE_FUSED)
        spangle_find_profile(${SPANGLE_FUSED} spans/ inc spans ${SPANGLE_PROFILE_FOLDER})
        target_compile_definitions(${target} PRIVATE SPANGLE_FUSED="${spans}")
    endif()
endfunction()

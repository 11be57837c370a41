# How every Spangle target is compiled. The core is C++20 that needs no operating system: no exceptions, no RTTI, no guards of statics.

# GCC 12 drops calls that have effects, and stores that are read, for two reasons:
#   Where a loop walks two arrays with different strides, the address of a store may become a null pointer and two numbers.
#   Later passes hold that nothing is stored through a null pointer, so the function counts as one without effects.
#   -fno-delete-null-pointer-checks makes null a pointer like any other.
#   The pass ipa-modref forgets that a structure passed by value is read where it lies. Without the pass nothing is forgotten.
# Other versions of GCC get the same flags, because nobody has shown that they are sound. Users of a target compile its
# inline functions, so the flags are part of the interface. They reach C++ that a GCC compiles and nothing else: C of the
# same project may have another compiler. GCC knows ipa-modref since version 11. Builds without CMake take the flags from
# boards/tools/firmware.py or boards/packages/package.json; tests/quality/calls holds all of them against each other.
set(SPANGLE_HAS_MODREF $<AND:$<COMPILE_LANG_AND_ID:CXX,GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,11>>)
set(SPANGLE_SOUND_CALLS $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-delete-null-pointer-checks> $<${SPANGLE_HAS_MODREF}:-fno-ipa-modref>)

function(spangle_common target)
    target_compile_options(${target} PUBLIC ${SPANGLE_SOUND_CALLS})
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion $<$<BOOL:${SPANGLE_WERROR}>:-Werror>)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
    set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    if(CMAKE_SYSTEM_NAME STREQUAL "Generic") # without an operating system programs share no library, and are linked to fixed addresses
        target_compile_definitions(${target} PRIVATE SPANGLE_FIRMWARE=1)
    else()
        set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    endif()
    if(SPANGLE_SHARED)
        spangle_export_public_headers(${target})
    endif()
endfunction()

# Sets the options of code that also runs in firmware.
function(spangle_core target)
    spangle_common(${target})
    target_compile_options(${target} PRIVATE -fno-exceptions -fno-rtti -fno-threadsafe-statics)
endfunction()

# Turns off vectors of words for sources that draw primitives one by one. They load words again soon after they store them, and a load of
# half a vector would have to wait until the stores have reached the cache.
function(spangle_word_by_word)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -fno-tree-slp-vectorize)
endfunction()

# Sets the options of code in double that must give the same bits everywhere.
function(spangle_reference target)
    spangle_common(${target})
    target_compile_options(${target} PRIVATE -ffp-contract=off)
endfunction()

function(spangle_features target)
    foreach(feature ${SPANGLE_FEATURES})
        target_compile_definitions(${target} PUBLIC SPANGLE_FEATURE_${feature}=$<BOOL:${SPANGLE_FEATURE_${feature}}>)
    endforeach()
    foreach(limit ${SPANGLE_LIMITS})
        target_compile_definitions(${target} PUBLIC SPANGLE_${limit}=${SPANGLE_NUMBER_${limit}})
    endforeach()
    # Programs compose tiers of their own (spangle/tier.hpp) on hosts only, where the code of every tier is linked.
    if(SPANGLE_HOST AND NOT CMAKE_SYSTEM_NAME STREQUAL "Generic" AND SPANGLE_NUMBER_TIER_SET EQUAL 7 AND SPANGLE_CHAIN)
        target_compile_definitions(${target} PUBLIC SPANGLE_OWN_TIERS=1)
    endif()
    spangle_fused(${target})
    spangle_ranges(${target})
endfunction()

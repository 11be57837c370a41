# How every Spangle target is compiled. The core is freestanding-ish C++20: no exceptions, no RTTI, no guards.

# GCC 12 takes some functions that write through a pointer for functions without effects, and then drops their calls.
# These two passes decide what a function writes; without them every call keeps its effects. Other versions of GCC get
# the same flags, because nobody has shown that theirs are sound. Users of a target compile its inline functions, so the flags
# are part of the interface. GCC knows -fno-ipa-modref since version 11.
set(SPANGLE_SOUND_CALLS
    $<$<CXX_COMPILER_ID:GNU>:-fno-ipa-pure-const>
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,11>>:-fno-ipa-modref>)

function(spangle_common target)
    target_compile_options(${target} PUBLIC ${SPANGLE_SOUND_CALLS})
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion $<$<BOOL:${SPANGLE_WERROR}>:-Werror>)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
    set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    if(CMAKE_SYSTEM_NAME STREQUAL "Generic") # no operating system: nothing is shared, every program is linked to its place
        target_compile_definitions(${target} PRIVATE SPANGLE_FIRMWARE=1)
    else()
        set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    endif()
    if(SPANGLE_SHARED)
        spangle_export_public_headers(${target})
    endif()
endfunction()

# Code that also runs in firmware.
function(spangle_core target)
    spangle_common(${target})
    target_compile_options(${target} PRIVATE -fno-exceptions -fno-rtti -fno-threadsafe-statics)
endfunction()

# Primitives one by one: words that were just stored are loaded again soon. As halves of one vector the load would have to
# wait until the stores have reached the cache.
function(spangle_word_by_word)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -fno-tree-slp-vectorize)
endfunction()

# Code in double that must give the same bits everywhere.
function(spangle_reference target)
    spangle_common(${target})
    target_compile_options(${target} PRIVATE -ffp-contract=off)
endfunction()

function(spangle_features target)
    foreach(feature ${SPANGLE_FEATURES})
        target_compile_definitions(${target} PUBLIC SPANGLE_FEATURE_${feature}=$<BOOL:${SPANGLE_FEATURE_${feature}}>)
    endforeach()
    foreach(limit ${SPANGLE_LIMITS})
        target_compile_definitions(${target} PUBLIC SPANGLE_${limit}=${SPANGLE_${limit}})
    endforeach()
    spangle_fused(${target})
endfunction()

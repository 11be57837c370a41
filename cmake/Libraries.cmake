# The libraries that users link: Spangle::gl and its rooms. Each room is a static library; with BUILD_SHARED_LIBS programs share them.
#
# Rooms of the core call each other's internal functions, and a shared library shows only what public headers declare. So raster,
# hal and gl are one libspangle.so, and each other room (linux, usb, sim) is one of its own. Programs of this tree, the command line
# and the tests, link the static libraries in either case, because they look at what is internal.
set(SPANGLE_ROOMS format raster hal mcu linux usb gl sim)
set(SPANGLE_CORE_ROOMS raster hal gl)
set(SPANGLE_SHARED OFF)
if(BUILD_SHARED_LIBS AND NOT CMAKE_SYSTEM_NAME STREQUAL "Generic")
    set(SPANGLE_SHARED ON)
endif()

# A shared library exports what public headers declare, and nothing else. For each public header there is a header of the same name in front
# of it, which the libraries' own sources find first and which includes the real header between two pragmas.
set(SPANGLE_EXPORTED ${PROJECT_BINARY_DIR}/exported)
function(spangle_write_exported_headers)
    foreach(room raster/format raster hal hal/mcu hal/linux hal/usb boards gl host_sim)
        set(includes ${PROJECT_SOURCE_DIR}/${room}/include)
        file(GLOB_RECURSE headers RELATIVE ${includes} CONFIGURE_DEPENDS ${includes}/*.h ${includes}/*.hpp)
        foreach(header ${headers})
            file(CONFIGURE OUTPUT ${SPANGLE_EXPORTED}/${header} @ONLY CONTENT
                 "#pragma GCC visibility push(default)\n#include \"@includes@/@header@\"\n#pragma GCC visibility pop\n")
        endforeach()
    endforeach()
endfunction()

# These flags keep calls inside of a library direct, and the current context one load away.
function(spangle_export_public_headers target)
    target_include_directories(${target} BEFORE PRIVATE ${SPANGLE_EXPORTED})
    target_compile_options(${target} PRIVATE -fno-semantic-interposition -ftls-model=initial-exec
                           $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
endfunction()

# Makes a shared library from the objects of some rooms. Internals that a room uses of another room are linked from that room's archive,
# hidden.
function(spangle_shared_library target name)
    set(objects)
    foreach(room ${ARGN})
        list(APPEND objects $<TARGET_OBJECTS:spangle_${room}>)
    endforeach()
    add_library(${target} SHARED ${objects})
    set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name} VERSION ${PROJECT_VERSION} LINKER_LANGUAGE CXX
                          SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    target_link_options(${target} PRIVATE -Wl,--exclude-libs,ALL -Wl,-Bsymbolic-functions -Wl,--no-undefined)
endfunction()

# Makes Spangle::NAME of a shared build: it has the usage requirements of the static library, and links the shared library.
function(spangle_shared_room name library)
    set(target spangle_shared_${name})
    add_library(${target} INTERFACE)
    foreach(property INCLUDE_DIRECTORIES COMPILE_DEFINITIONS COMPILE_OPTIONS COMPILE_FEATURES)
        get_target_property(value spangle_${name} INTERFACE_${property})
        if(value)
            set_property(TARGET ${target} PROPERTY INTERFACE_${property} "${value}")
        endif()
    endforeach()
    get_target_property(links spangle_${name} INTERFACE_LINK_LIBRARIES)
    foreach(link ${links})
        string(REGEX REPLACE "^spangle_" "spangle_shared_" shared ${link})
        if(TARGET ${shared})
            target_link_libraries(${target} INTERFACE ${shared})
        elseif(TARGET ${link})
            target_link_libraries(${target} INTERFACE ${link})
        endif()
    endforeach()
    if(library)
        target_link_libraries(${target} INTERFACE ${library})
    endif()
endfunction()

# Finds the system's libraries that a room links. The room found them in the scope of its own folder only.
function(spangle_find_links name)
    if(name STREQUAL "linux")
        find_package(Threads REQUIRED)
    elseif(name STREQUAL "sim")
        find_package(PNG REQUIRED)
    endif()
endfunction()

function(spangle_libraries)
    if(SPANGLE_SHARED)
        spangle_shared_library(spangle_shared_library spangle ${SPANGLE_CORE_ROOMS})
    endif()
    foreach(name ${SPANGLE_ROOMS})
        if(NOT TARGET spangle_${name})
            continue()
        endif()
        if(NOT SPANGLE_SHARED)
            add_library(Spangle::${name} ALIAS spangle_${name})
            continue()
        endif()
        set(library)
        if(name IN_LIST SPANGLE_CORE_ROOMS)
            set(library spangle_shared_library)
        elseif(NOT name MATCHES "^(format|mcu)$")
            set(library spangle_shared_library_${name})
            spangle_shared_library(${library} spangle_${name} ${name})
            spangle_find_links(${name})
            get_target_property(links spangle_${name} LINK_LIBRARIES)
            # Shared libraries come first, so that an archive behind them adds only what they do not export.
            target_link_libraries(${library} PRIVATE spangle_shared_library)
            foreach(link ${links})
                string(REGEX REPLACE "^spangle_" "spangle_shared_library_" shared ${link})
                if(TARGET ${shared})
                    target_link_libraries(${library} PRIVATE ${shared})
                endif()
            endforeach()
            target_link_libraries(${library} PRIVATE ${links})
        endif()
        spangle_shared_room(${name} "${library}")
        add_library(Spangle::${name} ALIAS spangle_shared_${name})
    endforeach()
    foreach(name raster_reference gl_reference) # for spangle/reference.hpp; they use internals, so they are static only
        if(TARGET spangle_${name} AND NOT SPANGLE_SHARED)
            add_library(Spangle::${name} ALIAS spangle_${name})
        endif()
    endforeach()
endfunction()

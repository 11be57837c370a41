# Writes the files for pkg-config: spangle-gl.pc and one for each other room, with the flags that users of the CMake targets get. The
# system's libraries that a static library needs are required by name; a shared library names them itself.

function(spangle_pkg_config name text)
    cmake_parse_arguments(PC "" "" "ROOMS;SYSTEM" ${ARGN})
    if(NOT TARGET spangle_${name})
        return()
    endif()
    list(TRANSFORM PC_ROOMS PREPEND "spangle-")
    set(requires ${PC_ROOMS})
    if(NOT SPANGLE_SHARED)
        list(APPEND requires ${PC_SYSTEM})
    endif()
    list(JOIN requires ", " requires)
    set(libs)
    if(SPANGLE_SHARED AND name IN_LIST SPANGLE_CORE_ROOMS)
        set(libs "-L\${libdir} -lspangle")
    elseif(NOT name STREQUAL "format")
        set(libs "-L\${libdir} -lspangle_${name}")
    endif()
    if(name STREQUAL "linux" AND NOT SPANGLE_SHARED)
        string(APPEND libs " -pthread")
    endif()
    set(definitions $<REMOVE_DUPLICATES:$<TARGET_PROPERTY:spangle_${name},INTERFACE_COMPILE_DEFINITIONS>>)
    # A .pc file serves no single language, so its options are those of C++. They are the room's own options; required files bring theirs.
    get_target_property(options spangle_${name} INTERFACE_COMPILE_OPTIONS)
    if(NOT options)
        set(options)
    endif()
    string(REPLACE "COMPILE_LANG_AND_ID:CXX," "CXX_COMPILER_ID:" options "${options}")
    file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/pkgconfig/spangle-${name}.pc CONTENT
"prefix=${SPANGLE_PC_PREFIX}
libdir=${SPANGLE_PC_LIBDIR}
includedir=${SPANGLE_PC_INCLUDEDIR}

Name: spangle-${name}
Description: ${text}
Version: ${PROJECT_VERSION}
Requires: ${requires}
Cflags: -I\${includedir} $<JOIN:${options}, > $<$<BOOL:${definitions}>:-D$<JOIN:${definitions}, -D>>
Libs: ${libs}
" TARGET spangle_${name})
    install(FILES ${PROJECT_BINARY_DIR}/pkgconfig/spangle-${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

# An installed tree may be moved, so the prefix is relative to these files. Folders that a build placed outside of the prefix stay absolute.
set(SPANGLE_PC_PREFIX ${CMAKE_INSTALL_PREFIX})
set(SPANGLE_PC_LIBDIR ${CMAKE_INSTALL_FULL_LIBDIR})
set(SPANGLE_PC_INCLUDEDIR ${CMAKE_INSTALL_FULL_INCLUDEDIR})
if(NOT IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}" AND NOT IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
    string(REGEX REPLACE "[^/]+" ".." up "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
    set(SPANGLE_PC_PREFIX "\${pcfiledir}/${up}")
    set(SPANGLE_PC_LIBDIR "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
    set(SPANGLE_PC_INCLUDEDIR "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
endif()

set(usb_needs libusb-1.0)
if(LZ4_FOUND)
    list(APPEND usb_needs liblz4)
endif()
if(FTDI_FOUND)
    list(APPEND usb_needs libftdi1)
endif()
set(linux_needs)
if(NOT "${SPANGLE_GPIOD}" MATCHES "^(none)?$")
    set(linux_needs libgpiod)
endif()
spangle_pkg_config(format "Pixels, rectangles and touched rows of Spangle")
spangle_pkg_config(raster "Span rasterizer of Spangle" ROOMS format)
spangle_pkg_config(hal "Panels, buses and displays of Spangle" ROOMS format)
spangle_pkg_config(gl "OpenGL for small display boards" ROOMS raster hal)
if(NOT SPANGLE_SHARED)
    spangle_pkg_config(raster_reference "Span rasterizer of Spangle in double" ROOMS raster)
    spangle_pkg_config(gl_reference "Spangle's reference in double, and error figures" ROOMS gl raster_reference)
endif()
spangle_pkg_config(linux "Spangle's buses of Linux: spidev, I2C, GPIO lines" ROOMS hal SYSTEM ${linux_needs})
spangle_pkg_config(usb "Spangle's displays behind USB" ROOMS linux SYSTEM ${usb_needs})
spangle_pkg_config(sim "Spangle's simulated panels and pictures" ROOMS hal SYSTEM libpng)

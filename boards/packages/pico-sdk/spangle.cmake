# Written by boards/packages/generate.py: change package.json or that, not this.
# In a project of the Pico SDK, behind pico_sdk_init(): include(boards/packages/pico-sdk/spangle.cmake), then link Spangle::gl.
set(SPANGLE_HOST OFF)
set(SPANGLE_TESTS OFF)
set(SPANGLE_LINUX OFF)
add_subdirectory(${CMAKE_CURRENT_LIST_DIR}/../../.. ${CMAKE_CURRENT_BINARY_DIR}/spangle)
foreach(part spangle_raster spangle_hal spangle_gl)
    target_compile_definitions(${part} PUBLIC SPANGLE_FIRMWARE=1)
endforeach()
target_include_directories(spangle_hal PUBLIC ${CMAKE_CURRENT_LIST_DIR}/../../include)

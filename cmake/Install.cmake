# find_package(Spangle CONFIG) gives Spangle::gl, Spangle::raster, Spangle::hal and, where it was built, Spangle::sim.
include(CMakePackageConfigHelpers)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Spangle)
foreach(name format raster hal gl raster_reference gl_reference sim)
    if(TARGET spangle_${name})
        set_target_properties(spangle_${name} PROPERTIES EXPORT_NAME ${name})
        install(TARGETS spangle_${name} EXPORT SpangleTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    endif()
endforeach()
foreach(room raster/format raster hal gl host_sim)
    if(IS_DIRECTORY ${PROJECT_SOURCE_DIR}/${room}/include)
        install(DIRECTORY ${PROJECT_SOURCE_DIR}/${room}/include/spangle DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    endif()
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/boards/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/spangle/boards
        FILES_MATCHING PATTERN "*.hpp" PATTERN scenes EXCLUDE PATTERN mps2 EXCLUDE)
install(EXPORT SpangleTargets NAMESPACE Spangle:: DESTINATION ${package})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/SpangleConfig.cmake.in ${PROJECT_BINARY_DIR}/SpangleConfig.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/SpangleConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/SpangleConfig.cmake ${PROJECT_BINARY_DIR}/SpangleConfigVersion.cmake DESTINATION ${package})

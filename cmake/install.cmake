# `find_package(ridgeline)` gives ridgeline::geometry, ::laz, ::appearance, ::scene, ::extract,
# ::surface, ::match, ::tracks, ::estimate, ::reconstruct, ::io, ::evaluate and ::results.
include(CMakePackageConfigHelpers)

# ridgeline::laz and what it rests on can be found alone: find_package(ridgeline COMPONENTS laz).
function(install_libraries export)
  install(TARGETS ${ARGN}
    EXPORT ${export}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ridgeline COMPONENT dev)
  install(EXPORT ${export} NAMESPACE ridgeline:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ridgeline COMPONENT dev)
endfunction()
install_libraries(ridgelineLazTargets ridgeline_geometry ridgeline_laz)
install_libraries(ridgelineTargets ridgeline_appearance ridgeline_scene ridgeline_extract ridgeline_surface
  ridgeline_match ridgeline_tracks ridgeline_estimate ridgeline_reconstruct ridgeline_io ridgeline_evaluate
  ridgeline_results)
install(TARGETS ridgeline DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(DIRECTORY sample_data DESTINATION ${CMAKE_INSTALL_DATADIR}/ridgeline COMPONENT program PATTERN make.sh EXCLUDE)

configure_package_config_file(cmake/ridgelineConfig.cmake.in ${PROJECT_BINARY_DIR}/ridgelineConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ridgeline)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ridgelineConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ridgelineConfig.cmake
              ${PROJECT_BINARY_DIR}/ridgelineConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ridgeline COMPONENT dev)

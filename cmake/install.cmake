# `find_package(ridgeline)` gives ridgeline::geometry, ::extract, ::match, ::chio, ::estimate,
# ::reconstruct, ::io and ::evaluate.
include(CMakePackageConfigHelpers)

set(libraries ridgeline_geometry ridgeline_views ridgeline_extract ridgeline_match ridgeline_chio ridgeline_estimate
    ridgeline_beyond ridgeline_reconstruct ridgeline_io ridgeline_evaluate)
install(TARGETS ${libraries}
  EXPORT ridgelineTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ridgeline)
install(TARGETS ridgeline DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY sample_data DESTINATION ${CMAKE_INSTALL_DATADIR}/ridgeline)
install(EXPORT ridgelineTargets NAMESPACE ridgeline::
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ridgeline)

configure_package_config_file(cmake/ridgelineConfig.cmake.in ${PROJECT_BINARY_DIR}/ridgelineConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ridgeline)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ridgelineConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ridgelineConfig.cmake
              ${PROJECT_BINARY_DIR}/ridgelineConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ridgeline)

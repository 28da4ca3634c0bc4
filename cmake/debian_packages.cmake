# The target `packages` makes Debian packages in build/.../packages: `ridgeline`, the program with
# its manual, completion and sample data, `libridgeline-dev`, the libraries with their headers,
# CMake files and examples, and with RIDGELINE_BUILD_PYTHON `python3-ridgeline`. It needs help2man
# and dpkg-dev.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "Ridgeline developers <developers@ridgeline.invalid>")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program dev)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME ridgeline)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS proj-data)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
"Reconstructs roof ridges, eaves and hips as 3D line segments from oriented
aerial images and measures how accurate they are against LAS, LAZ, PCD or PLY
point clouds. Lines of any other tool are judged as well: tables, maps and a
report of the distances, and an exit code for accuracy gates.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libridgeline-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
string(JOIN ", " CPACK_DEBIAN_DEV_PACKAGE_DEPENDS  # what ridgelineConfig.cmake looks for
  libboost-dev libeigen3-dev libexpat1-dev libfmt-dev libgdal-dev libopencv-dev libpcl-dev libproj-dev libsqlite3-dev libssl-dev
  libtbb-dev libyaml-cpp-dev nlohmann-json3-dev pkg-config zlib1g-dev)
set(CPACK_COMPONENT_DEV_DESCRIPTION
"Static libraries, headers and CMake files to reconstruct 3D line segments from
oriented aerial images and to judge lines against point clouds of PCL, from
C++20. The command find_package(ridgeline) of CMake finds them.")

if(RIDGELINE_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-ridgeline)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${PROJECT_SOURCE_DIR}/cmake/debian_python/postinst ${PROJECT_SOURCE_DIR}/cmake/debian_python/prerm)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")  # an extension module is of one minor version
  string(JOIN ", " CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python_VERSION_MINOR}~)" "python3 (<< 3.${next_minor})" python3-numpy proj-data)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION
"Judges 3D lines against point clouds, reconstructs them from oriented aerial
images and reads LAS, LAZ and COPC, from Python and in NumPy arrays: distances,
tables, maps and accuracy gates of the program ridgeline.")
endif()

set(debian ${PROJECT_BINARY_DIR}/debian)
add_custom_target(debian_files
  COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:ridgeline> -DVERSION=${PROJECT_VERSION} -DOUT=${debian}
          -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -P ${PROJECT_SOURCE_DIR}/cmake/debian_files.cmake
  DEPENDS ridgeline VERBATIM)
install(DIRECTORY ${debian}/man1 DESTINATION share/man COMPONENT program OPTIONAL)
install(DIRECTORY ${debian}/doc/ DESTINATION share/doc/ridgeline COMPONENT program OPTIONAL)
install(DIRECTORY ${debian}/doc/ DESTINATION share/doc/libridgeline-dev COMPONENT dev OPTIONAL)
install(FILES apps/completion.bash DESTINATION share/bash-completion/completions RENAME ridgeline COMPONENT program)
install(FILES tests/consumer/CMakeLists.txt tests/consumer/main.cpp tests/consumer/pcl_lines.cpp
        DESTINATION share/doc/libridgeline-dev/examples COMPONENT dev)

if(RIDGELINE_BUILD_PYTHON)
  install(DIRECTORY ${debian}/doc/ DESTINATION share/doc/python3-ridgeline COMPONENT python OPTIONAL)
  install(TARGETS ridgeline_python LIBRARY DESTINATION lib/python3/dist-packages/ridgeline COMPONENT python)
  install(DIRECTORY apps/python/ridgeline DESTINATION lib/python3/dist-packages COMPONENT python
          PATTERN __pycache__ EXCLUDE)
endif()

include(CPack)
add_custom_target(packages
  COMMAND ${CMAKE_CPACK_COMMAND} --config ${PROJECT_BINARY_DIR}/CPackConfig.cmake
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR} VERBATIM)
add_dependencies(packages debian_files ridgeline ridgeline_results ridgeline_reconstruct)
if(RIDGELINE_BUILD_PYTHON)
  add_dependencies(packages ridgeline_python)
endif()

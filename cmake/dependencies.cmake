find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(Boost REQUIRED)
find_package(GDAL REQUIRED)
find_package(OpenSSL REQUIRED)
find_package(SQLite3 REQUIRED)
find_package(EXPAT REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PROJ CONFIG QUIET)
find_package(nlohmann_json REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(CLI11 REQUIRED)
find_package(embree 3 REQUIRED)
# PCL's components by name: pcl_io, pcl_surface and pcl_visualization would bring VTK and Qt.
pkg_check_modules(PCL REQUIRED IMPORTED_TARGET
  pcl_common pcl_kdtree pcl_search pcl_sample_consensus)
pkg_check_modules(PROJ_PC REQUIRED IMPORTED_TARGET proj)
find_package(OpenCV 4 REQUIRED COMPONENTS core imgproc features2d)

if(RIDGELINE_BUILD_PYTHON)
  find_package(Python 3.11 REQUIRED COMPONENTS Interpreter Development.Module)
  set(PYBIND11_NOPYTHON ON)  # the Python is the one found above
  find_package(pybind11 2.10 REQUIRED CONFIG)
endif()

# OpenCV's shared libraries bring Mesa and LLVM for windows that the program never opens: 46
# packages.
option(RIDGELINE_STATIC_OPENCV "Link OpenCV's archives, for a program that needs none of its packages" OFF)
if(RIDGELINE_STATIC_OPENCV)
  find_package(LAPACK REQUIRED)
  foreach(module core flann imgproc features2d)
    find_library(ridgeline_opencv_${module} NAMES libopencv_${module}.a REQUIRED)
    set_target_properties(opencv_${module} PROPERTIES IMPORTED_LOCATION_RELEASE ${ridgeline_opencv_${module}})
  endforeach()
  target_link_libraries(opencv_core INTERFACE TBB::tbb ZLIB::ZLIB LAPACK::LAPACK ${CMAKE_DL_LIBS})
  target_link_options(opencv_core INTERFACE
    LINKER:--as-needed LINKER:--gc-sections LINKER:--defsym=glXGetProcAddressARB=0)
endif()

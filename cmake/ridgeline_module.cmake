# Flags belong to an interface target, never to global variables.
add_library(ridgeline_flags INTERFACE)
target_compile_features(ridgeline_flags INTERFACE cxx_std_20)
target_compile_options(ridgeline_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  $<$<BOOL:${RIDGELINE_WERROR}>:-Werror>)

# What nearly every file includes; Eigen alone takes a second and a half to parse.
set(ridgeline_common_headers <Eigen/Dense> <algorithm> <cmath> <map> <memory> <optional> <span>
    <string> <vector>)

# ridgeline_module(NAME SOURCES a.cpp... HEADERS a.h... [DEPENDS t...] [PRIVATE_DEPENDS t...])
# A library ridgeline_NAME with the alias ridgeline::NAME. Files are listed relative to the calling
# folder; headers are included from the root of the tree: "reconstruct/geometry/line.h".
function(ridgeline_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;HEADERS;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(ridgeline_${name} STATIC ${arg_SOURCES})
  add_library(ridgeline::${name} ALIAS ridgeline_${name})
  set_target_properties(ridgeline_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON
                        VERSION ${PROJECT_VERSION})
  target_sources(ridgeline_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}
                 FILES ${arg_HEADERS})
  target_link_libraries(ridgeline_${name} PUBLIC ${arg_DEPENDS}
                        PRIVATE ${arg_PRIVATE_DEPENDS} $<BUILD_INTERFACE:ridgeline_flags>)
  target_compile_features(ridgeline_${name} PUBLIC cxx_std_20)
  target_precompile_headers(ridgeline_${name} PRIVATE ${ridgeline_common_headers})
endfunction()

# ridgeline_vectorise(NAME): for modules that loop over pixels or samples of them, which -O2 of GCC 12 leaves
# scalar. Others gain nothing and take longer to compile.
function(ridgeline_vectorise name)
  target_compile_options(ridgeline_${name} PRIVATE $<$<CONFIG:Release>:-O3;-fno-math-errno;-fno-trapping-math>)
endfunction()

# ridgeline_test(NAME SOURCES a_test.cpp... [DEPENDS t...] [LABELS l...]): one GoogleTest binary, its
# cases found by ctest. The label `slow` keeps a test out of the sanitizers' run.
function(ridgeline_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS;LABELS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} ridgeline_test_support GTest::gmock
                        GTest::gtest_main ridgeline_flags)
  target_precompile_headers(${name} REUSE_FROM ridgeline_test_headers)
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60
                       PROPERTIES TIMEOUT 600 LABELS "${arg_LABELS}")
endfunction()

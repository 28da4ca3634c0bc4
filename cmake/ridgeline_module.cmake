# Flags belong to an interface target, never to global variables.
add_library(ridgeline_flags INTERFACE)
target_compile_features(ridgeline_flags INTERFACE cxx_std_20)
target_compile_options(ridgeline_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  $<$<BOOL:${RIDGELINE_WERROR}>:-Werror>
  # GCC tidies its memory less often, which saves it a twelfth of its time
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>
  # GCC takes every source of a unity file but the file itself for a header
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wno-subobject-linkage>)

# A note that each source with a header of Boost's geometry would print, about a header that Boost
# itself includes.
target_compile_definitions(ridgeline_flags INTERFACE BOOST_ALLOW_DEPRECATED_HEADERS)

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
endfunction()

# ridgeline_vectorise(NAME): for modules that loop over pixels or samples of them, which -O2 of GCC
# 12 leaves scalar. Others gain nothing and take longer to compile.
function(ridgeline_vectorise name)
  target_compile_options(ridgeline_${name} PRIVATE $<$<CONFIG:Release>:-O3;-fno-math-errno;-fno-trapping-math>)
endfunction()

# ridgeline_test(NAME [LITTLE_COMPUTED] SOURCES a_test.cpp... [DEPENDS t...] [LABELS l...]): one
# GoogleTest binary. Its cases are found by ctest; with RIDGELINE_TEST_SHARDS the binary runs as so
# many tests instead, which saves the start of a process for every case. Binaries with the label
# `slow` are left out without RIDGELINE_BUILD_SLOW_TESTS. With LITTLE_COMPUTED Clang compiles the
# tests without optimisation, in half the time. The libraries then run the tests' slow copies of the
# Eigen templates that both use: not for tests that compute for seconds.
function(ridgeline_test name)
  cmake_parse_arguments(arg "LITTLE_COMPUTED" "" "SOURCES;DEPENDS;LABELS" ${ARGN})
  if("slow" IN_LIST arg_LABELS AND NOT RIDGELINE_BUILD_SLOW_TESTS)
    set(left_out EXCLUDE_FROM_ALL)
  endif()
  add_executable(${name} ${left_out} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} ridgeline_test_support ridgeline_flags ridgeline_test_flags
                        GTest::gmock GTest::gtest_main)
  # GoogleTest's macros hold __FILE__. It is relative, so that a compiler cache serves every
  # checkout. The precompiled header is made without this flag, because it would keep the path of
  # its checkout.
  target_compile_options(${name} PRIVATE -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=
                         $<$<AND:$<BOOL:${arg_LITTLE_COMPUTED}>,$<CXX_COMPILER_ID:Clang>>:-O0>)
  if(TARGET ridgeline_test_headers)
    target_precompile_headers(${name} REUSE_FROM ridgeline_test_headers)
  endif()
  if(left_out)
    return()
  endif()
  if(NOT RIDGELINE_TEST_SHARDS)
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 NO_PRETTY_VALUES
                         PROPERTIES TIMEOUT 600 LABELS "${arg_LABELS}")
    return()
  endif()
  math(EXPR last_shard "${RIDGELINE_TEST_SHARDS} - 1")
  foreach(shard RANGE ${last_shard})
    add_test(NAME ${name}_${shard} COMMAND ${name} --gtest_brief=1)
    set_tests_properties(${name}_${shard} PROPERTIES TIMEOUT 1200 LABELS "${arg_LABELS}" ENVIRONMENT
                         "GTEST_TOTAL_SHARDS=${RIDGELINE_TEST_SHARDS};GTEST_SHARD_INDEX=${shard}")
  endforeach()
endfunction()

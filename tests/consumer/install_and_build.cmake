# Installs the build tree BUILD_DIR into WORK_DIR, then configures, builds and runs the consumer.
# cmake -D BUILD_DIR=... -D WORK_DIR=... -D SOURCE_DIR=... -D CXX_COMPILER=... -D CXX_FLAGS=...
#       -D BUILD_TYPE=... -P install_and_build.cmake
foreach(argument BUILD_DIR WORK_DIR SOURCE_DIR CXX_COMPILER)
  if(NOT ${argument})
    message(FATAL_ERROR "${argument} is not set")
  endif()
endforeach()

file(REMOVE_RECURSE ${WORK_DIR})
set(prefix ${WORK_DIR}/prefix)

execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix}
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/build
                        -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_BUILD_TYPE=${BUILD_TYPE}
                        -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_CXX_FLAGS=${CXX_FLAGS}
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK_DIR}/build COMMAND_ERROR_IS_FATAL ANY)
foreach(program consumer pcl_lines)
  execute_process(COMMAND ${WORK_DIR}/build/${program} WORKING_DIRECTORY ${WORK_DIR}/build
                  COMMAND_ERROR_IS_FATAL ANY)
endforeach()

# the README's example, the LAZ library alone, and edges of a cloud of PCL
foreach(project readme laz edges)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR}/${project} -B ${WORK_DIR}/${project}
                          -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_BUILD_TYPE=${BUILD_TYPE}
                          -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_CXX_FLAGS=${CXX_FLAGS}
                          -DREADME=${SOURCE_DIR}/../../README.md
                  COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK_DIR}/${project} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${WORK_DIR}/readme/readme_example OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
if(NOT printed MATCHES "^eave 0\\.1.*\n.* 270")
  message(FATAL_ERROR "The README's example prints: ${printed}")
endif()
execute_process(COMMAND ${WORK_DIR}/laz/laz_consumer ${SOURCE_DIR}/../../sample_data/1/lidar.las
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK_DIR}/edges/pcl_edges COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${prefix}/bin/ridgeline --version COMMAND_ERROR_IS_FATAL ANY)

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

# the LAZ library alone
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR}/laz -B ${WORK_DIR}/laz
                        -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_BUILD_TYPE=${BUILD_TYPE}
                        -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_CXX_FLAGS=${CXX_FLAGS}
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK_DIR}/laz COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK_DIR}/laz/laz_consumer ${SOURCE_DIR}/../../sample_data/1/lidar.las
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${prefix}/bin/ridgeline --version COMMAND_ERROR_IS_FATAL ANY)

# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D BUILD=... -D SOURCE=... -D FLAGS=... -P installed_package.cmake
# Installs dmp into a folder of its own, builds the project in consumer/ against it, and runs both.
set(work ${BUILD}/installed_package)
file(REMOVE_RECURSE ${work})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT code EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${code}\n${output}\n${errors}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${work}/installed)
run(${work}/installed/bin/dmp --version)
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/end_to_end/consumer -B ${work}/consumer -G Ninja -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_PREFIX_PATH=${work}/installed -D CMAKE_CXX_FLAGS=${FLAGS})
run(${CMAKE_COMMAND} --build ${work}/consumer)
run(${work}/consumer/consumer ${SOURCE}/cases/verification/poiseuille "0.01 s" ${work}/frames)
if(NOT output STREQUAL "208 particles, 0 lost\n")
  message(FATAL_ERROR "the consumer printed: ${output}")
endif()

# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DNM=nm -DPROGRAM=dmp -P own_symbols_stay_inside.cmake
# What a program shows to shared libraries stands in for what they have under the same name. libgmsh's functions of Eigen
# are compiled for other vectors: with ours it crashed on some geometries.
execute_process(COMMAND ${NM} --dynamic --demangle --defined-only ${PROGRAM} OUTPUT_VARIABLE symbols
                COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE ";" "," symbols "${symbols}")
string(REPLACE "\n" ";" symbols "${symbols}")
if(NOT symbols MATCHES "[0-9a-f]+ [A-Za-z] ")
  message(SEND_ERROR "${PROGRAM} has no dynamic symbols: nothing was looked at")
endif()
foreach(symbol IN LISTS symbols)
  if(symbol MATCHES "Eigen::|dmp::")
    message(SEND_ERROR "${PROGRAM} shows ${symbol}: build with hidden symbols (CMakeLists.txt), and without -rdynamic")
  endif()
endforeach()

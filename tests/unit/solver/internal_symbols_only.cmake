# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DNM=nm -DOBJECTS=a.o;b.o -P internal_symbols_only.cmake
# What is compiled for one vector unit may run only where that unit is. Of a function that several object files define
# as a weak symbol the linker keeps any one, for all of them: every weak function here must carry the type of its lanes
# or the unit in its name. Nor may anything run when the program starts.
foreach(object IN LISTS OBJECTS)
  execute_process(COMMAND ${NM} --demangle --defined-only ${object} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE ";" "," symbols "${symbols}")
  string(REPLACE "\n" ";" symbols "${symbols}")
  if(NOT symbols MATCHES "compiled_(contact_)?sweeps?<")
    message(SEND_ERROR "${object} defines no function at all:\n${symbols}")
  endif()
  foreach(symbol IN LISTS symbols)
    if(symbol MATCHES "_GLOBAL__sub_I|_GLOBAL__I_")
      message(SEND_ERROR "${object} runs code when the program starts: ${symbol}")
    elseif(symbol MATCHES "^[0-9a-f]* [Ww] " AND NOT symbol MATCHES "BasicLanes|VectorUnit")
      message(SEND_ERROR "${object} defines what may stand in for another unit's: ${symbol}")
    endif()
  endforeach()
endforeach()

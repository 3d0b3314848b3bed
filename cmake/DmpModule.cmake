# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
# Rules that hold in every module, written once.

add_library(dmp_rules INTERFACE)
target_compile_features(dmp_rules INTERFACE cxx_std_20)
target_compile_options(dmp_rules INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                           -Wnon-virtual-dtor -Werror)
if(DMP_FUZZ)
  target_compile_options(dmp_rules INTERFACE -w)  # another compiler has other warnings
endif()
# GCC 12 warns of overlapping copies inside std::string's operator+ where there are none (GCC bug 105651).
target_compile_options(dmp_rules INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# Fused multiply-adds everywhere, as the sweeps over pairs have them (solver/CMakeLists.txt): one program for all x86
# processors of the last ten years.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  target_compile_options(dmp_rules INTERFACE -march=x86-64-v3)
endif()
if(DMP_SANITIZE)
  target_compile_options(dmp_rules INTERFACE -fsanitize=${DMP_SANITIZE} -fno-omit-frame-pointer
                                             -fno-sanitize-recover=all)
  # Between the checks that sanitizers put in, GCC loses track of what was set (its manual says so of -fsanitize).
  target_compile_options(dmp_rules INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(dmp_rules INTERFACE -fsanitize=${DMP_SANITIZE})
endif()

# Precompiled headers save a third of a module's compile time: nearly every file includes these. A compiler cache does
# better without.
set(dmp_common_headers <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <span> <sstream>
                       <string> <string_view> <vector> <Eigen/Core>)

# dmp_module(NAME SOURCES a.cpp ... [LINKS public ...] [PRIVATE_LINKS ...])
# One static library dmp_NAME, known to others as dmp::NAME; headers are included as "NAME/header.hpp".
function(dmp_module name)
  cmake_parse_arguments(MODULE "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(dmp_${name} STATIC ${MODULE_SOURCES})
  add_library(dmp::${name} ALIAS dmp_${name})
  target_compile_features(dmp_${name} PUBLIC cxx_std_20)
  set_target_properties(dmp_${name} PROPERTIES EXPORT_NAME ${name} CXX_EXTENSIONS OFF)
  target_include_directories(dmp_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                                $<INSTALL_INTERFACE:include/dmp>)
  target_link_libraries(dmp_${name} PUBLIC ${MODULE_LINKS} PRIVATE $<BUILD_INTERFACE:dmp_rules> ${MODULE_PRIVATE_LINKS})
  dmp_compile_together(dmp_${name})
  list(LENGTH MODULE_SOURCES files)
  if(files GREATER 8)
    dmp_precompile(dmp_${name} dmp::${name} ${MODULE_LINKS})
  endif()
endfunction()

# dmp_compile_together(TARGET): several source files per compiler run, where DMP_UNITY is on.
function(dmp_compile_together target)
  if(DMP_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    # A type of an anonymous namespace in another file's type is no error where both are compiled as one file.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# dmp_precompile(TARGET [links]): precompiles the common headers for a target, and those of the scene where it links it.
function(dmp_precompile target)
  if(CMAKE_CXX_COMPILER_LAUNCHER OR DMP_SANITIZE)
    return()
  endif()
  set(headers ${dmp_common_headers})
  if("dmp::scene" IN_LIST ARGN)
    list(APPEND headers ${PROJECT_SOURCE_DIR}/scene/scene.hpp)
  endif()
  if("dmp::particles" IN_LIST ARGN)
    list(APPEND headers ${PROJECT_SOURCE_DIR}/particles/particle_set.hpp)
  endif()
  target_precompile_headers(${target} PRIVATE ${headers})
  # Out of a precompiled header, GCC 12 warns of sizes and offsets in std::string that cannot be (GCC bug 105651).
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow -Wno-array-bounds>)
endfunction()

# What tests add to a library's optimised code are short loops: compiling them lightly saves a sixth of a whole build.
set(dmp_test_options $<$<CONFIG:Release>:-O1>)

# Lets a test use the headers that tests/CMakeLists.txt precompiles, where it does.
function(dmp_use_test_headers target)
  if(TARGET dmp_test_headers)
    target_precompile_headers(${target} REUSE_FROM dmp_test_headers)
    set_target_properties(${target} PROPERTIES PCH_WARN_INVALID OFF)
  endif()
endfunction()

# dmp_test_program(NAME SOURCES a.cpp ... LIBRARIES library... [LABEL l] [QUICK [SLOW pattern...]] [TIMEOUT seconds]
# [PROPERTIES ctest's...]): one GoogleTest program test_NAME from source files in the current folder; each of its tests is
# a test of ctest. QUICK: `./dmp test --quick` builds it (target quick_tests) and runs it as a whole, as many of the
# programs take longer to start than a test, without the tests that match a pattern of SLOW.
function(dmp_test_program name)
  cmake_parse_arguments(TEST "QUICK" "LABEL;TIMEOUT" "SOURCES;LIBRARIES;SLOW;PROPERTIES" ${ARGN})
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 3000)  # ten times what a busy machine needs
  endif()
  if(DMP_SANITIZE)
    math(EXPR TEST_TIMEOUT "5 * ${TEST_TIMEOUT}")  # the solver is twenty times slower with them
  endif()
  add_executable(test_${name} ${TEST_SOURCES})
  target_link_libraries(test_${name} PRIVATE dmp_rules GTest::gtest_main GTest::gmock OpenMP::OpenMP_CXX
                                             ${TEST_LIBRARIES})
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(test_${name} PRIVATE ${dmp_test_options})
  dmp_use_test_headers(test_${name})
  dmp_compile_together(test_${name})
  target_compile_definitions(test_${name} PRIVATE DMP_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                                  DMP_BUILD_DIR="${PROJECT_BINARY_DIR}")
  set(properties TIMEOUT ${TEST_TIMEOUT} ${TEST_PROPERTIES})
  if(TEST_LABEL)  # an empty value would take the next property's name for its own
    list(APPEND properties LABELS ${TEST_LABEL})
  endif()
  if(TEST_QUICK)
    list(JOIN TEST_SLOW ":" slow)
    add_dependencies(quick_tests test_${name})
    add_test(NAME quick.${name} COMMAND test_${name} --gtest_brief=1 "--gtest_filter=*-${slow}")
    set_tests_properties(quick.${name} PROPERTIES LABELS quick_program TIMEOUT ${TEST_TIMEOUT} ${TEST_PROPERTIES})
  endif()
  gtest_discover_tests(test_${name} PROPERTIES ${properties} DISCOVERY_TIMEOUT 600 NO_PRETTY_VALUES)
endfunction()

# dmp_test(NAME library...) or dmp_test(NAME [LIBRARIES library...] [what dmp_test_program takes]): a test program from
# NAME.cpp alone.
function(dmp_test name)
  cmake_parse_arguments(TEST "" "LABEL;TIMEOUT" "LIBRARIES;PROPERTIES" ${ARGN})
  dmp_test_program(${name} SOURCES ${name}.cpp LABEL "${TEST_LABEL}" TIMEOUT "${TEST_TIMEOUT}"
                   LIBRARIES ${TEST_LIBRARIES} ${TEST_UNPARSED_ARGUMENTS} PROPERTIES ${TEST_PROPERTIES})
endfunction()

# dmp_mpi_test(NAME RANKS 1 2 ... LIBRARIES library...): one GoogleTest program from NAME.cpp and mpi_main.cpp in the
# current folder, run once under mpirun for each number of ranks.
function(dmp_mpi_test name)
  cmake_parse_arguments(TEST "" "TIMEOUT" "RANKS;LIBRARIES" ${ARGN})
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 600)
  endif()
  if(DMP_SANITIZE)
    math(EXPR TEST_TIMEOUT "5 * ${TEST_TIMEOUT}")
  endif()
  if(NOT TARGET dmp_mpi_main)
    add_library(dmp_mpi_main OBJECT mpi_main.cpp)
    target_link_libraries(dmp_mpi_main PRIVATE dmp_rules GTest::gtest MPI::MPI_C OpenMP::OpenMP_CXX)
    target_compile_options(dmp_mpi_main PRIVATE ${dmp_test_options})
    target_include_directories(dmp_mpi_main PRIVATE ${PROJECT_SOURCE_DIR})
    dmp_use_test_headers(dmp_mpi_main)
  endif()
  add_executable(test_${name} ${name}.cpp $<TARGET_OBJECTS:dmp_mpi_main>)
  target_link_libraries(test_${name} PRIVATE dmp_rules GTest::gtest GTest::gmock MPI::MPI_C OpenMP::OpenMP_CXX
                                             ${TEST_LIBRARIES})
  target_compile_options(test_${name} PRIVATE ${dmp_test_options})
  dmp_use_test_headers(test_${name})
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  # Open MPI in a container: as root, more ranks than processors, none bound to one, waiting without keeping others from
  # working, and no copying from another process's memory, which containers forbid.
  set(environment OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
                  OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_mpi_yield_when_idle=1 OMPI_MCA_btl=self,vader
                  OMPI_MCA_btl_vader_single_copy_mechanism=none OMP_NUM_THREADS=1 OMP_WAIT_POLICY=passive
                  HWLOC_COMPONENTS=-gl)
  foreach(ranks ${TEST_RANKS})
    set(test ${name}.${ranks}_ranks)
    add_test(NAME ${test} COMMAND ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} ${ranks} $<TARGET_FILE:test_${name}>)
    # One at a time: two of Open MPI's runs that make their common folder at the same moment fail.
    set_tests_properties(${test} PROPERTIES PROCESSORS ${ranks} TIMEOUT ${TEST_TIMEOUT} RESOURCE_LOCK mpirun
                                            ENVIRONMENT "${environment}")
  endforeach()
endfunction()

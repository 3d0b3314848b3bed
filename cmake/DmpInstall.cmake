# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
# `cmake --install build --prefix DIR`: the dmp command, the modules as libraries with their headers, and what
# find_package(dmp) needs. A project that uses them is to enable C and C++ (VTK's own packages ask for C).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/dmp)
if(DMP_CLUSTER)
  install(TARGETS dmp_for_clusters RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
else()
  install(TARGETS dmp RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
foreach(module base models scene study geometry particles mesher solver tables report postproc)
  if(TARGET dmp_${module})
    install(TARGETS dmp_${module} EXPORT dmpTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  endif()
  if(EXISTS ${PROJECT_SOURCE_DIR}/${module})
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${module} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/dmp
            FILES_MATCHING PATTERN *.hpp)
  endif()
endforeach()
install(EXPORT dmpTargets NAMESPACE dmp:: DESTINATION ${config_dir})

# The VTK components that postproc links with; all of VTK would ask for Qt.
set(vtk_components "")
if(TARGET dmp_postproc)
  get_target_property(vtk_components dmp_postproc LINK_LIBRARIES)
  list(FILTER vtk_components INCLUDE REGEX "^VTK::")
  list(TRANSFORM vtk_components REPLACE "^VTK::" "")
  list(JOIN vtk_components " " vtk_components)
endif()
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/dmpConfig.cmake.in ${PROJECT_BINARY_DIR}/dmpConfig.cmake
                              INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/dmpConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/dmpConfig.cmake ${PROJECT_BINARY_DIR}/dmpConfigVersion.cmake
        DESTINATION ${config_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
# Part of the program, which writes it into pages.
install(FILES ${PROJECT_SOURCE_DIR}/third_party/uplot/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME LICENSE.uPlot)
install(FILES ${PROJECT_SOURCE_DIR}/third_party/three/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME LICENSE.three)

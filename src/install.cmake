# What `cmake --install` puts where: libraries, headers, the CMake package, the pkg-config file.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(SELVAGE_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/selvage)

set(SELVAGE_PLACES
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
set(libraries selvage_static_alone)
if(TARGET selvage)
  list(PREPEND libraries selvage)
endif()
install(TARGETS ${libraries} EXPORT selvageTargets ${SELVAGE_PLACES})
# Apart, for its users need oneTBB and the others do not.
if(SELVAGE_THREADS)
  install(TARGETS selvage_static EXPORT selvageThreadsTargets ${SELVAGE_PLACES})
  install(EXPORT selvageThreadsTargets NAMESPACE selvage:: DESTINATION ${SELVAGE_PACKAGE_DIR})
endif()
# A component by themselves: a library that is to be judged needs no more.
install(FILES selvage.h selvage.hpp selvage_subject.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  COMPONENT headers)
install(DIRECTORY selvage DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT headers
  FILES_MATCHING PATTERN *.h)

write_basic_package_version_file(selvageConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(EXPORT selvageTargets NAMESPACE selvage:: DESTINATION ${SELVAGE_PACKAGE_DIR})
install(FILES selvageConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/selvageConfigVersion.cmake
  DESTINATION ${SELVAGE_PACKAGE_DIR})

# The prefix is found from the place of the file, so that an installed tree can be moved.
file(RELATIVE_PATH SELVAGE_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" SELVAGE_PC_PREFIX "${SELVAGE_PC_PREFIX}")
configure_file(selvage.pc.in selvage.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/selvage.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

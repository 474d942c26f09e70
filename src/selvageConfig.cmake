# find_package(selvage) provides
#   selvage::selvage  the shared library
#   selvage::static   the static library
include("${CMAKE_CURRENT_LIST_DIR}/selvageTargets.cmake")

# A project in C alone is linked by the C compiler, which has to be told of the C++ runtime.
if(NOT CMAKE_CXX_COMPILER_LOADED)
  set_property(TARGET selvage::static APPEND PROPERTY INTERFACE_LINK_LIBRARIES stdc++)
endif()

# find_package(selvage) provides
#   selvage::selvage         the shared library; it finds oneTBB by itself if it was built with it.
#                            Where libraries cannot be shared, the static one
#   selvage::static          the static library, which needs nothing: selvage_draw_many draws on its
#                            caller's thread alone
#   selvage::static_threads  the static library over oneTBB: where it was built and TBB is found
find_package(TBB CONFIG QUIET)
include("${CMAKE_CURRENT_LIST_DIR}/selvageTargets.cmake")
if(NOT TARGET selvage::selvage)
  add_library(selvage::selvage ALIAS selvage::static)
endif()
if(TBB_FOUND)
  include("${CMAKE_CURRENT_LIST_DIR}/selvageThreadsTargets.cmake" OPTIONAL)
endif()

# A project in C alone is linked by the C compiler, which has to be told of what C++ brings along.
if(NOT CMAKE_CXX_COMPILER_LOADED)
  foreach(library selvage::static selvage::static_threads)
    if(TARGET ${library})
      set_property(TARGET ${library} APPEND PROPERTY INTERFACE_LINK_LIBRARIES stdc++ m)
    endif()
  endforeach()
endif()

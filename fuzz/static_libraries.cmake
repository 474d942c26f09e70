# For CMAKE_PROJECT_INCLUDE, after CMake's own defaults are set: prefer static libraries.
set(CMAKE_FIND_LIBRARY_SUFFIXES .a .so)

# Installs the build, moves the installed tree elsewhere, and uses it from outside: through CMake's
# find_package and through pkg-config, from C11 and from C++20; then the sources as a part of another
# project. Fails on the first step that does.
#   cmake -DBUILD=build -DWORK=/tmp/package -DC=cc -DCXX=c++ -P tests/package/check.cmake
cmake_minimum_required(VERSION 3.25)
foreach(variable IN ITEMS BUILD WORK C CXX)
  if(NOT ${variable})
    message(FATAL_ERROR "give -D${variable}=... (see the example at the top of this script)")
  endif()
endforeach()
set(consumer ${CMAKE_CURRENT_LIST_DIR}/consumer)
set(prefix ${WORK}/moved)

function(run)
  list(JOIN ARGN " " line)
  message(STATUS "${line}")
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed)
file(RENAME ${WORK}/installed ${prefix})

run(${CMAKE_COMMAND} -S ${consumer} -B ${WORK}/build -G Ninja -DCMAKE_C_COMPILER=${C}
    -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/with_selvage)
run(${WORK}/build/with_static)
# Configured only: to build it would take as long as all that was installed.
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/embedded -B ${WORK}/embedded -G Ninja
    -DCMAKE_C_COMPILER=${C} -DCMAKE_CXX_COMPILER=${CXX}
    -DSELVAGE=${CMAKE_CURRENT_LIST_DIR}/../..)
# Of a project that others install nothing of ours is, or all of it would have to be built.
run(${CMAKE_COMMAND} --install ${WORK}/embedded --prefix ${WORK}/installed_around)
file(GLOB_RECURSE installed_around ${WORK}/installed_around/*)
if(installed_around)
  message(FATAL_ERROR "a project around ours installs ${installed_around}")
endif()
# Where it was installed, and oneTBB with it.
file(GLOB_RECURSE threads_library ${prefix}/*/libselvage_threads.a)
if(threads_library)
  run(${WORK}/build/with_static_threads)
endif()

find_program(PKG_CONFIG pkg-config REQUIRED)
file(GLOB_RECURSE pc ${prefix}/*/selvage.pc)
cmake_path(GET pc PARENT_PATH pc_directory)
set(ENV{PKG_CONFIG_PATH} ${pc_directory})
execute_process(COMMAND ${PKG_CONFIG} --cflags --libs selvage
                OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PKG_CONFIG} --variable=libdir selvage
                OUTPUT_VARIABLE libdir OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PKG_CONFIG} --static --cflags --libs selvage
                OUTPUT_VARIABLE static_flags OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
separate_arguments(static_flags UNIX_COMMAND "${static_flags}")
run(${C} -std=c11 ${consumer}/example.c ${flags} -Wl,-rpath,${libdir} -o ${WORK}/example)
execute_process(COMMAND ${WORK}/example WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
file(SIZE ${WORK}/triangle.ppm bytes)
if(NOT bytes EQUAL 196623)  # "P6 256 256 255\n" and the pixels
  message(FATAL_ERROR "the example's picture has ${bytes} bytes")
endif()
set(ENV{LD_LIBRARY_PATH} ${libdir})
run(${C} -std=c11 ${consumer}/main.c ${flags} -o ${WORK}/by_pkg_config)
run(${WORK}/by_pkg_config)
run(${CXX} -std=c++20 ${consumer}/main.cpp ${flags} -o ${WORK}/by_pkg_config_cpp)
run(${WORK}/by_pkg_config_cpp)
run(${C} -std=c11 -static ${consumer}/main.c ${static_flags} -o ${WORK}/by_pkg_config_static)
run(${WORK}/by_pkg_config_static)

# Lists the suites of a GoogleTest program as tests of ctest, one process for all tests of a suite: a
# process for each test takes a fifth of the time of all. Run when the program has been linked, with
# program, prefix, folder, list and emulator.
execute_process(COMMAND ${emulator} ${program} --gtest_list_tests
  WORKING_DIRECTORY ${folder} OUTPUT_VARIABLE told RESULT_VARIABLE status TIMEOUT 60)
if(NOT status EQUAL 0)
  file(REMOVE ${program})  # so that the next build asks it again
  message(FATAL_ERROR "${program} --gtest_list_tests: status ${status}\n${told}")
endif()

# How a run ends in which nothing failed and nothing was run.
set(all_skipped "PASSED  . 0 tests[.]\n(.  SKIPPED . [^\n]*\n)+$")
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+[.]" suites "${told}")
if(NOT suites)
  file(REMOVE ${program})
  message(FATAL_ERROR "${program} --gtest_list_tests names no suite:\n${told}")
endif()
set(tests "")
foreach(suite IN LISTS suites)
  string(REGEX REPLACE "[\n.]" "" suite "${suite}")
  set(name "[==[${prefix}.${suite}]==]")
  string(APPEND tests
    "add_test(${name} ${emulator} [==[${program}]==] [==[--gtest_filter=${suite}.*]==])\n"
    "set_tests_properties(${name} PROPERTIES TIMEOUT 900 WORKING_DIRECTORY [==[${folder}]==]\n"
    "  SKIP_REGULAR_EXPRESSION [==[${all_skipped}]==])\n")
endforeach()
file(WRITE ${list} "${tests}")

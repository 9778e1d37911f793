# cmake/Testing.cmake: how a test program is made and labelled.

# teamsight_test(<name> LABEL unit SOURCES a_test.cpp ... LINK targets... [TIMEOUT seconds] [SERIAL])
# makes the program <name>, one CTest case per GoogleTest case, all with the label.
# The environment of every case: TEAMSIGHT_SOURCE_DIR (the repository) and TEAMSIGHT_BIN_DIR (the programs).
# The targets tests_<label> and tests_in_<folder> build the tests of one label and of one folder.
# SERIAL: never beside another test (timing, or all the processors).
function(teamsight_test name)
  cmake_parse_arguments(ARG "SERIAL" "LABEL;TIMEOUT" "SOURCES;LINK" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 60)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} GTest::gmock GTest::gtest_main teamsight_warnings)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  gtest_discover_tests(${name}
    DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT}
               # One property each: gtest_discover_tests takes the second entry of a list for a property's name.
               ENVIRONMENT TEAMSIGHT_SOURCE_DIR=${PROJECT_SOURCE_DIR}
               ENVIRONMENT_MODIFICATION TEAMSIGHT_BIN_DIR=set:${CMAKE_RUNTIME_OUTPUT_DIRECTORY}
               $<$<BOOL:${ARG_SERIAL}>:RUN_SERIAL> $<$<BOOL:${ARG_SERIAL}>:TRUE>)
  teamsight_test_group(tests_${ARG_LABEL} ${name})
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  teamsight_test_group(tests_in_${folder} ${name})
  if(NOT ARG_LABEL MATCHES "^(unit|property|consistency|fuzz)$")
    add_dependencies(tests_${ARG_LABEL} programs) # the other labels may start them
  endif()
endfunction()

# teamsight_test_group(<group> <test>) makes the target <group> build <test> as well.
function(teamsight_test_group group test)
  if(NOT TARGET ${group})
    add_custom_target(${group})
  endif()
  add_dependencies(${group} ${test})
endfunction()

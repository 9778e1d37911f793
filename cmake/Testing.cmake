# cmake/Testing.cmake: how a test program is made and labelled.

# teamsight_test(<name> LABEL unit SOURCES a_test.cpp ... LINK targets... [TIMEOUT seconds] [SERIAL])
# makes the program <name>, one CTest case per GoogleTest case, all with the label.
# The environment of every case: TEAMSIGHT_SOURCE_DIR (the repository) and TEAMSIGHT_BIN_DIR (the programs).
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
  set(environment "TEAMSIGHT_SOURCE_DIR=${PROJECT_SOURCE_DIR}" "TEAMSIGHT_BIN_DIR=${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
  gtest_discover_tests(${name}
    DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT} ENVIRONMENT "${environment}"
               $<$<BOOL:${ARG_SERIAL}>:RUN_SERIAL> $<$<BOOL:${ARG_SERIAL}>:TRUE>)
endfunction()

# cmake/Targets.cmake: the two ways this project makes a target.

# teamsight_library(<name> SOURCES a.cpp ... [PUBLIC targets...] [PRIVATE targets...])
# makes teamsight_<name> with the alias teamsight::<name>; headers are included from the repository root.
function(teamsight_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(teamsight_${name} STATIC ${ARG_SOURCES})
  add_library(teamsight::${name} ALIAS teamsight_${name})
  target_compile_features(teamsight_${name} PUBLIC cxx_std_20)
  target_include_directories(teamsight_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_link_libraries(teamsight_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:teamsight_warnings>)
  set_target_properties(teamsight_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON EXPORT_NAME ${name})
endfunction()

# The target `programs` builds every program, and no test.
add_custom_target(programs)

# teamsight_program(<name> SOURCES main.cpp ... [LINK targets...]) makes an executable called <name>.
function(teamsight_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} teamsight_warnings)
  add_dependencies(programs ${name})
endfunction()

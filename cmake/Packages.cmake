# cmake/Packages.cmake: the Debian packages. `cpack --config build/release/CPackConfig.cmake` makes them; see deploy/README.md.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME teamsight)
set(CPACK_PACKAGE_VENDOR "The Teamsight authors")
set(TEAMSIGHT_CONTACT "The Teamsight authors <teamsight@example.org>" CACHE STRING "who maintains the packages that you build")
set(CPACK_PACKAGE_CONTACT ${TEAMSIGHT_CONTACT})
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL robot coach tools client config)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_ROBOT_PACKAGE_NAME teamsight-robot)
set(CPACK_DEBIAN_ROBOT_DESCRIPTION "team world model on a robot: vision agent and fusion
The vision agent turns an omni-directional camera into posture, ball and
obstacles; the fusion merges what all robots of the team see into one model.")
set(CPACK_DEBIAN_ROBOT_PACKAGE_DEPENDS "adduser, teamsight-config (= ${PROJECT_VERSION})")

set(CPACK_DEBIAN_COACH_PACKAGE_NAME teamsight-coach)
set(CPACK_DEBIAN_COACH_DESCRIPTION "team world model on the coach's computer: station with its page
Shows in a browser what the team sees, who saw what, and what was rejected
and why.")
set(CPACK_DEBIAN_COACH_PACKAGE_DEPENDS "adduser, teamsight-config (= ${PROJECT_VERSION})")

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME teamsight-tools)
set(CPACK_DEBIAN_TOOLS_DESCRIPTION "team world model: the command teamsight, and the simulator
Calibration, the doctor, keys, recordings, and a simulated match.")
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "openssl, teamsight-config (= ${PROJECT_VERSION})")

set(CPACK_DEBIAN_CLIENT_PACKAGE_NAME libteamsight-dev)
set(CPACK_DEBIAN_CLIENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_CLIENT_DESCRIPTION "team world model: the library that a behaviour program links
The freshest world model in one call. For CMake: find_package(teamsight).")
set(CPACK_DEBIAN_CLIENT_PACKAGE_DEPENDS
  "cyclonedds-dev, libeigen3-dev, libexpected-dev, libprotobuf-dev, libcli11-dev, libfmt-dev, libboost-dev")

set(CPACK_DEBIAN_CONFIG_PACKAGE_NAME teamsight-config)
set(CPACK_DEBIAN_CONFIG_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_CONFIG_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_CONFIG_DESCRIPTION "team world model: fields, cameras, robots, teams, network profiles
What the programs read, under /etc/teamsight.")

# Configuration: everything under config/, as conffiles, so that an upgrade keeps what a team has changed.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/config/ DESTINATION /etc/teamsight COMPONENT config)
file(GLOB_RECURSE config_files RELATIVE ${PROJECT_SOURCE_DIR}/config CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/config/*)
list(TRANSFORM config_files PREPEND /etc/teamsight/)
list(JOIN config_files "\n" conffiles)
file(WRITE ${PROJECT_BINARY_DIR}/debian/conffiles "${conffiles}\n")
set(CPACK_DEBIAN_CONFIG_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/conffiles)

# Units, and the user that they run as.
set(units ${PROJECT_SOURCE_DIR}/deploy/systemd)
install(FILES ${units}/teamsight-agent@.service ${units}/teamsight-fusion@.service
  DESTINATION /lib/systemd/system COMPONENT robot)
install(FILES ${units}/teamsight-monitor@.service DESTINATION /lib/systemd/system COMPONENT coach)
install(FILES ${units}/realtime.conf DESTINATION share/doc/teamsight-robot COMPONENT robot)
set(scripts ${PROJECT_SOURCE_DIR}/deploy/debian/postinst ${PROJECT_SOURCE_DIR}/deploy/debian/postrm)
set(CPACK_DEBIAN_ROBOT_PACKAGE_CONTROL_EXTRA ${scripts})
set(CPACK_DEBIAN_ROBOT_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COACH_PACKAGE_CONTROL_EXTRA ${scripts})
set(CPACK_DEBIAN_COACH_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# What Debian wants in every package: the licence, and what has changed.
set(changelog ${PROJECT_BINARY_DIR}/debian/changelog.gz)
file(WRITE ${PROJECT_BINARY_DIR}/debian/changelog
  "teamsight (${PROJECT_VERSION}) bookworm; urgency=medium\n\n  * Release; see CHANGELOG.md of the source for what has changed.\n\n -- ${CPACK_PACKAGE_CONTACT}  Thu, 01 Jan 2026 00:00:00 +0000\n")
find_program(GZIP gzip REQUIRED)
execute_process(COMMAND ${GZIP} -9nkf ${PROJECT_BINARY_DIR}/debian/changelog COMMAND_ERROR_IS_FATAL ANY)
foreach(component robot coach tools client config)
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  install(FILES ${PROJECT_SOURCE_DIR}/deploy/debian/copyright DESTINATION share/doc/${package} COMPONENT ${component})
  install(FILES ${changelog} DESTINATION share/doc/${package} COMPONENT ${component})
endforeach()
foreach(component robot coach)
  install(FILES ${PROJECT_SOURCE_DIR}/docs/playing.md RENAME README.md
    DESTINATION share/doc/teamsight-${component} COMPONENT ${component})
endforeach()

include(CPack)

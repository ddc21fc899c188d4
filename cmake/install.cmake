# What `cmake --install` leaves: libraries, headers, programs, the CMake package, and what roslaunch needs.
# Included by the top CMakeLists.txt when all targets are known.
include(CMakePackageConfigHelpers)

# Without catkin the same folders have to be named, and two files are made by the configuration.
#catkin_lint: ignore immutable_var
if(NOT STILLMAP_WITH_ROS)
  set(CATKIN_PACKAGE_LIB_DESTINATION lib)
  set(CATKIN_PACKAGE_BIN_DESTINATION lib/stillmap)
  set(CATKIN_GLOBAL_BIN_DESTINATION bin)
  set(CATKIN_PACKAGE_INCLUDE_DESTINATION include/stillmap)
  set(CATKIN_PACKAGE_SHARE_DESTINATION share/stillmap)
endif()
set(cmake_package ${CATKIN_PACKAGE_SHARE_DESTINATION}/cmake)

# The method as a library: find_package(stillmap), target stillmap::core.
install(DIRECTORY include/stillmap/ DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION} FILES_MATCHING PATTERN *.hpp)
install(TARGETS stillmap_core EXPORT stillmapTargets
  ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
install(EXPORT stillmapTargets NAMESPACE stillmap:: DESTINATION ${cmake_package})

# The command line, by its bare name too.
if(STILLMAP_BUILD_TOOLS)
  install(TARGETS stillmap RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/link)
  file(CREATE_LINK ../${CATKIN_PACKAGE_BIN_DESTINATION}/stillmap ${CMAKE_BINARY_DIR}/link/stillmap SYMBOLIC)
  #catkin_lint: ignore_once missing_file
  install(FILES ${CMAKE_BINARY_DIR}/link/stillmap DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION})
  install(PROGRAMS scripts/plot_report.py DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
endif()
install(DIRECTORY config DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
install(FILES LICENSE CHANGELOG.rst DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})

if(NOT STILLMAP_WITH_ROS)
  file(TOUCH ${CMAKE_BINARY_DIR}/CATKIN_IGNORE)  # as catkin does: nothing in a build folder is a package
  install(FILES cmake/stillmap-extras.cmake DESTINATION ${cmake_package} RENAME stillmapConfig.cmake)
  write_basic_package_version_file(${CMAKE_BINARY_DIR}/stillmapConfig-version.cmake COMPATIBILITY SameMinorVersion)
  #catkin_lint: ignore_once missing_file
  install(FILES ${CMAKE_BINARY_DIR}/stillmapConfig-version.cmake DESTINATION ${cmake_package})
  return()
endif()

export(EXPORT stillmapTargets NAMESPACE stillmap:: FILE ${CATKIN_DEVEL_PREFIX}/${cmake_package}/stillmapTargets.cmake)
install(TARGETS stillmap_node RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(TARGETS stillmap_bags stillmap_baselines stillmap_doctor stillmap_evaluation stillmap_io stillmap_maps stillmap_messages
    stillmap_node_parameters stillmap_nodelet stillmap_ros stillmap_simulation
  ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
install(DIRECTORY launch rviz DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
install(FILES nodelet_plugins.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
catkin_install_python(PROGRAMS
    scripts/draw_stages.py scripts/moving_picture.py scripts/play_simulation.py scripts/render.py scripts/replay_bag.py
  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(PROGRAMS scripts/rviz_picture.sh DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(FILES scripts/labelled_sequence.py scripts/point_picture.py DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})

# Gives a package that says find_package(stillmap) the target stillmap::core: the method of include/stillmap, no ROS.
# Without ROS this file itself is installed as stillmapConfig.cmake.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
find_dependency(TBB)
include("${CMAKE_CURRENT_LIST_DIR}/stillmapTargets.cmake")

# The Debian package of what is installed; scripts/package.sh makes it. Included by the top CMakeLists.txt at its end.
# Version and description are those of package.xml.
file(STRINGS package.xml description REGEX "<description>")
string(REGEX REPLACE ".*<description>(.*)</description>.*" "\\1" description "${description}")
file(STRINGS package.xml maintainer REGEX "<maintainer")
string(REGEX REPLACE ".*email=\"(.*)\">(.*)</maintainer>.*" "\\2 <\\1>" maintainer "${maintainer}")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "${maintainer}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "LiDAR scans without the things that move (ROS 1 nodelet)")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "${description}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# Libraries are found by dpkg-shlibdeps; these are the programs that the launch files and scripts start.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CATKIN_DEVEL_PREFIX}/lib)
set(CPACK_DEBIAN_PACKAGE_DEPENDS
  "libnodeletlib-tools, python3-nav-msgs, python3-rosbag, python3-roslaunch, python3-rospy, python3-sensor-msgs, python3-std-srvs, rosout")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "rviz, python3-matplotlib, python3-numpy")
# To build against stillmap::core.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "catkin, libeigen3-dev, libtbb-dev, robin-map-dev")
set(CPACK_SOURCE_GENERATOR "")
include(CPack)

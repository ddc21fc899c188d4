# Run at every build (cmake -P): writes VERSION_FILE when the version or the git revision has changed.
execute_process(
  COMMAND git --no-optional-locks describe --always --dirty --abbrev=12 --exclude *
  WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE GIT_REVISION OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT GIT_REVISION)
  set(GIT_REVISION "no git revision")
endif()
configure_file(${TEMPLATE} ${VERSION_FILE} @ONLY)

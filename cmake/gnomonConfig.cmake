# find_package(gnomon) gives the target gnomon::gnomon; the library needs nothing else to be found.
include("${CMAKE_CURRENT_LIST_DIR}/gnomonTargets.cmake")

# The installed tree: bin/verisim, the libraries with their headers, and a CMake package:
#
#   find_package(verisim REQUIRED)
#   target_link_libraries(my_program PRIVATE verisim::tracer)   # or verisim::parser, verisim::compare
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

foreach(library IN ITEMS tracer parser compare)
  add_library(verisim::${library} ALIAS verisim_${library})
  set_target_properties(verisim_${library} PROPERTIES EXPORT_NAME ${library})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${library} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/verisim FILES_MATCHING PATTERN "*.h")
endforeach()

install(TARGETS verisim_tracer verisim_parser verisim_compare EXPORT verisimTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS verisim RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(PROGRAMS ${PROJECT_SOURCE_DIR}/share/verisim/slurm/verisim-slurm DESTINATION ${CMAKE_INSTALL_DATADIR}/verisim/slurm)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/verisim)
install(EXPORT verisimTargets NAMESPACE verisim:: DESTINATION ${package_folder})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/verisimConfig.cmake.in ${PROJECT_BINARY_DIR}/verisimConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/verisimConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/verisimConfig.cmake ${PROJECT_BINARY_DIR}/verisimConfigVersion.cmake
        ${CMAKE_CURRENT_LIST_DIR}/FindISAL.cmake DESTINATION ${package_folder})

# A small project is built against an installed tree, as others would.
if(VERISIM_TESTS AND NOT VERISIM_SANITIZE)
  add_test(NAME install.consumer
           COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -DCONSUMER=${PROJECT_SOURCE_DIR}/tests/install -DWORK=${PROJECT_BINARY_DIR}/install_test
                   -DGENERATOR=${CMAKE_GENERATOR} -DCOMPILER=${CMAKE_CXX_COMPILER} -P ${PROJECT_SOURCE_DIR}/tests/install/run.cmake)
  set_tests_properties(install.consumer PROPERTIES LABELS slow TIMEOUT 600)
endif()

# The installed tree, by components: `runtime` (bin/verisim and the image plug-ins), `dev` (static libraries, public headers, CMake package,
# pkg-config), `python` (the module). From CMake (docs/embedding.md):
#
#   find_package(verisim REQUIRED)
#   target_link_libraries(my_program PRIVATE verisim::parser)   # or verisim::tracer, verisim::compare
include(CMakePackageConfigHelpers)

# verisim_public_headers(OUT HEADER...): the headers, relative to the project, that these include, all the way down.
function(verisim_public_headers out)
  set(queue ${ARGN})
  set(known ${ARGN})
  while(queue)
    list(POP_FRONT queue header)
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} lines REGEX "^#include \"(tracer|parser|compare)/")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included "${line}")
      if(NOT included IN_LIST known)
        list(APPEND known ${included})
        list(APPEND queue ${included})
      endif()
    endforeach()
  endwhile()
  set(${out} ${known} PARENT_SCOPE)
endfunction()

verisim_public_headers(public_headers include/verisim/tracer.h include/verisim/parser.h include/verisim/compare.h)
foreach(header IN LISTS public_headers)
  if(header MATCHES "^include/verisim/")
    set(folder ${CMAKE_INSTALL_INCLUDEDIR}/verisim)
  else()
    get_filename_component(folder ${CMAKE_INSTALL_INCLUDEDIR}/verisim/${header} DIRECTORY)
  endif()
  install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${folder} COMPONENT dev)
endforeach()

set(link_tracer "-lverisim_tracer -lgif -ldl -pthread")
set(link_parser "-lverisim_parser")
set(link_compare "-lverisim_compare")
set(needs_tracer "Imath, fmt, tbb, libpng, zlib, libdeflate, libjpeg")
set(needs_parser "verisim-tracer, fmt")
set(needs_compare "verisim-parser, verisim-tracer, fmt, tbb, libcrypto")
foreach(library IN ITEMS tracer parser compare)
  add_library(verisim::${library} ALIAS verisim_${library})
  set_target_properties(verisim_${library} PROPERTIES EXPORT_NAME ${library})
  set(VERISIM_PC_NAME ${library})
  set(VERISIM_PC_LINK ${link_${library}})
  set(VERISIM_PC_NEEDS ${needs_${library}})
  file(RELATIVE_PATH VERISIM_PC_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  configure_file(${CMAKE_CURRENT_LIST_DIR}/verisim.pc.in ${PROJECT_BINARY_DIR}/verisim-${library}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/verisim-${library}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)
endforeach()

install(TARGETS verisim_tracer verisim_parser verisim_compare EXPORT verisimTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
install(TARGETS verisim RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/share/verisim/openjd DESTINATION ${CMAKE_INSTALL_DATADIR}/verisim COMPONENT runtime)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/verisim)
install(EXPORT verisimTargets NAMESPACE verisim:: DESTINATION ${package_folder} COMPONENT dev)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/verisimConfig.cmake.in ${PROJECT_BINARY_DIR}/verisimConfig.cmake
                              INSTALL_DESTINATION ${package_folder} PATH_VARS CMAKE_INSTALL_LIBDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/verisimConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/verisimConfig.cmake ${PROJECT_BINARY_DIR}/verisimConfigVersion.cmake ${CMAKE_CURRENT_LIST_DIR}/FindDeflate.cmake
        DESTINATION ${package_folder} COMPONENT dev)

# A small project is built against an installed tree, as others would.
if(VERISIM_TESTS AND NOT VERISIM_SANITIZE)
  add_test(NAME install.consumer
           COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -DCONSUMER=${PROJECT_SOURCE_DIR}/tests/install -DWORK=${PROJECT_BINARY_DIR}/install_test
                   -DGENERATOR=${CMAKE_GENERATOR} -DDOCUMENT=${PROJECT_SOURCE_DIR}/docs/embedding.md
                   -DCOMPILER=${CMAKE_CXX_COMPILER} -P ${PROJECT_SOURCE_DIR}/tests/install/run.cmake)
  set_tests_properties(install.consumer PROPERTIES LABELS slow TIMEOUT 600)
endif()

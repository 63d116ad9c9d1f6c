# Man pages and the completion of bash, made by the program from the tables behind its --help.
set(manual_folder ${PROJECT_BINARY_DIR}/manual)
add_custom_command(OUTPUT ${manual_folder}/verisim.1
                   COMMAND ${CMAKE_COMMAND} -E rm -rf ${manual_folder}
                   COMMAND verisim help --pages ${manual_folder}
                   DEPENDS verisim)
add_custom_target(manual ALL DEPENDS ${manual_folder}/verisim.1)
install(DIRECTORY ${manual_folder}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT runtime FILES_MATCHING PATTERN "*.1")
install(FILES ${manual_folder}/verisim.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT runtime RENAME verisim)
# What README links to, where it looks for it.
install(FILES ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md ${PROJECT_SOURCE_DIR}/Containerfile
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(FILES ${PROJECT_SOURCE_DIR}/SECURITY.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(FILES ${PROJECT_SOURCE_DIR}/compare/report/report.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/verisim COMPONENT runtime)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
# The scenes that the lecture's pages show.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes/lecture ${PROJECT_SOURCE_DIR}/scenes/cornell_box
        DESTINATION ${CMAKE_INSTALL_DOCDIR}/scenes COMPONENT runtime)

# What the program is made of (SPDX 2.3).
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(bill_of_materials ${PROJECT_BINARY_DIR}/verisim.spdx.json)
add_custom_command(OUTPUT ${bill_of_materials}
                   COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/tools/sbom/make.py ${PROJECT_SOURCE_DIR} ${PROJECT_VERSION} ${bill_of_materials}
                   DEPENDS ${PROJECT_SOURCE_DIR}/tools/sbom/make.py ${PROJECT_SOURCE_DIR}/tools/sbom/components.tsv)
add_custom_target(sbom ALL DEPENDS ${bill_of_materials})
install(FILES ${bill_of_materials} DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)

# All that is installed, and no tests.
add_custom_target(package_files)
add_dependencies(package_files verisim verisim_image_module verisim_tracer verisim_parser verisim_compare manual sbom)
if(TARGET verisim_python)
  add_dependencies(package_files verisim_python)
endif()

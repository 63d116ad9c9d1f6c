# Man pages and the completion of bash, made by the program from the tables behind its --help.
set(manual_folder ${PROJECT_BINARY_DIR}/manual)
set(pages "")
foreach(command IN ITEMS "" render merge check compare explain diff bench)
  set(page verisim)
  if(command)
    string(APPEND page -${command})
  endif()
  add_custom_command(OUTPUT ${manual_folder}/${page}.1
                     COMMAND ${CMAKE_COMMAND} -E make_directory ${manual_folder}
                     COMMAND verisim help ${command} --format man > ${manual_folder}/${page}.1
                     DEPENDS verisim)
  list(APPEND pages ${manual_folder}/${page}.1)
endforeach()
add_custom_command(OUTPUT ${manual_folder}/verisim.bash
                   COMMAND ${CMAKE_COMMAND} -E make_directory ${manual_folder}
                   COMMAND verisim help --format bash > ${manual_folder}/verisim.bash
                   DEPENDS verisim)
add_custom_target(manual ALL DEPENDS ${pages} ${manual_folder}/verisim.bash)
install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${manual_folder}/verisim.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME verisim)
install(FILES ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR})

# All that is installed, and no tests.
add_custom_target(package_files)
add_dependencies(package_files verisim verisim_image_module verisim_tracer verisim_parser verisim_compare manual)

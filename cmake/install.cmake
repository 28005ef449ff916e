# What `cmake --install` puts where: the program, the libraries with their headers, the models, and the files that let
# another project say find_package(secular). Headers keep their folders, so that generated code includes
# "estimator/model/compiled_model.hpp" in the tree and installed alike.
set(secular_libraries secular_effects secular_input secular_dense secular_numerics secular_report secular_perturb secular_generated
  secular_codegen_canonical secular_codegen_expression secular_codegen_cpp secular_codegen_document
  secular_codegen_runtime secular_measure_formats secular_measure_data secular_measure_signal
  secular_measure_disturbances secular_measure_modal secular_measure_observe
  secular_estimator_model secular_estimator_regression secular_estimator_identification secular_estimator_planning
  secular_motion_response secular_motion_balance secular_motion_integrate secular_motion_simulate
  secular_motion_correction
  secular_thesis_verify secular_thesis_procedures)

# Several folders by one name, for who does not want to choose among them.
function(secular_component name)
  add_library(secular_${name} INTERFACE)
  target_link_libraries(secular_${name} INTERFACE ${ARGN})
  set(secular_libraries ${secular_libraries} secular_${name} PARENT_SCOPE)
endfunction()
secular_component(codegen secular_codegen_canonical secular_codegen_expression secular_codegen_cpp
  secular_codegen_document secular_codegen_runtime)
secular_component(estimator secular_numerics secular_measure_formats secular_measure_data secular_measure_signal
  secular_measure_disturbances secular_measure_modal secular_measure_observe secular_estimator_model
  secular_estimator_regression secular_estimator_identification
  secular_estimator_planning secular_motion_response secular_thesis_procedures)
secular_component(simulate secular_motion_balance secular_motion_integrate secular_motion_simulate secular_motion_correction)
secular_component(verify secular_thesis_verify)

foreach(library IN LISTS secular_libraries)
  string(REPLACE "secular_" "" short_name ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${short_name})
  add_library(secular::${short_name} ALIAS ${library})
  target_compile_features(${library} INTERFACE cxx_std_20)
endforeach()

# Two packages (cpack): the program, and what another project builds with.
set(program COMPONENT program)
set(development COMPONENT development)

install(TARGETS ${secular_libraries} EXPORT secularTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} ${development}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/secular)
foreach(folder effects input numerics perturb codegen generated measure estimator motion thesis report)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/secular ${development}
    FILES_MATCHING PATTERN "*.hpp" PATTERN "estimator/model" EXCLUDE)
endforeach()
# The program compiles what it generates with these.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/estimator/model DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/secular/estimator
  ${program} FILES_MATCHING PATTERN "*.hpp")
if(TARGET secular)
  install(TARGETS secular EXPORT secularTargets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} ${program})
  if(NOT CMAKE_CROSSCOMPILING)
    # What the program says of itself, for `man` and for shells that complete command lines.
    install(CODE "
      set(share \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}\")
      set(manual \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1\")
      set(bash bash-completion/completions)
      set(zsh zsh/vendor-completions)
      set(fish fish/vendor_completions.d)
      set(bash_name secular)
      set(zsh_name _secular)
      set(fish_name secular.fish)
      foreach(shell bash zsh fish)
        file(MAKE_DIRECTORY \${share}/\${\${shell}})
        execute_process(COMMAND $<TARGET_FILE:secular> help --completion \${shell}
          OUTPUT_FILE \${share}/\${\${shell}}/\${\${shell}_name} COMMAND_ERROR_IS_FATAL ANY)
      endforeach()
      file(MAKE_DIRECTORY \${manual})
      execute_process(COMMAND $<TARGET_FILE:secular> help --manual
        OUTPUT_FILE \${manual}/secular.1 COMMAND_ERROR_IS_FATAL ANY)" ${program})
  endif()
endif()
# In no package: what it needs of MPI is the machine's own.
if(TARGET secular-mpi)
  install(TARGETS secular-mpi RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT mpi)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/models DESTINATION ${CMAKE_INSTALL_DATADIR}/secular ${program})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} ${program})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} ${program})

set(secular_config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/secular)
install(EXPORT secularTargets NAMESPACE secular:: DESTINATION ${secular_config_folder} ${development})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/secularConfig.cmake.in
  ${PROJECT_BINARY_DIR}/secularConfig.cmake INSTALL_DESTINATION ${secular_config_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/secularConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/secularConfig.cmake ${PROJECT_BINARY_DIR}/secularConfigVersion.cmake
  DESTINATION ${secular_config_folder} ${development})

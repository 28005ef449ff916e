# What `cmake --install` puts where: the program, the libraries with their headers, the models, and the files that let
# another project say find_package(secular). Headers keep their folders, so that generated code includes
# "estimator/compiled_model.hpp" in the tree and installed alike.
set(secular_libraries secular_input secular_dense secular_perturb secular_verify secular_codegen secular_estimator secular_generated
  secular_simulate secular_report)
foreach(library IN LISTS secular_libraries)
  string(REPLACE "secular_" "" short_name ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${short_name})
  add_library(secular::${short_name} ALIAS ${library})
  target_compile_features(${library} INTERFACE cxx_std_20)
endforeach()

install(TARGETS ${secular_libraries} EXPORT secularTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/secular)
foreach(folder input perturb verify codegen estimator generated simulate report)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/secular
    FILES_MATCHING PATTERN "*.hpp")
endforeach()
if(TARGET secular)
  install(TARGETS secular EXPORT secularTargets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/models DESTINATION ${CMAKE_INSTALL_DATADIR}/secular)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(secular_config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/secular)
install(EXPORT secularTargets NAMESPACE secular:: DESTINATION ${secular_config_folder})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/secularConfig.cmake.in
  ${PROJECT_BINARY_DIR}/secularConfig.cmake INSTALL_DESTINATION ${secular_config_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/secularConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/secularConfig.cmake ${PROJECT_BINARY_DIR}/secularConfigVersion.cmake
  DESTINATION ${secular_config_folder})

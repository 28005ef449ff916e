# `cpack` in a build folder makes Debian packages: secular (the program, its models and pages) and libsecular-dev (the
# libraries and headers for `find_package(secular)`), with -DSECULAR_BUILD_PYTHON=ON python3-secular as well.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME secular)
set(CPACK_PACKAGE_CONTACT "The developers of secular <secular@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Symbolic perturbation analysis that identifies and diagnoses nonlinear vibration tests")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME secular)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# Without a compiler models of one's own are interpreted, more slowly; gnuplot draws the figures of reports.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "g++, gnuplot-nox")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsecular-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
string(CONCAT CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "secular (= ${PROJECT_VERSION}), pkg-config, libginac-dev, "
  "libcln-dev, libeigen3-dev, libmatio-dev, libtomlplusplus-dev, nlohmann-json3-dev, libfmt-dev, libboost-dev")
if(SECULAR_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-secular)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  # Models and headers are the program's.
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "secular (= ${PROJECT_VERSION}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, python3-pandas, python3-sympy")
endif()
include(CPack)

# `cpack --preset package` makes Debian packages: secular (the program, its models and pages) and libsecular-dev (the
# libraries and headers for `find_package(secular)`), with -DSECULAR_BUILD_PYTHON=ON python3-secular as well.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME secular)
# Who answers for a package is who gives it to others: -DCPACK_PACKAGE_CONTACT="NAME <ADDRESS>".
if(NOT CPACK_PACKAGE_CONTACT)
  set(CPACK_PACKAGE_CONTACT "The developers of secular <secular@localhost>")
endif()
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian_files.cmake)

# The first line is the summary.
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "parameters of nonlinear vibration tests, and what a model lacks
From a structure's equations of motion secular derives what a vibration
measurement near a resonance must look like (second-order method of multiple
scales), compiles that into an estimator, gives the parameters with error bars,
and names the effect that the model leaves out.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME secular)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# Without a compiler models of one's own are interpreted, more slowly; gnuplot draws the figures of reports.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "g++, gnuplot-nox")

set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "libraries of secular, for programs of one's own
Static libraries and headers of secular: files of measurements, signals, modal
analysis, regression, response curves, and the derivation itself, for CMake's
find_package(secular).")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsecular-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
string(CONCAT CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "secular (= ${PROJECT_VERSION}), pkg-config, libginac-dev, "
  "libcln-dev, libeigen3-dev, libmatio-dev, libtomlplusplus-dev, nlohmann-json3-dev, libfmt-dev, libboost-dev")
if(SECULAR_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "secular from Python
Campaigns from NumPy arrays and measured files, derivations, estimates,
predictions and diagnoses as the program secular makes them, with their figures
in matplotlib.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-secular)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  # Models and headers are the program's; the module is compiled for one version of Python.
  math(EXPR python_after "${secular_python_minor} + 1")
  string(CONCAT CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "secular (= ${PROJECT_VERSION}), python3-numpy, "
    "python3 (>= 3.${secular_python_minor}), python3 (<< 3.${python_after})")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, python3-pandas, python3-sympy")
endif()
include(CPack)

# SPDX-License-Identifier: GPL-3.0-or-later
# The Debian packages: triax, the program with its man pages, completion and samples; python3-triax, the Python module where
# it is built. tools/package makes and tries them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME triax)
set(CPACK_PACKAGE_VENDOR "${TRIAX_MAINTAINER_NAME}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_COMPONENTS_GROUPING IGNORE)  # a package each
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${TRIAX_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Of each package: the first line is its summary.
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "triaxial tests on soil and the onset of collapse
triax reads records of triaxial tests on soil, simulates tests on a virtual
apparatus, stores every reading in SQLite and reports whether, when and at
what stress ratio a specimen became unstable, from the sign of its
second-order work.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME triax)
# Figures need a font; everything else that the program needs is found by dpkg-shlibdeps.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS fonts-dejavu-core)
if(TARGET triax_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-triax)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "triaxial tests and the onset of collapse, from Python (import triax)
The studies of triax as a Python module: tests of a database as numpy
arrays, replay, simulation, material points, probes, bifurcation domains,
constitutive laws on arrays.")
  get_target_property(interpreters triax_python TRIAX_INTERPRETERS)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${interpreters}, python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS triax)
endif()
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)

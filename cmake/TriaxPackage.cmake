# SPDX-License-Identifier: GPL-3.0-or-later
# The Debian package: the program, its man pages, completion and samples. tools/package makes and tries it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME triax)
set(CPACK_PACKAGE_VENDOR "The authors of triax")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "laboratory for triaxial tests and the onset of collapse")
set(CPACK_PACKAGE_DESCRIPTION
  "triax replays records of triaxial tests on soil, simulates tests on a virtual apparatus,
keeps every reading in SQLite and reports when, why and at what stress ratio a specimen
became unstable, by the sign of its second-order work.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The authors of triax <triax@localhost>")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Figures need a font; everything else that the program needs is found by dpkg-shlibdeps.
set(CPACK_DEBIAN_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)

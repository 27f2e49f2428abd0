# SPDX-License-Identifier: GPL-3.0-or-later
# The documents of a Debian package in the forms of Debian's policy: copyright, changelogs, compressed; and its maintainer.
# The maintainer's name and the day of the release come from CITATION.cff. The address is that of the person who builds a package for
# others, in DEBEMAIL, as for Debian's own tools. Without it, the address is one that cannot exist.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS CITATION.cff)
file(READ CITATION.cff citation)
string(REGEX MATCH "\nauthors:\n  - name: \"([^\"]+)\"" found "${citation}")
set(TRIAX_MAINTAINER_NAME "${CMAKE_MATCH_1}")
string(REGEX MATCH "\ndate-released: ([0-9-]+)" found "${citation}")
set(released ${CMAKE_MATCH_1})
set(address triax@users.noreply.invalid)
if(NOT "$ENV{DEBEMAIL}" STREQUAL "")
  set(address $ENV{DEBEMAIL})
endif()
set(TRIAX_MAINTAINER "${TRIAX_MAINTAINER_NAME} <${address}>")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C date --utc --rfc-email --date ${released}
  OUTPUT_VARIABLE TRIAX_RELEASE_TIME OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)

set(triax_documents ${CMAKE_BINARY_DIR}/documents)
configure_file(cmake/copyright ${triax_documents}/copyright @ONLY)
configure_file(cmake/changelog.Debian ${triax_documents}/changelog.Debian @ONLY)
configure_file(CHANGELOG.md ${triax_documents}/changelog COPYONLY)
execute_process(COMMAND gzip -9nkf ${triax_documents}/changelog.Debian ${triax_documents}/changelog COMMAND_ERROR_IS_FATAL ANY)

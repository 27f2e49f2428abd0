# SPDX-License-Identifier: GPL-3.0-or-later
# The page of `triax open`: src/page/web and uPlot, which npm fetches as package-lock.json pins it (version and checksum, no
# scripts), compiled into the program. Nothing of it is looked for when the program runs.
function(triax_embed_page target symbol)
  find_program(TRIAX_NPM npm)
  if(NOT TRIAX_NPM)
    message(FATAL_ERROR "No npm found. The page of `triax open` draws with uPlot, which npm fetches: tools/setup installs it.")
  endif()
  set(web ${PROJECT_SOURCE_DIR}/src/page/web)
  set(npm ${CMAKE_CURRENT_BINARY_DIR}/npm)
  set(uplot ${npm}/node_modules/uplot/dist/uPlot.esm.js ${npm}/node_modules/uplot/dist/uPlot.min.css)
  # npm keeps the time of the archive: without the touch the files would always be older than the lock file.
  add_custom_command(OUTPUT ${uplot}
    COMMAND ${CMAKE_COMMAND} -E copy ${web}/package.json ${web}/package-lock.json ${npm}/
    COMMAND ${TRIAX_NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
    COMMAND ${CMAKE_COMMAND} -E touch ${uplot}
    DEPENDS ${web}/package.json ${web}/package-lock.json
    WORKING_DIRECTORY ${npm} COMMENT "Fetching uPlot as src/page/web/package-lock.json pins it" VERBATIM)
  file(MAKE_DIRECTORY ${npm})
  file(GLOB_RECURSE files CONFIGURE_DEPENDS ${web}/*.html ${web}/*.css ${web}/*.js ${web}/*.svg)
  triax_embed(${target} ${symbol} WITH_ENDINGS ${files} ${uplot})
  # uPlot is one text of 145 KB; clang asks of C++ compilers no more than 64.
  set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/${symbol}.cpp PROPERTIES COMPILE_OPTIONS -Wno-overlength-strings)
endfunction()

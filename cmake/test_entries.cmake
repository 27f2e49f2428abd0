# SPDX-License-Identifier: GPL-3.0-or-later
# Read by ctest: an entry for each of the test `files` of `program`, named after the file. Catch2 gives every
# case the tag #FILE (option -#). What is tagged [slow] in a file is an entry of its own, labelled slow, and `only`
# a tag leaves out all other cases. Hidden cases, [.], run by hand only. An entry without a single case fails.
cmake_policy(VERSION 3.25)  # ctest starts with none
set(surroundings
  "LSAN_OPTIONS=suppressions=${root}/tests/leaks_of_others.txt:print_suppressions=0"
  "ASAN_SYMBOLIZER_PATH=/usr/bin/llvm-symbolizer-14"
  "TSAN_OPTIONS=suppressions=${root}/tests/races_of_others.txt:halt_on_error=1:external_symbolizer_path=/usr/bin/llvm-symbolizer-14")

macro(triax_entry entry filter seconds)
  add_test("${entry}" "${program}" -\# ${options} "${filter}")
  # Cases of one file may write to the same place: its two entries never run at once.
  set_tests_properties("${entry}" PROPERTIES WORKING_DIRECTORY "${root}" TIMEOUT ${seconds}
    RESOURCE_LOCK "${name}/${stem}" ENVIRONMENT "${surroundings}" ${ARGN})
endmacro()

set(stems)
foreach(file IN LISTS files)
  file(READ "${file}" text)
  # A case begins at the left margin.
  string(REGEX MATCHALL "\n(TEST_CASE|TEMPLATE_TEST_CASE)" cases "\n${text}")
  string(REGEX MATCHALL "\\[slow\\]" slow "${text}")
  string(REGEX MATCHALL "\\[of-others\\]" of_others "${text}")
  string(FIND "${text}" "${only}" found)
  list(LENGTH cases cases)
  list(LENGTH slow slow)
  list(LENGTH of_others of_others)
  if(cases EQUAL 0 OR found EQUAL -1)
    continue()
  endif()
  get_filename_component(stem "${file}" NAME_WLE)
  file(RELATIVE_PATH entry "${root}/tests" "${file}")
  string(REGEX REPLACE "\\.cpp$" "" entry "${entry}")
  if(stem IN_LIST stems)
    message(FATAL_ERROR "${file}: ${name} has another file of that name, their cases would run twice")
  endif()
  list(APPEND stems ${stem})

  if(only)
    triax_entry("${entry}" "${only}[#${stem}]~[.]" 1800)
    continue()
  endif()
  set(skipping)
  if(of_others EQUAL cases)  # records that are not ours: without them ctest says "Skipped"
    set(skipping SKIP_REGULAR_EXPRESSION "skipped: ")
  endif()
  if(slow LESS cases)
    triax_entry("${entry}" "[#${stem}]~[slow]~[.]" 600 ${skipping})
  endif()
  if(slow GREATER 0)
    triax_entry("${entry}/slow" "[#${stem}][slow]~[.]" 1800 LABELS slow COST 1000)
  endif()
endforeach()

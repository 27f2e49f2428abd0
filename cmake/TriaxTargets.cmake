# SPDX-License-Identifier: GPL-3.0-or-later
# Helpers shared by the folders: one function a kind of target, so that flags are said once.

add_library(triax_flags INTERFACE)
# -Wno-missing-field-initializers: designated initializers leave the other members at their defaults.
# -ffp-contract=off: a replay must give the same bits as the simulation that wrote the record,
# whichever optimisation level each was built with.
target_compile_options(triax_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wold-style-cast
  -Wno-missing-field-initializers -Wnon-virtual-dtor -Woverloaded-virtual -ffp-contract=off)
# -Wno-restrict, -Wno-stringop-overflow: g++ 12 warns of std::string's own operator+ and append once
# they are inlined (its bug 105329).
# -fno-semantic-interposition: Qt asks for -fPIC, with which g++ inlines no function that a library
# loaded later might replace; nobody does (clang never expects it). A replay gains a tenth.
target_compile_options(triax_flags INTERFACE
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
  $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
# g++ 13 and later take a reference that a function returns for one to its arguments' temporaries.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
  target_compile_options(triax_flags INTERFACE -Wno-dangling-reference)
endif()
target_include_directories(triax_flags INTERFACE ${PROJECT_SOURCE_DIR})
triax_harden(triax_flags)
if(TRIAX_SANITIZE)
  # -Wno-maybe-uninitialized: g++ 12 sees ghosts inside <regex> once it is instrumented.
  target_compile_options(triax_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
    -fsanitize=${TRIAX_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_compile_options(triax_flags INTERFACE
    $<$<CXX_COMPILER_ID:Clang>:-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/sanitizers_ignore.txt>)
  target_link_options(triax_flags INTERFACE -fsanitize=${TRIAX_SANITIZE})
endif()

# triax_fuzzed(TARGET [FLAG]): what is compiled of it tells the fuzzers where it has been, and what it compared unless FLAG
# asks for less.
function(triax_fuzzed target)
  if(TRIAX_FUZZ)
    set(flag -fsanitize=fuzzer-no-link)
    if(ARGC GREATER 1)
      set(flag ${ARGV1})
    endif()
    target_compile_options(${target} PRIVATE ${flag})
  endif()
endfunction()

# triax_precompile(TARGET HEADERS...): what most sources of a target include, parsed once. Only headers of
# others: ours change too often.
function(triax_precompile target)
  target_precompile_headers(${target} PRIVATE <algorithm> <cmath> <functional> <memory> <optional> <string> <variant>
    <vector> ${ARGN})
endfunction()

# triax_folders_as_units(TARGET): compiles the sources of a folder as one unit where TRIAX_FOLDERS_AS_UNITS says so. Most
# of a small source is what its headers hold. For this, names of anonymous namespaces are unique in a folder, in tests too,
# where what `using namespace` brings in holds for the next files as well.
option(TRIAX_FOLDERS_AS_UNITS "compile each folder as one unit: less to do in all, more after a change" OFF)
function(triax_folders_as_units target)
  if(NOT TRIAX_FOLDERS_AS_UNITS)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "^${PROJECT_SOURCE_DIR}/.*\\.cpp$")
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
    string(REPLACE "/" "_" folder ${folder})
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder})
  endforeach()
endfunction()

# triax_library(NAME): every .cpp below this folder, so that a new file pair needs no other edit.
function(triax_library name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp *.hpp)
  add_library(${name} STATIC ${sources})
  triax_folders_as_units(${name})
  # Our warnings are ours: who uses an installed library has flags of their own.
  target_link_libraries(${name} PUBLIC $<BUILD_INTERFACE:triax_flags>)
endfunction()

# triax_embed(TARGET SYMBOL [WITH_ENDINGS] FILES...): the files' text as a C++ table that needs no install path, by the files'
# names without their endings unless told otherwise.
# Declares in namespace triax: extern const std::span<const EmbeddedFile> SYMBOL (lab/base/embedded.hpp).
function(triax_embed target symbol)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${symbol}.cpp)
  cmake_parse_arguments(PARSE_ARGV 2 embed "WITH_ENDINGS" "" "")
  set(files ${embed_UNPARSED_ARGUMENTS})
  add_custom_command(OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} -DOUT=${out} -DSYMBOL=${symbol} -DWITH_ENDINGS=${embed_WITH_ENDINGS} "-DFILES=${files}"
            -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${files} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake VERBATIM)
  target_sources(${target} PRIVATE ${out})
endfunction()

# triax_tests(NAME LIBRARIES...): the Catch2 tests below this folder as one program, and an entry of ctest for each
# of its files (cmake/test_entries.cmake).
function(triax_tests name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp)
  triax_test_program(${name} "${sources}" ${ARGN})
  triax_test_entries(${name} "${sources}")
endfunction()

# triax_test_program(NAME SOURCES LIBRARIES...)
function(triax_test_program name sources)
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE triax_test_main ${ARGN})
  triax_folders_as_units(${name})
  triax_precompile(${name} <catch2/catch.hpp> <Eigen/Dense> <fmt/format.h>)
  # A test's own code is not what has to be fast, but all of it has to be compiled: a third of the time.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1> $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    set_target_properties(${name} PROPERTIES COMPILE_WARNING_AS_ERROR OFF)  # the tests are written against g++'s warnings
  endif()
endfunction()

# triax_test_entries(NAME SOURCES [TAG]): ctest finds the entries when it runs, so that a tag or a case that is
# written into a test needs no new configuration. With TAG, only the cases that have it.
function(triax_test_entries name sources)
  set(entries ${CMAKE_CURRENT_BINARY_DIR}/${name}_entries.cmake)
  file(GENERATE OUTPUT ${entries} CONTENT "set(program \"$<TARGET_FILE:${name}>\")
set(name ${name})
set(files \"${sources}\")
set(only \"${ARGN}\")
set(options ${TRIAX_CATCH2_OPTIONS})
set(root \"${PROJECT_SOURCE_DIR}\")
include(\"${PROJECT_SOURCE_DIR}/cmake/test_entries.cmake\")
")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${entries})
endfunction()

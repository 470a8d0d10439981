# How the project's own targets are built: one function for a library, one for a program, one for a test.

set_property(GLOBAL PROPERTY TARGET_MESSAGES OFF)  # no 'Built target' lines: a build with nothing to do is silent

add_library(gsim_options INTERFACE)
target_include_directories(gsim_options INTERFACE ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR})
target_compile_options(gsim_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror>)
# g++ is the compiler whose warnings count; clang builds for sanitizers and fuzzing, where a warning of its own shall not stop anybody.
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    target_compile_options(gsim_options INTERFACE -Wno-error -Wno-sign-conversion)
endif()
if(GSIM_SANITIZE)
    add_compile_options(-fsanitize=${GSIM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${GSIM_SANITIZE})
    # The checks that the sanitizers put in make g++ 12 see uninitialized values where there are none.
    add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

# Reading the same large headers again and again is a third of the time of a build. Targets of a few sources gain nothing.
# clang-tidy cannot do with g++'s precompiled headers, so libraries have them where GSIM_PRECOMPILE asks for it alone.
option(GSIM_PRECOMPILE "Precompile headers for libraries, too" OFF)
function(gsim_precompile name)
    cmake_parse_arguments(ARG "" "" "HEADERS" ${ARGN})
    get_target_property(sources ${name} SOURCES)
    list(LENGTH sources count)
    if(count GREATER 5)
        target_precompile_headers(${name} PRIVATE ${ARG_HEADERS} <fmt/format.h> <algorithm> <cmath> <functional> <map> <memory>
                                  <optional> <string> <vector>)
    endif()
endfunction()

# gsim_library(NAME SOURCES... [LINK LIBS...]): a static library of one room.
function(gsim_library name)
    cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
    add_library(${name} STATIC ${ARG_UNPARSED_ARGUMENTS})
    target_link_libraries(${name} PUBLIC gsim_options ${ARG_LINK})
    if(GSIM_PRECOMPILE AND name MATCHES "motion|simulation|script|machine|cell|kinematics|rrs")
        gsim_precompile(${name} HEADERS <Eigen/Core> <Eigen/Geometry> <tl/expected.hpp>)
    endif()
endfunction()

# gsim_program(NAME SOURCES... [LINK LIBS...]): a program that is installed.
function(gsim_program name)
    cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
    add_executable(${name} ${ARG_UNPARSED_ARGUMENTS})
    target_link_libraries(${name} PRIVATE gsim_options ${ARG_LINK})
    install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endfunction()

# gsim_test(NAME SOURCES... [LINK LIBS...]): a GoogleTest program, one ctest entry for each of its cases.
function(gsim_test name)
    cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
    add_executable(${name} ${ARG_UNPARSED_ARGUMENTS})
    target_link_libraries(${name} PRIVATE gsim_options ${ARG_LINK} GTest::gtest GTest::gmock GTest::gtest_main)
    # g++ 12 takes "text" + std::string for an overlapping or endless copy (GCC bug 105651).
    target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overflow -Wno-array-bounds>)
    # Tests are compiled more often than they are run.
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
    gsim_precompile(${name} HEADERS <gtest/gtest.h> <gmock/gmock.h>)
    add_test(NAME ${name} COMMAND ${name})
endfunction()

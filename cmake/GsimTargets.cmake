# Builds the project's targets: one function for a library, one for a program, one for a test.

set_property(GLOBAL PROPERTY TARGET_MESSAGES OFF)  # no 'Built target' lines: a build with nothing to do is silent

add_library(gsim_options INTERFACE)
target_include_directories(gsim_options INTERFACE ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR})
target_compile_options(gsim_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror>)
# The warnings of g++ are errors. clang builds only for sanitizers and fuzzing, so its warnings do not stop the build.
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    target_compile_options(gsim_options INTERFACE -Wno-error -Wno-sign-conversion)
endif()
# g++ collects garbage less often: this saves a tenth of the time of a unit, for a tenth more memory.
add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:--param=ggc-min-heapsize=2000000>)
# Objects do not contain the folder of the build, so that two clones can share a compiler cache. gcov needs the paths of the sources.
if(NOT GSIM_COVERAGE)
    add_compile_options(-ffile-prefix-map=${CMAKE_SOURCE_DIR}=. -ffile-prefix-map=${CMAKE_BINARY_DIR}=build)
endif()
# Release builds are hardened.
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT GSIM_SANITIZE AND NOT EMSCRIPTEN)
    add_compile_options(-fstack-protector-strong -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
    add_link_options(-Wl,-z,relro,-z,now)
endif()
if(GSIM_SANITIZE)
    add_compile_options(-fsanitize=${GSIM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${GSIM_SANITIZE})
    add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,Clang>:-fsanitize-ignorelist=${CMAKE_SOURCE_DIR}/cmake/sanitize-ignore.txt>)
    # The checks of the sanitizers make g++ 12 report uninitialized values that are none.
    add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

if(GSIM_COVERAGE)
    if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        message(FATAL_ERROR "GSIM_COVERAGE is for g++ and its gcov; the compiler is ${CMAKE_CXX_COMPILER_ID}")
    endif()
    add_compile_options(--coverage -fprofile-abs-path)
    add_link_options(--coverage)
endif()

# gsim_generated(TARGET HEADERS...): headers that a library generates. The target `generated` makes those of all libraries; checks of
# sources (scripts/lint.sh) need nothing else of a build.
add_custom_target(generated)
function(gsim_generated target)
    foreach(header ${ARGN})
        get_filename_component(name ${header} NAME_WE)
        add_custom_target(generated_${name} DEPENDS ${header})
        add_dependencies(${target} generated_${name})  # else both would make it at the same time
        add_dependencies(generated generated_${name})
    endforeach()
endfunction()

# Cold code (that runs once for a file, a program or a report, not for each block) has the optimisation of debug builds: it compiles
# in two thirds of the time. Functions that are called once are inlined, or objects would be twice as large.
set(GSIM_COLD_OPTIONS "")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # With -Og g++ 12 warns about members of an empty std::optional, which are never read (as with the sanitizers above).
    set(GSIM_COLD_OPTIONS "$<$<CONFIG:Release>:-Og;-finline-functions-called-once;-Wno-maybe-uninitialized>")
endif()

# Reading the same large headers again for each batch is a quarter of the time of a build. Builds in batches (preset release) read
# them once: one set for hot libraries, one for cold libraries, and two for tests. g++ takes the optimisation of a unit from the
# precompiled header, so units that share one share their options. nlohmann-json is in none: its header has inline functions that
# instantiate its parser in each unit, for a third of a second. Debug builds and clang-tidy read each source without these headers, so
# they find a missing #include. Definitions change headers, so all units have those of fmt and Eigen, whether they link them or not.
option(GSIM_PRECOMPILE "Precompile the headers that most units read" ${GSIM_BATCHES})
find_package(Eigen3 REQUIRED)
find_package(fmt REQUIRED)
if(GSIM_PRECOMPILE)
    target_link_libraries(gsim_options INTERFACE Eigen3::Eigen fmt::fmt)
    set(headers <Eigen/Core> <Eigen/Geometry> <fmt/format.h> <tl/expected.hpp> <algorithm> <array> <cmath> <cstdio> <filesystem> <functional>
                <map> <memory> <optional> <span> <string> <string_view> <utility> <vector>)
    file(CONFIGURE OUTPUT precompiled.cpp CONTENT "int main() {}\n" @ONLY)
    foreach(set precompiled precompiled_cold)
        add_library(gsim_${set} OBJECT ${CMAKE_BINARY_DIR}/precompiled.cpp)
        target_link_libraries(gsim_${set} PRIVATE gsim_options)
        target_precompile_headers(gsim_${set} PRIVATE ${headers})
    endforeach()
    target_compile_options(gsim_precompiled_cold PRIVATE ${GSIM_COLD_OPTIONS})
endif()

# gsim_library(NAME SOURCES... [LINK LIBS...] [COLD]): adds a static library of one folder. COLD: its code does not run for each block.
function(gsim_library name)
    cmake_parse_arguments(ARG "COLD" "" "LINK" ${ARGN})
    add_library(${name} STATIC ${ARG_UNPARSED_ARGUMENTS})
    target_link_libraries(${name} PUBLIC gsim_options ${ARG_LINK})
    if(EMSCRIPTEN AND name MATCHES "^gsim_(lexer|grammar|codegen|script|motion|simulation|cell)$")
        target_compile_options(${name} PRIVATE -O2)
    endif()
    set_property(TARGET ${name} PROPERTY GSIM_IS_COLD ${ARG_COLD})
    set(headers gsim_precompiled)
    if(ARG_COLD)
        target_compile_options(${name} PRIVATE ${GSIM_COLD_OPTIONS})
        set(headers gsim_precompiled_cold)
    else()
        set_property(GLOBAL APPEND PROPERTY GSIM_HOT_LIBRARIES ${name})
    endif()
    if(GSIM_PRECOMPILE)
        target_precompile_headers(${name} REUSE_FROM ${headers})
    endif()
endfunction()

# gsim_program(NAME SOURCES... [LINK LIBS...] [COMPONENT NAME FOLDER FOLDER]): adds a program and installs it. Without COMPONENT and
# FOLDER it is installed with the programs that people call.
function(gsim_program name)
    cmake_parse_arguments(ARG "" "COMPONENT;FOLDER" "LINK" ${ARGN})
    add_executable(${name} ${ARG_UNPARSED_ARGUMENTS})
    target_link_libraries(${name} PRIVATE gsim_options ${ARG_LINK})
    target_compile_options(${name} PRIVATE ${GSIM_COLD_OPTIONS})
    gsim_hot_first(${name} ${ARG_LINK})
    if(NOT ARG_COMPONENT)
        set(ARG_COMPONENT programs)
        set(ARG_FOLDER ${CMAKE_INSTALL_BINDIR})
    endif()
    install(TARGETS ${name} RUNTIME DESTINATION ${ARG_FOLDER} COMPONENT ${ARG_COMPONENT})
    add_dependencies(product ${name})
endfunction()

# Tests are compiled more often than they are run, so they have no optimisation, except those that compute much themselves.
# _FORTIFY_SOURCE is off because it warns without optimisation.
set(GSIM_PLAIN_OPTIONS "")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(GSIM_PLAIN_OPTIONS "$<$<CONFIG:Release>:-O0;-U_FORTIFY_SOURCE>")
endif()
# gsim_test_options(NAME plain | cold): sets GSIM_PLAIN_OPTIONS or GSIM_COLD_OPTIONS, and the options of all tests.
function(gsim_test_options name kind)
    # g++ 12 reports "text" + std::string as an overlapping or endless copy (GCC bug 105651).
    target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overflow -Wno-array-bounds>)
    string(TOUPPER GSIM_${kind}_OPTIONS optimisation)
    target_compile_options(${name} PRIVATE ${${optimisation}})
endfunction()
if(GSIM_PRECOMPILE AND GSIM_TESTS)
    foreach(kind plain cold)
        add_executable(gsim_precompiled_${kind}_tests ${CMAKE_BINARY_DIR}/precompiled.cpp)
        target_link_libraries(gsim_precompiled_${kind}_tests PRIVATE gsim_options GTest::gtest GTest::gmock)
        gsim_test_options(gsim_precompiled_${kind}_tests ${kind})
        target_precompile_headers(gsim_precompiled_${kind}_tests PRIVATE <gtest/gtest.h> <gmock/gmock.h> ${headers} <random>)
    endforeach()
endif()

# Tests are linked by mold if it is installed, in two fifths of the time.
find_program(GSIM_MOLD mold)
mark_as_advanced(GSIM_MOLD)

# gsim_test(NAME SOURCES... [LINK LIBS...] [COMPUTES]): adds a GoogleTest program. COMPUTES: it is optimised, because it would otherwise
# take many times as long.
function(gsim_test name)
    cmake_parse_arguments(ARG "COMPUTES" "" "LINK" ${ARGN})
    add_executable(${name} ${ARG_UNPARSED_ARGUMENTS})
    target_link_libraries(${name} PRIVATE gsim_options ${ARG_LINK} gsim_json gsim_text gsim_build_files GTest::gtest GTest::gmock GTest::gtest_main)
    gsim_hot_first(${name} ${ARG_LINK})
    set(kind plain)
    if(ARG_COMPUTES)
        set(kind cold)
    endif()
    gsim_test_options(${name} ${kind})
    if(GSIM_MOLD)
        target_link_options(${name} PRIVATE -fuse-ld=mold)
    endif()
    if(GSIM_PRECOMPILE)
        target_precompile_headers(${name} REUSE_FROM gsim_precompiled_${kind}_tests)
    endif()
    add_test(NAME ${name} COMMAND ${name})
endfunction()

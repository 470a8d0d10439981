# Finds the libraries for WebAssembly, for which Debian has only emscripten and no built libraries.
#
# Header-only libraries are those of Debian, through a folder with links to them. Other headers of /usr/include belong to another
# C library. Lua and pugixml are compiled from Debian's sources (scripts/wasm-sources.sh).

set(GSIM_WASM_SOURCES ${CMAKE_SOURCE_DIR}/build-wasm-sources CACHE PATH "Where scripts/wasm-sources.sh has put sources")
foreach(folder lua5.4 pugixml)
    if(NOT EXISTS ${GSIM_WASM_SOURCES}/${folder}/src)
        message(FATAL_ERROR "there is no ${GSIM_WASM_SOURCES}/${folder}; scripts/wasm-sources.sh fetches it")
    endif()
endforeach()

set(headers ${CMAKE_BINARY_DIR}/system-headers)
file(MAKE_DIRECTORY ${headers})
foreach(part CLI fast_float fmt nlohmann tl toml++)
    if(NOT EXISTS /usr/include/${part})
        message(FATAL_ERROR "there is no /usr/include/${part}; scripts/setup.sh wasm installs it")
    endif()
    file(CREATE_LINK /usr/include/${part} ${headers}/${part} SYMBOLIC)
endforeach()
include_directories(SYSTEM ${headers} /usr/include/eigen3)

set(CMAKE_POSITION_INDEPENDENT_CODE OFF)

# WebAssembly's exceptions replace setjmp() and the exceptions of JavaScript; Bison's GLR parsers use setjmp().
add_compile_options(-fwasm-exceptions -sSUPPORT_LONGJMP=wasm)
add_link_options(-fwasm-exceptions -sSUPPORT_LONGJMP=wasm)

# emscripten's JavaScript tools are in the module folder of Debian's node; another node needs NODE_PATH to find them.
set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")

# gsim_redirect(PACKAGE TARGET [DEFINITIONS...]): makes find_package(PACKAGE) find a header-only target of the installed version.
function(gsim_redirect package target)
    file(GLOB version_files /usr/lib/cmake/${package}/*[vV]ersion.cmake /usr/lib/*/cmake/${package}/*[vV]ersion.cmake
         /usr/share/cmake/${package}/*[vV]ersion.cmake /usr/share/${package}/cmake/*[vV]ersion.cmake)
    set(version "")
    foreach(file ${version_files})
        file(STRINGS ${file} line REGEX "set\\(PACKAGE_VERSION \"[0-9.]+\"" LIMIT_COUNT 1)
        if(line)
            string(REGEX REPLACE ".*\"([0-9.]+)\".*" "\\1" version "${line}")
        endif()
    endforeach()
    string(TOLOWER ${package} name)
    file(WRITE ${CMAKE_FIND_PACKAGE_REDIRECTS_DIR}/${name}-config.cmake "
set(${package}_VERSION \"${version}\")
if(NOT TARGET ${target})
    add_library(${target} INTERFACE IMPORTED GLOBAL)
    target_compile_definitions(${target} INTERFACE ${ARGN})
endif()
")
endfunction()

gsim_redirect(Eigen3 Eigen3::Eigen)
gsim_redirect(fmt fmt::fmt FMT_HEADER_ONLY)
gsim_redirect(nlohmann_json nlohmann_json::nlohmann_json)
gsim_redirect(CLI11 CLI11::CLI11)
gsim_redirect(FastFloat FastFloat::fast_float)
gsim_redirect(tomlplusplus tomlplusplus::tomlplusplus)

# Debian generates this header when it builds Lua: it is part of a search path that a sandboxed Lua does not use.
file(WRITE ${headers}/lua5.4-deb-multiarch.h "#define DEB_HOST_MULTIARCH \"wasm32-emscripten\"\n")

# Lua is compiled as C++, as Debian's lua5.4-c++, so that its errors are exceptions.
file(GLOB lua_sources ${GSIM_WASM_SOURCES}/lua5.4/src/*.c)
list(FILTER lua_sources EXCLUDE REGEX "/(lua|luac)\\.c$")
set_source_files_properties(${lua_sources} PROPERTIES LANGUAGE CXX)
add_library(gsim_lua STATIC ${lua_sources})
set_target_properties(gsim_lua PROPERTIES CXX_EXTENSIONS ON)
target_compile_options(gsim_lua PRIVATE -w -O2)
target_compile_definitions(gsim_lua PRIVATE LUA_USE_POSIX)
target_include_directories(gsim_lua SYSTEM PUBLIC ${GSIM_WASM_SOURCES}/lua5.4/src)
add_library(PkgConfig::LUA ALIAS gsim_lua)
file(STRINGS ${GSIM_WASM_SOURCES}/lua5.4/src/lua.h lines REGEX "define LUA_VERSION_(MAJOR|MINOR|RELEASE)[ \t]+\"[0-9]+\"")
string(REGEX MATCHALL "\"[0-9]+\"" LUA_VERSION "${lines}")
string(REPLACE "\"" "" LUA_VERSION "${LUA_VERSION}")
string(REPLACE ";" "." LUA_VERSION "${LUA_VERSION}")

add_library(gsim_pugixml STATIC ${GSIM_WASM_SOURCES}/pugixml/src/pugixml.cpp)
target_include_directories(gsim_pugixml SYSTEM PUBLIC ${GSIM_WASM_SOURCES}/pugixml/src)
add_library(pugixml::pugixml ALIAS gsim_pugixml)
file(WRITE ${CMAKE_FIND_PACKAGE_REDIRECTS_DIR}/pugixml-config.cmake "set(pugixml_VERSION 1.13)\n")

# Compiles through ccache if it is installed (scripts/setup.sh installs it), for all presets. Another launcher in
# CMAKE_CXX_COMPILER_LAUNCHER takes precedence; CCACHE_DISABLE=1 in the environment compiles without ccache.
option(GSIM_CCACHE "Compile through ccache where it is installed" ON)
find_program(GSIM_CCACHE_PROGRAM ccache)
mark_as_advanced(GSIM_CCACHE_PROGRAM)
if(GSIM_CCACHE AND GSIM_CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_C_COMPILER_LAUNCHER ${CMAKE_SOURCE_DIR}/scripts/ccache.sh ${CMAKE_SOURCE_DIR})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_C_COMPILER_LAUNCHER})
endif()

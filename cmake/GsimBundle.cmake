# libgsim, shared and static, for other programs, from the modules below engine/. It exports only its interface (engine/api.h,
# engine/gsim.h).

# gsim_bundle(SHARED ARCHIVE TARGETS...): makes both libraries from the interfaces of TARGETS and all that they link.
function(gsim_bundle shared archive)
    gsim_parts(parts ${ARGN})
    set(whole "")
    foreach(target ${ARGN})
        list(APPEND whole $<TARGET_FILE:${target}>)
    endforeach()
    file(CONFIGURE OUTPUT shared.cpp CONTENT "" @ONLY)
    add_library(${shared} SHARED ${CMAKE_CURRENT_BINARY_DIR}/shared.cpp)
    target_link_libraries(${shared} PRIVATE -Wl,--whole-archive ${whole} -Wl,--no-whole-archive ${ARGN})
    add_dependencies(${shared} ${ARGN})
    set_target_properties(${shared} PROPERTIES OUTPUT_NAME gsim VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}
                          LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
    target_link_options(${shared} PRIVATE -Wl,--exclude-libs,libpugixml.a)
    gsim_hot_first(${shared} ${ARGN})

    # The archive has one object, so that this link also decides which copies of inline functions are kept.
    gsim_hot_parts(hot ${parts})
    set(files ${hot} ${parts})
    list(REMOVE_DUPLICATES files)
    list(TRANSFORM files REPLACE "(.+)" "$<TARGET_FILE:\\1>")
    set(object ${CMAKE_CURRENT_BINARY_DIR}/gsim.o)
    add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/lib/libgsim.a
                       COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/lib
                       COMMAND ${CMAKE_COMMAND} -E rm -f ${CMAKE_BINARY_DIR}/lib/libgsim.a
                       COMMAND ${CMAKE_LINKER} -r --whole-archive ${files} -o ${object}
                       COMMAND ${CMAKE_AR} qcsD ${CMAKE_BINARY_DIR}/lib/libgsim.a ${object}
                       DEPENDS ${parts} COMMENT "Linking CXX static library lib/libgsim.a" VERBATIM)
    add_custom_target(${archive} ALL DEPENDS ${CMAKE_BINARY_DIR}/lib/libgsim.a)
endfunction()

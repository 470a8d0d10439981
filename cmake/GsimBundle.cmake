# libgsim, shared and static, of the rooms below engine/: what other programs link. Only its interface shows (engine/api.h, engine/gsim.h).

# gsim_parts(RESULT TARGETS...): the project's own static libraries that these link, themselves among them, users before what they use.
function(gsim_parts result)
    set(parts "")
    set(waiting ${ARGN})
    while(waiting)
        list(POP_FRONT waiting part)
        if(NOT TARGET ${part} OR part IN_LIST parts)
            continue()
        endif()
        get_target_property(type ${part} TYPE)
        get_target_property(imported ${part} IMPORTED)
        if(imported OR NOT type STREQUAL "STATIC_LIBRARY")
            continue()
        endif()
        list(APPEND parts ${part})
        get_target_property(links ${part} LINK_LIBRARIES)
        if(links)
            list(APPEND waiting ${links})
        endif()
    endwhile()
    set(${result} ${parts} PARENT_SCOPE)
endfunction()

# gsim_bundle(SHARED ARCHIVE TARGETS...): both libraries of what TARGETS show and all that they link.
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

    # An archive of the archives' objects, by ar's own script.
    set(script "create ${CMAKE_BINARY_DIR}/lib/libgsim.a\n")
    foreach(part ${parts})
        string(APPEND script "addlib $<TARGET_FILE:${part}>\n")
    endforeach()
    string(APPEND script "save\nend\n")
    file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/bundle.mri CONTENT "${script}")
    add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/lib/libgsim.a
                       COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/lib
                       COMMAND ${CMAKE_AR} -M < ${CMAKE_CURRENT_BINARY_DIR}/bundle.mri
                       DEPENDS ${parts} ${CMAKE_CURRENT_BINARY_DIR}/bundle.mri COMMENT "Linking CXX static library lib/libgsim.a" VERBATIM)
    add_custom_target(${archive} ALL DEPENDS ${CMAKE_BINARY_DIR}/lib/libgsim.a)
endfunction()

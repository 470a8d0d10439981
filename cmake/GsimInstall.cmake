# The files and folders of `cmake --install`, in components: programs (with the Lua library to read and change, and the samples),
# solid, calibrate, library (libgsim), development, python, docs, licence. Debian's packages use the same components (debian/rules).
# The build does not depend on the folder of the installation, so one build serves every prefix.
set(GSIM_DATADIR ${CMAKE_INSTALL_DATADIR}/gsim)

install(DIRECTORY lua_lib DESTINATION ${GSIM_DATADIR} COMPONENT programs FILES_MATCHING PATTERN "*.lua" PATTERN "README.md")
install(DIRECTORY samples DESTINATION ${GSIM_DATADIR} COMPONENT programs)
# The page, if `make studio` has made it.
install(DIRECTORY ${CMAKE_BINARY_DIR}/${GSIM_DATADIR}/studio DESTINATION ${GSIM_DATADIR} COMPONENT programs OPTIONAL)

# These files are in the data folder of the programs; people, and the links of the documentation, look for them below docs.
foreach(folder samples lua_lib)
    file(RELATIVE_PATH there /${CMAKE_INSTALL_DOCDIR} /${GSIM_DATADIR}/${folder})
    file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/links)
    file(CREATE_LINK ${there} ${CMAKE_BINARY_DIR}/links/${folder} SYMBOLIC)
    install(FILES ${CMAKE_BINARY_DIR}/links/${folder} DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT programs)
endforeach()

configure_file(cmake/gsim.pc.in gsim.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/gsim.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig COMPONENT development)
install(FILES controller/module/rcs_module.h controller/module/rcs_services.def DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gsim COMPONENT development)
# The example finds the header in the folder in which an author of modules has it.
file(READ tests/controller/modules/small_module.c example)
string(REPLACE "\"controller/module/rcs_module.h\"" "<gsim/rcs_module.h>" example "${example}")
file(CONFIGURE OUTPUT examples/small_module.c CONTENT "${example}" @ONLY)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS tests/controller/modules/small_module.c)
install(FILES ${CMAKE_BINARY_DIR}/examples/small_module.c DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT development)

# The engine as a library: headers include each other as <gsim/engine/run.h>, so they work in any folder.
include(CMakePackageConfigHelpers)
file(GLOB headers CONFIGURE_DEPENDS engine/*.h engine/*.def base/kinds/*.def)
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/python/gsim)
foreach(header ${headers})
    get_filename_component(name ${header} NAME)
    file(READ ${header} text)
    string(REPLACE "#include \"engine/" "#include \"gsim/engine/" text "${text}")
    string(REPLACE "#include \"base/kinds/" "#include \"gsim/engine/" text "${text}")
    set(folder gsim/engine)
    if(name STREQUAL "gsim.h")
        set(folder gsim)
    endif()
    file(CONFIGURE OUTPUT headers/${folder}/${name} CONTENT "${text}" @ONLY)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
    install(FILES ${CMAKE_BINARY_DIR}/headers/${folder}/${name} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder} COMPONENT development)
endforeach()
configure_file(cmake/libgsim.pc.in libgsim.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/libgsim.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig COMPONENT development)
configure_package_config_file(cmake/gsimConfig.cmake.in gsimConfig.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gsim
                              PATH_VARS CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(gsimConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/gsimConfig.cmake ${CMAKE_BINARY_DIR}/gsimConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/gsim COMPONENT development)

# Pure Python that calls the shared library. The packager chooses the folder in which a system's Python looks for it.
find_package(Python3 QUIET COMPONENTS Interpreter)
set(GSIM_PYTHONDIR lib/python3/dist-packages CACHE STRING "Where the module for Python is installed, below the prefix")
if(Python3_FOUND)
    execute_process(COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/scripts/cdef.py ${CMAKE_SOURCE_DIR}/engine/gsim.h
                    OUTPUT_FILE ${CMAKE_BINARY_DIR}/python/gsim/gsim.cdef COMMAND_ERROR_IS_FATAL ANY)
    configure_file(engine/python/gsim/__init__.py python/gsim/__init__.py COPYONLY)
    install(DIRECTORY ${CMAKE_BINARY_DIR}/python/gsim DESTINATION ${GSIM_PYTHONDIR} COMPONENT python PATTERN __pycache__ EXCLUDE)
endif()

install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT docs)
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT docs)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licence)

# All that is installed; the targets that install themselves are added to it below.
add_custom_target(product)

# gsim_own_page(NAME COMPONENT [LINKS]): installs man page and completions of a program that is not part of gsim, as it prints them
# (`NAME manual`, `NAME completion SHELL`). LINKS: other targets that must exist before it can be called by its name.
function(gsim_own_page name component)
    set(man ${CMAKE_BINARY_DIR}/man)
    set(completions ${CMAKE_BINARY_DIR}/completions)
    set(call ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${name})
    set(made ${man}/${name}.1 ${completions}/${name}.bash ${completions}/${name}.zsh ${completions}/${name}.fish)
    add_custom_command(OUTPUT ${made} COMMAND ${CMAKE_COMMAND} -E make_directory ${man} ${completions} COMMAND ${call} manual > ${man}/${name}.1
                       COMMAND ${call} completion bash > ${completions}/${name}.bash COMMAND ${call} completion zsh > ${completions}/${name}.zsh
                       COMMAND ${call} completion fish > ${completions}/${name}.fish
                       DEPENDS ${call} ${ARGN} COMMENT "Writing man page and completions of ${name}" VERBATIM)
    add_custom_target(${name}-page ALL DEPENDS ${made})
    add_dependencies(product ${name}-page)
    install(FILES ${man}/${name}.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component})
    install(FILES ${completions}/${name}.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME ${name} COMPONENT ${component})
    install(FILES ${completions}/${name}.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT ${component})
    install(FILES ${completions}/${name}.zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions RENAME _${name} COMPONENT ${component})
endfunction()

# gsim_own_name(NAME PROGRAM COMPONENT): installs another name of such a program. By that name it is another program with its own pages.
function(gsim_own_name name program component)
    set(link ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${name})
    add_custom_command(OUTPUT ${link} COMMAND ${CMAKE_COMMAND} -E create_symlink ${program} ${link} DEPENDS ${program} COMMENT "Linking ${name}" VERBATIM)
    add_custom_target(${name} ALL DEPENDS ${link})
    add_dependencies(product ${name})
    gsim_own_page(${name} ${component} ${program})
    add_dependencies(${name}-page ${name})
    install(FILES ${link} DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${component})
endfunction()

# gsim_pages(NAMES...): installs man pages and completions of gsim and of its other names, as the program prints them.
function(gsim_pages)
    set(man ${CMAKE_BINARY_DIR}/man)
    set(completions ${CMAKE_BINARY_DIR}/completions)
    set(commands "")
    set(pages "")
    foreach(name gsim ${ARGN})
        list(APPEND pages ${man}/${name}.1)
        list(APPEND commands COMMAND gsim manual ${name} > ${man}/${name}.1)
    endforeach()
    foreach(shell bash zsh fish)
        list(APPEND commands COMMAND gsim completion ${shell} > ${completions}/gsim.${shell})
    endforeach()
    # bash and fish look for a file with the name of the program.
    foreach(name ${ARGN})
        list(APPEND commands COMMAND ${CMAKE_COMMAND} -E create_symlink gsim ${completions}/${name})
        list(APPEND commands COMMAND ${CMAKE_COMMAND} -E create_symlink gsim.fish ${completions}/${name}.fish)
        install(FILES ${completions}/${name} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT programs)
        install(FILES ${completions}/${name}.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT programs)
    endforeach()
    set(made ${pages} ${completions}/gsim.bash ${completions}/gsim.zsh ${completions}/gsim.fish)
    add_custom_command(OUTPUT ${made} COMMAND ${CMAKE_COMMAND} -E make_directory ${man} ${completions} ${commands}
                       DEPENDS gsim COMMENT "Writing man pages and completions" VERBATIM)
    add_custom_target(gsim-pages ALL DEPENDS ${made})
    add_dependencies(product gsim-pages)

    install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT programs)
    install(FILES ${completions}/gsim.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME gsim COMPONENT programs)
    install(FILES ${completions}/gsim.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT programs)
    # zsh looks here below /usr/local; Debian's packages have another folder (debian/rules).
    install(FILES ${completions}/gsim.zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions RENAME _gsim COMPONENT programs)
endfunction()

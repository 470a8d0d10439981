# What `cmake --install` adds to the programs: the Lua library to read and change (--lua-lib), machines, samples.
set(GSIM_DATADIR ${CMAKE_INSTALL_DATADIR}/gsim)

install(DIRECTORY lua_lib DESTINATION ${GSIM_DATADIR} FILES_MATCHING PATTERN "*.lua")
install(DIRECTORY samples DESTINATION ${GSIM_DATADIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)

# Run by the test install/package: makes the Debian package, and uses what is in it.
file(REMOVE_RECURSE ${scratch})
file(MAKE_DIRECTORY ${scratch})

function(run)
    execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# What takes longest is to make the package small, which only the long form of the tests does.
if(NOT DEFINED ENV{MECHWRIGHT_LONG_TESTS})
    set(quickly -D CPACK_DEBIAN_COMPRESSION_TYPE=zstd)
endif()
run(${CMAKE_CPACK_COMMAND} --config ${build}/CPackConfig.cmake ${quickly} -B ${scratch})
file(GLOB package ${scratch}/mechwright_*.deb)
run(dpkg-deb --extract ${package} ${scratch}/root)

execute_process(COMMAND dpkg-deb --field ${package} Depends OUTPUT_VARIABLE needs COMMAND_ERROR_IS_FATAL ANY)
foreach(library libnlopt libipopt libsqlite3 libstdc)
    if(NOT needs MATCHES ${library})
        message(FATAL_ERROR "the package does not ask for ${library}: ${needs}")
    endif()
endforeach()
if(needs MATCHES "-dev")
    message(FATAL_ERROR "the package asks for what only compiling needs: ${needs}")
endif()

set(prefix ${scratch}/root/usr)
run(${prefix}/bin/mechwright solve --quiet ${prefix}/share/mechwright/problems/four-bar/crank-rocker.toml)
foreach(file include/mechwright/analysis/four_bar.h share/man/man1/mechwright.1 share/doc/mechwright/LICENSE
        share/mechwright/problems/README.md)
    if(NOT EXISTS ${prefix}/${file})
        message(FATAL_ERROR "the package has no ${file}")
    endif()
endforeach()

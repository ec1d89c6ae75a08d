# Run by the test install/archive: makes the archive with the program from the build that is there, unpacks it elsewhere,
# and uses it with its own libraries.
file(REMOVE_RECURSE ${scratch})
file(MAKE_DIRECTORY ${scratch}/elsewhere)

function(run)
    execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} -D build=${build} -D to=${scratch} -P ${source}/synthesis/cmake/archive.cmake)
file(GLOB archive ${scratch}/mechwright-*.tar.gz)
file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${scratch}/elsewhere)
file(GLOB root ${scratch}/elsewhere/mechwright-*)
run(${root}/bin/mechwright solve --quiet ${root}/share/mechwright/problems/four-bar/crank-rocker.toml)

# What is loaded is its own, but for what every Linux has.
execute_process(COMMAND ${CMAKE_COMMAND} -E env LD_TRACE_LOADED_OBJECTS=1 ${root}/bin/mechwright
                OUTPUT_VARIABLE loaded COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+ => [^\n]+" loaded "${loaded}")
list(FILTER loaded EXCLUDE REGEX "=> ${root}/bin/../lib/mechwright/")
list(FILTER loaded EXCLUDE REGEX "lib(c|m|stdc[+][+]|gcc_s)[.]so")
if(loaded)
    message(FATAL_ERROR "the archive lacks libraries: ${loaded}")
endif()
foreach(file share/man/man1/mechwright.1 share/doc/mechwright/LICENSE lib/mechwright/liblapack3.copyright)
    if(NOT EXISTS ${root}/${file})
        message(FATAL_ERROR "the archive has no ${file}")
    endif()
endforeach()

# An archive with the program, what it needs, and the problems: to unpack anywhere on a Linux with the same C library or
# a later one, and run.
#
#   cmake -D build=build/release -D to=FOLDER -P synthesis/cmake/archive.cmake       a build of `mechwright`
cmake_minimum_required(VERSION 3.25)
function(run)
    execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endfunction()

load_cache(${build} READ_WITH_PREFIX made_ CMAKE_PROJECT_VERSION)
cmake_host_system_information(RESULT processor QUERY OS_PLATFORM)
set(name mechwright-${made_CMAKE_PROJECT_VERSION}-linux-${processor})
file(REMOVE_RECURSE ${to}/${name})
run(${CMAKE_COMMAND} --install ${build} --prefix ${to}/${name} --component program --strip)
run(${CMAKE_COMMAND} -D binary=${to}/${name}/bin/mechwright -D into=${to}/${name}/lib/mechwright
    -P ${CMAKE_CURRENT_LIST_DIR}/bundle.cmake)
execute_process(COMMAND ${CMAKE_COMMAND} -E tar czf ${name}.tar.gz ${name} WORKING_DIRECTORY ${to}
                COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${to}/${name})
message("wrote ${to}/${name}.tar.gz")

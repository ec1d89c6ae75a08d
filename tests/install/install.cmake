# Run by the tests install/*: see CMakeLists.txt beside this file.
file(REMOVE_RECURSE ${scratch})

function(run)
    execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Searched only where the component may look.
if(component STREQUAL "analysis")
    set(unneeded Boost fmt muparser nlohmann_json SQLite3 SQLiteCpp Threads tomlplusplus PkgConfig)
endif()
foreach(package benchmark CLI11 Eigen3 ${unneeded})
    list(APPEND without -D CMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()

run(${CMAKE_COMMAND} --install ${build} --prefix ${scratch}/first)
# Nothing may point back to where it was first.
file(RENAME ${scratch}/first ${scratch}/prefix)

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${scratch}/build -G ${generator}
    -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_EXE_LINKER_FLAGS=${link_flags}
    -D CMAKE_PREFIX_PATH=${scratch}/prefix -D component=${component} ${without})
run(${CMAKE_COMMAND} --build ${scratch}/build)
run(${scratch}/build/consumer)
run(${scratch}/prefix/bin/mechwright --version)

foreach(file bash-completion/completions/mechwright zsh/site-functions/_mechwright
        fish/vendor_completions.d/mechwright.fish man/man1/mechwright.1)
    file(SIZE ${scratch}/prefix/share/${file} size)
    if(size LESS 1000)
        message(FATAL_ERROR "share/${file} is not what it should be: ${size} bytes")
    endif()
endforeach()

# `cmake --install` and what other projects find: mechwright::analysis, which needs nothing, and
# mechwright::synthesis with its solvers. Headers keep their paths: #include <mechwright/analysis/four_bar.h>.
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/mechwright)
set(header_dir ${CMAKE_INSTALL_INCLUDEDIR}/mechwright)

file(GLOB_RECURSE analysis_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/analysis/*.h)
set(synthesis_headers
    mechanism/cam/cam.h mechanism/cam/motion_program.h mechanism/drawing/body.h mechanism/drawing/figure.h
    mechanism/drawing/moving_design.h
    mechanism/affine.h mechanism/as_linkage.h mechanism/mechanism.h mechanism/quantity.h mechanism/task.h
    mechanism/curve_fit.h mechanism/path_screening.h
    target/function/function_target.h
    target/function/loop_row.h
    problem/by_name.h problem/problem.h problem/reader.h program/assess.h program/number_memory.h program/proof.h
    program/quantity_value.h
    program/result.h program/run_options.h document/document.h solve/solve.h verify/verify.h)
list(TRANSFORM synthesis_headers PREPEND ${PROJECT_SOURCE_DIR}/synthesis/)

target_sources(mechwright_analysis INTERFACE FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${analysis_headers})
target_sources(mechwright_synthesis PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${synthesis_headers})

install(TARGETS mechwright RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
# Where an archive has the libraries. The old kind of path holds for what they need themselves, too.
set_target_properties(mechwright PROPERTIES INSTALL_RPATH "$ORIGIN/../lib/mechwright" BUILD_WITH_INSTALL_RPATH ON)
target_link_options(mechwright PRIVATE -Wl,--disable-new-dtags)
if(TARGET mechwright-bench)
    install(TARGETS mechwright-bench RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
foreach(part analysis synthesis)
    install(TARGETS mechwright_${part} EXPORT mechwright_${part} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
            FILE_SET HEADERS DESTINATION ${header_dir})
    install(EXPORT mechwright_${part} NAMESPACE mechwright:: DESTINATION ${package_dir} FILE mechwright-${part}.cmake)
endforeach()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/mechwrightConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/mechwrightConfig.cmake INSTALL_DESTINATION ${package_dir}
                              NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/mechwrightConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/mechwrightConfig.cmake ${PROJECT_BINARY_DIR}/mechwrightConfigVersion.cmake
        DESTINATION ${package_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/problems DESTINATION ${CMAKE_INSTALL_DATADIR}/mechwright COMPONENT program)

# What shells and man read comes from the program itself.
set(shell_dir ${PROJECT_BINARY_DIR}/shell)
set(shell_files)
foreach(made "mechwright.bash;completion;bash" "_mechwright;completion;zsh" "mechwright.fish;completion;fish"
             "mechwright.1;man-page")
    list(POP_FRONT made shell_file)
    add_custom_command(OUTPUT ${shell_dir}/${shell_file}
                       COMMAND ${CMAKE_COMMAND} -E make_directory ${shell_dir}
                       COMMAND mechwright ${made} > ${shell_dir}/${shell_file}
                       DEPENDS mechwright VERBATIM)
    list(APPEND shell_files ${shell_dir}/${shell_file})
endforeach()
add_custom_target(mechwright_shell ALL DEPENDS ${shell_files})
install(FILES ${shell_dir}/mechwright.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME mechwright COMPONENT program)
install(FILES ${shell_dir}/_mechwright DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions
        COMPONENT program)
install(FILES ${shell_dir}/mechwright.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
        COMPONENT program)
install(FILES ${shell_dir}/mechwright.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)

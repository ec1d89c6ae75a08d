# Copies the libraries that a program or a module needs into a folder, each by the name it is loaded by, with the licences
# of the Debian packages that they are from: what is installed for itself must run where they are not installed. Those
# that every Linux with this C library has are left out.
#
#   cmake -D binary=FILE -D into=FOLDER -P bundle.cmake
cmake_minimum_required(VERSION 3.25)
file(GET_RUNTIME_DEPENDENCIES LIBRARIES ${binary} RESOLVED_DEPENDENCIES_VAR needed
     PRE_EXCLUDE_REGEXES "^(ld-linux.*|libc|libm|libdl|libpthread|librt|libstdc\\+\\+|libgcc_s)[.]so")
file(MAKE_DIRECTORY ${into})
foreach(library IN LISTS needed)
    cmake_path(GET library FILENAME name)
    file(REAL_PATH ${library} real)
    file(COPY_FILE ${real} ${into}/${name})
    string(REGEX REPLACE "^/usr/" "/" in_root ${real})
    list(APPEND files ${real} ${in_root})
endforeach()
find_program(DPKG_QUERY dpkg-query)
if(DPKG_QUERY)
    # Which path of the two a package knows depends on the package: the other is not found, which is no fault.
    execute_process(COMMAND ${DPKG_QUERY} --search ${files} OUTPUT_VARIABLE owners ERROR_QUIET)
    string(REGEX MATCHALL "(^|\n)[^:\n]+:" owners "${owners}")
    list(TRANSFORM owners REPLACE "[\n:]" "")
    list(REMOVE_DUPLICATES owners)
    foreach(owner IN LISTS owners)
        if(EXISTS /usr/share/doc/${owner}/copyright)
            file(COPY_FILE /usr/share/doc/${owner}/copyright ${into}/${owner}.copyright)
        endif()
    endforeach()
endif()

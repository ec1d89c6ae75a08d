# `./bootstrap package`: a Debian package of what `cmake --install` installs. What it needs is found by the linker's own
# records (dpkg-shlibdeps).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The mechwright authors")
set(CPACK_PACKAGE_VENDOR "The mechwright authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The program draws charts by gnuplot and PNG by rsvg-convert where they are there; the Python module needs NumPy.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox, librsvg2-bin, python3, python3-numpy")
# For programs that use the library.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "g++, cmake, libeigen3-dev, libboost-dev, libmpfr-dev, libnlopt-cxx-dev, coinor-libipopt-dev")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Designs four-bar linkages, quick-return drives, disc cams and linkages of any
kind from a small text file: dimensions that meet what is required, verified
over the whole motion, with the global optimum where it can be proved.")
include(CPack)

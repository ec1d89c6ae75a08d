# Run by the test install/wheel: pip makes the wheel from the build that is there, installs it in a fresh virtual
# environment, and that Python uses it. Nothing is fetched: NumPy is the system's.
file(REMOVE_RECURSE ${scratch})
file(MAKE_DIRECTORY ${scratch})

function(run)
    execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(offline --no-index --no-deps --no-cache-dir --disable-pip-version-check)
run(${python} -m pip wheel ${source} ${offline} --no-build-isolation --config-settings=build=${build} -w ${scratch})
file(GLOB wheel ${scratch}/mechwright-*.whl)
run(${python} -m venv --system-site-packages --without-pip ${scratch}/environment)
set(its_python ${scratch}/environment/bin/python)
run(${python} -m pip --python ${its_python} install ${offline} ${wheel})

file(WRITE ${scratch}/use.py [[
import pathlib, sys
import mechwright

assert pathlib.Path(mechwright.__file__).is_relative_to(sys.prefix), mechwright.__file__
result = mechwright.solve(sys.argv[1])
assert result.status == "solved" and result.verify().passed
assert abs(result.design.crank - 34.0997) < 1e-4, result.design
assert "<svg" in result.draw()
its_own = str(pathlib.Path(mechwright.__file__).parent / "lib")
loaded = pathlib.Path("/proc/self/maps").read_text()
for library in ("nlopt_cxx", "ipopt", "lapack", "dmumps_seq", "sqlite3"):
    assert f"{its_own}/lib{library}" in loaded, library
]])
run(${CMAKE_COMMAND} -E chdir ${scratch} ${CMAKE_COMMAND} -E env --unset=PYTHONPATH
    ${its_python} use.py ${source}/problems/four-bar/crank-rocker.toml)

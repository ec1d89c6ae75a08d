"""Makes a wheel of the module, by the hooks that pip calls (PEP 517): CMake builds, what is installed is packed (PEP 427).

    pip wheel . --no-deps                                          in build/release, as ./bootstrap builds
    pip wheel . --no-deps --config-settings=build=FOLDER           in a folder that has been built, or is to be
"""

import base64
import csv
import hashlib
import io
import os
import re
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
import zipfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
PROJECT = tomllib.loads((SOURCE / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def get_requires_for_build_wheel(config_settings=None):
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    build = SOURCE / (config_settings or {}).get("build", "build/release")
    name = f"{PROJECT['name']}-{version()}"
    tag = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{tag}-{tag}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"
    with tempfile.TemporaryDirectory() as folder:
        content = Path(folder)
        install(build, content)
        info = content / f"{name}.dist-info"
        info.mkdir()
        (info / "METADATA").write_text(metadata(), encoding="utf-8")
        (info / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: mechwright\nRoot-Is-Purelib: false\nTag: {tag}\n")
        (info / "LICENSE").write_bytes((SOURCE / "LICENSE").read_bytes())
        pack(content, info / "RECORD", Path(wheel_directory) / f"{name}-{tag}.whl")
    return f"{name}-{tag}.whl"


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("there is no archive of the source: give pip a checkout")


def version():
    return re.search(r"project\(mechwright VERSION ([0-9.]+)", (SOURCE / "CMakeLists.txt").read_text())[1]


def metadata():
    lines = [
        "Metadata-Version: 2.1",
        f"Name: {PROJECT['name']}",
        f"Version: {version()}",
        f"Summary: {PROJECT['description']}",
        f"License: {PROJECT['license']['text']}",
        f"Requires-Python: {PROJECT['requires-python']}",
        *(f"Requires-Dist: {needed}" for needed in PROJECT["dependencies"]),
        "Description-Content-Type: text/markdown",
    ]
    return "\n".join(lines) + "\n\n" + (SOURCE / PROJECT["readme"]).read_text(encoding="utf-8")


def cmake(*arguments):
    subprocess.run(["cmake", *map(str, arguments)], check=True)


def install(build, into):
    """The package and the libraries that it needs, which may not be where it goes."""
    if not (build / "CMakeCache.txt").exists():
        cmake("-S", SOURCE, "-B", build, "-G", "Ninja", "-D", "CMAKE_BUILD_TYPE=Release", "-D", "MECHWRIGHT_TESTS=OFF",
              "-D", f"Python_EXECUTABLE={sys.executable}")
    cmake("--build", build, "--target", "mechwright_python")
    with tempfile.TemporaryDirectory() as prefix:
        cmake("--install", build, "--prefix", prefix, "--component", "python", "--strip")
        [package] = Path(prefix).glob("lib*/python*/*/mechwright")
        package.rename(into / "mechwright")
    module = into / "mechwright" / ("_program" + sysconfig.get_config_var("EXT_SUFFIX"))
    if not module.exists():
        raise RuntimeError(f"{build} was built for another Python than {sys.executable}: give another folder")
    cmake("-D", f"binary={module}", "-D", f"into={into / 'mechwright/lib'}", "-P", SOURCE / "synthesis/cmake/bundle.cmake")


def pack(folder, record, wheel):
    rows = io.StringIO()
    table = csv.writer(rows, lineterminator="\n")
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for file in sorted(path for path in folder.rglob("*") if path.is_file()):
            digest = base64.urlsafe_b64encode(hashlib.sha256(file.read_bytes()).digest()).rstrip(b"=").decode()
            table.writerow([file.relative_to(folder), f"sha256={digest}", file.stat().st_size])
            archive.write(file, file.relative_to(folder))
        table.writerow([record.relative_to(folder), "", ""])
        archive.writestr(os.fspath(record.relative_to(folder)), rows.getvalue())

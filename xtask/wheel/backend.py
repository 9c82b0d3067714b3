"""Builds the wheel with maturin, and with what the package that was just built says of itself: type stubs of the formulas, and their
operations over arrays."""

import sys
import tempfile
import zipfile
from pathlib import Path

import maturin
from maturin import *  # noqa: F403  The other hooks are maturin's.


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        without = Path(folder, maturin.build_wheel(folder, config_settings))
        zipfile.ZipFile(without).extractall(folder)
        sys.path.insert(0, folder)
        import jointproof
        import printing
        import stubs

        printing.write(jointproof)
        stubs.write()
    return maturin.build_wheel(wheel_directory, config_settings, metadata_directory)

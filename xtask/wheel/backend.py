"""Builds the wheel with maturin, and with type stubs of the formulas: what the package that was just built says of itself."""

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
        import stubs

        stubs.write()
    return maturin.build_wheel(wheel_directory, config_settings, metadata_directory)

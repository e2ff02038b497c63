# SPDX-License-Identifier: Apache-2.0
"""For tests that use packages from PyPI: a virtual environment that has them, in build/, made once."""
import os
import pathlib
import subprocess
import sys
import venv

BUILD = pathlib.Path(__file__).resolve().parents[2] / "build"


def enter(name, packages):
    """Goes on in the environment build/`name`, which has `packages`; a change of the list makes it anew."""
    folder = BUILD / name
    python = folder / "bin" / "python"
    stamp = folder / "installed.txt"
    if not stamp.exists() or stamp.read_text() != " ".join(packages):
        venv.create(folder, with_pip=True, clear=True)
        subprocess.run([python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *packages], check=True)
        stamp.write_text(" ".join(packages))
    if os.environ.get("BOUGUER_ENVIRONMENT") != str(folder):
        os.environ["BOUGUER_ENVIRONMENT"] = str(folder)
        os.execv(python, [str(python), *sys.argv])

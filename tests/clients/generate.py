#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Generates the package bouguer_client of openapi.json in this folder, has mypy check submit_job.py against it, and runs that
against the daemon at URL. python.sh calls it.    generate.py URL
"""
import pathlib
import subprocess
import sys

import python_packages

PACKAGES = ["openapi-python-client==0.29.1", "mypy==2.4.1"]


def main():
    python_packages.enter("python-client", PACKAGES)
    tools = pathlib.Path(sys.executable).parent
    for command in (
        [tools / "openapi-python-client", "generate", "--path", "openapi.json", "--config", "generator.json",
         "--output-path", "bouguer_client", "--meta", "none", "--fail-on-warning"],
        # What is wrong within the generated package is between the generator and mypy.
        [tools / "mypy", "--strict", "--follow-imports=silent", "submit_job.py"],
        [sys.executable, "submit_job.py", sys.argv[1]],
    ):
        subprocess.run(command, check=True)


if __name__ == "__main__":
    main()

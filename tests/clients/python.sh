#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Generates a Python package of the description that a daemon serves, has mypy check submit_job.py against it, and runs it
# against the daemon. Needs Python 3.10 or later with venv; the tools go into build/python-client, once.
#
#   tests/clients/python.sh BOUGUER
# shellcheck source=tests/service/daemon.sh
. "$(dirname "$0")/../service/daemon.sh"

start_daemon
cp "$source_dir"/tests/clients/{submit_job.py,generate.py,generator.json} "$work"
cd "$work"
curl -sf -o openapi.json "$url/v1/openapi.json"
PYTHONPATH=$source_dir/tests/support python3 generate.py "$url"
end_daemon TERM

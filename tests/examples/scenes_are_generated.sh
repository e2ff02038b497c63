#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The figures and meshes in client-examples/scenes/lee are what the scripts beside them write.
set -euo pipefail
cd "$(dirname "$0")/../../client-examples/scenes"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
PYTHONDONTWRITEBYTECODE=1 python3 make_meshes.py "$work"
PYTHONDONTWRITEBYTECODE=1 python3 make_figures.py "$work"
for made in "$work"/*; do cmp "$made" "lee/$(basename "$made")"; done

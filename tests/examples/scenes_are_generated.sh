#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The scenes and meshes in the folders of client-examples/scenes are what the scripts beside them write.
set -euo pipefail
cd "$(dirname "$0")/../../client-examples/scenes"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PYTHONDONTWRITEBYTECODE=1
mkdir "$work/lee"
python3 make_meshes.py "$work/lee"
python3 make_figures.py "$work/lee"
python3 make_models.py "$work/lee"
python3 make_colour_scenes.py "$work/colour"
python3 make_textures.py "$work/textures"
python3 make_glass.py "$work/glass"
cd "$work"
for made in */*; do cmp "$made" "$OLDPWD/$made"; done

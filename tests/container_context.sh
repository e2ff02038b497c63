#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The files that the Dockerfile copies are let through by .dockerignore and are all that the build reads.
set -euo pipefail
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
copied=$(sed -n 's|^COPY \([^-].*\) /src/.*|\1|p' Dockerfile | tr ' ' '\n')
while read -r path; do
    grep -Fxq "!$path" .dockerignore || { echo ".dockerignore keeps back $path" >&2; exit 1; }
    cp -r --parents "$path" "$work"
done <<<"$copied"
cd "$work"
# What is compiled must be there to configure; what is put into generated sources, to make those.
cmake --preset release -DBOUGUER_BUILD_TESTS=OFF >/dev/null
generated=$(ninja -C build/release -t targets rule CUSTOM_COMMAND | grep '\.cpp$')
xargs ninja -C build/release >ninja.log <<<"$generated" || { tail -n 3 ninja.log >&2; exit 1; }

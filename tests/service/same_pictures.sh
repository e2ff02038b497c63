#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# For a change that must leave pictures alone: every scene of client-examples/scenes, small, by both integrators, has the
# same bytes from two builds, as EXR and as PNG. Takes a minute; tells of every picture that differs.
#
#   tests/service/same_pictures.sh OLD NEW      two binaries, of before and after
set -euo pipefail
old=$(realpath "${1:?usage: $0 OLD NEW}")
new=$(realpath "${2:?usage: $0 OLD NEW}")
cd "$(dirname "$0")/../../client-examples/scenes"
work=$(mktemp -d "${TMPDIR:-/tmp}/bouguer-pictures.XXXXXX")
trap 'rm -rf "$work"' EXIT

# render BINARY NAME SCENE INTEGRATOR: into NAME.exr and NAME.png
render() {
    "$1" render "$3" --integrator "$4" --resolution 96x72 --samples 3 -o "$work/$2.exr" -o "$work/$2.png" >"$work/said" 2>&1 ||
        { echo "$1 does not render $3 ($4): $(tail -n 1 "$work/said")" >&2; return 1; }
}

pictures=0
wrong=()
while read -r scene; do
    for integrator in hall rgb; do
        pictures=$((pictures + 2))
        if ! render "$old" old "$scene" "$integrator" || ! render "$new" new "$scene" "$integrator"; then
            wrong+=("$scene $integrator")
            continue
        fi
        for format in exr png; do
            cmp -s "$work/old.$format" "$work/new.$format" || wrong+=("$scene $integrator $format")
        done
    done
done < <(find . -name '*.json' | sort)

[ "$pictures" -gt 0 ] || { echo "no scenes found" >&2; exit 1; }
if [ ${#wrong[@]} -gt 0 ]; then
    printf 'differs: %s\n' "${wrong[@]}" >&2
    echo "${#wrong[@]} of $pictures pictures differ" >&2
    exit 1
fi
echo "$pictures pictures, every one with the same bytes"

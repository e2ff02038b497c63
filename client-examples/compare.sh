#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Renders two scenes or jobs on a Bouguer daemon with submit.sh, then tells how different their pictures look: CIEDE2000
# as JSON, and a map of it as PNG.
#
#   client-examples/compare.sh A.json B.json [MAP.png] [QUERY]     e.g. 'exposure=2&white=A'; writes MAP.png (compare.png)
#
# Environment: that of submit.sh. Needs bash and curl. The pictures must have one size; job A says how both are seen.
set -euo pipefail
if [ ! -r "${1:-}" ] || [ ! -r "${2:-}" ]; then
    sed -n '3,8s/^# \{0,1\}//p' "$0" >&2
    exit 2
fi
map=${3:-compare.png}
query=${4:+&$4}
url=${BOUGUER_URL:-http://127.0.0.1:8080}
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=client-examples/ask.sh
source "$here/ask.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# render FILE: prints the job's id.
render() { "$here/submit.sh" "$1" "$work/picture" | tee /dev/stderr | sed -n 's/^job //p'; }

a=$(render "$1")
b=$(render "$2")
ask "$work/figures" "$url/v1/compare?a=$a&b=$b$query"
cat "$work/figures"
echo
[ "$code" = 200 ] || exit 1
ask "$work/map" "$url/v1/compare.png?a=$a&b=$b$query"
[ "$code" = 200 ] || refuse "There is no map" "$work/map"
cp "$work/map" "$map"

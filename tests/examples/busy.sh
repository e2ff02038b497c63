#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A daemon that is busy is asked again when it says so and under the same key; a refusal is final, and shown.
set -euo pipefail
cd "$(dirname "$0")"
examples=../../client-examples
work=$(mktemp -d)
python3 busy_daemon.py "$work/port" "$work/diary" &
daemon=$!
trap 'kill "$daemon"; rm -rf "$work"' EXIT
for _ in $(seq 100); do
    [ ! -s "$work/port" ] || break
    sleep 0.1
done
url="http://127.0.0.1:$(<"$work/port")"

# expect_patience COMMAND ...: three attempts, no two of them less than a second apart.
expect_patience() {
    : >"$work/diary"
    if "$@" >"$work/output" 2>&1; then
        echo "$1 took a refusal for a success" >&2
        return 1
    fi
    grep -q /the/place "$work/output"
    [ "$(wc -l <"$work/diary")" -eq 3 ]
    [ "$(cut -d' ' -f1 "$work/diary" | sort -u | grep -Ec '^[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$')" -eq 1 ]
    awk 'NR > 1 && $2 < 1000 { print "asked again after " $2 " ms"; exit 1 }' "$work/diary"
}

export BOUGUER_URL=$url
expect_patience "$examples/submit.sh" "$examples/scenes/grey-card.json" "$work/out"
expect_patience "$examples/submit.py" --url "$url" --out "$work/out" "$examples/scenes/grey-card.json"

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# compare.sh tells how two pictures differ, draws the map, and passes on what the daemon refuses.
set -euo pipefail
cd "$(dirname "$0")"
bouguer=$1 examples=../../client-examples
# shellcheck source=tests/examples/daemon.sh
source daemon.sh
start_daemon "$bouguer"
card=$examples/scenes/grey-card.json

BOUGUER_URL=$url "$examples/compare.sh" "$card" "$card" "$work/map.png" 'exposure=0.5&white=A' >"$work/figures"
grep -q '"maximum":0.0' "$work/figures"
grep -q '"exposure":0.5,"adaptation":"cat16"' "$work/figures"
expect_png "$work/map.png"

if BOUGUER_URL=$url "$examples/compare.sh" "$card" "$card" "$work/no.png" 'exposure=dim' >"$work/refusal"; then
    echo "compare.sh took a refusal for a success" >&2
    exit 1
fi
grep -q 'query parameter exposure' "$work/refusal"

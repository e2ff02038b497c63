#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# quickstart.sh leaves picture, OpenEXR and report, and no daemon behind. One sample a pixel: the way is what is tested.
set -euo pipefail
cd "$(dirname "$0")"
# shellcheck source=tests/examples/daemon.sh
source daemon.sh
BOUGUER_SAMPLES=1 BOUGUER_OUT="$work/out" ../../client-examples/quickstart.sh | tee "$work/log"
expect_png "$work/out/figure-4d.png"
expect_exr "$work/out/figure-4d.exr"
[ -s "$work/out/figure-4d.report.json" ]
port=$(sed -n 's|^listening on http://127.0.0.1:||p' "$work/log")
if curl -s -o /dev/null "http://127.0.0.1:$port/livez"; then
    echo "the daemon still answers on port $port" >&2
    exit 1
fi

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# From a fresh clone to a picture, on Debian 12 or 13, as root or with sudo: installs what is missing, builds, starts
# the daemon on a free port, renders the seed paper's figure 4(d) over HTTP and stops the daemon again. A second run
# neither installs nor builds. Environment: BOUGUER_SAMPLES a pixel (16), BOUGUER_OUT, the folder for what comes of it.
set -euo pipefail
cd "$(dirname "$0")/.."
out=${BOUGUER_OUT:-quickstart-out}
scene=client-examples/scenes/lee/figure-4d.json
export BOUGUER_SAMPLES=${BOUGUER_SAMPLES:-16}

echo "1/4 Packages"
client-examples/install-dependencies.sh build

echo "2/4 Build (some minutes the first time)"
[ -f build/release/build.ninja ] || cmake --preset release -DBOUGUER_BUILD_TESTS=OFF >/dev/null
cmake --build --preset release --target bouguer
bouguer=build/release/server/bouguer

echo "3/4 Daemon"
mkdir -p "$out"
data=$(mktemp -d "$out/data.XXXXXX")
daemon=
stop_daemon() {
    if [ -n "$daemon" ]; then
        kill -TERM "$daemon" 2>/dev/null || true
        wait "$daemon" 2>/dev/null || true
    fi
    rm -rf "$data"
}
trap stop_daemon EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP
"$bouguer" serve --listen 127.0.0.1:0 --data "$data" --assets "$(dirname "$scene")" >"$out/daemon.log" 2>&1 &
daemon=$!
for _ in $(seq 100); do
    [ ! -s "$data/port" ] || break
    kill -0 "$daemon" 2>/dev/null || { daemon=; echo "The daemon did not start:" >&2; cat "$out/daemon.log" >&2; exit 1; }
    sleep 0.1
done
[ -s "$data/port" ] || { echo "The daemon names no port; see $out/daemon.log" >&2; exit 1; }
BOUGUER_URL="http://127.0.0.1:$(<"$data/port")"
export BOUGUER_URL
echo "listening on $BOUGUER_URL"

echo "4/4 Render $scene, $BOUGUER_SAMPLES samples a pixel"
client-examples/submit.sh "$scene" "$out/figure-4d"

cat <<END

Here they are:
  $out/figure-4d.png           the picture
  $out/figure-4d.exr           linear light, for further work
  $out/figure-4d.report.json   how large its error is, against time; its health and plan

What to try next:
  $bouguer render client-examples/scenes/lee/figure-4a.json --integrator rgb -o rgb.png      the same scene by RGB triples
  $bouguer serve --data my-data      and then   client-examples/submit.py client-examples/scenes/amber-ball.json
  $bouguer plan $scene               what the scene needs and what is left out
  $bouguer --help
END

# shellcheck shell=bash
# SPDX-License-Identifier: Apache-2.0
# For the tests of this folder: a daemon on a free port and a folder that goes with the test. Sourced.
#
# Sets: bouguer (the binary, $1 of the script), work (the folder), source_dir. start_daemon sets url and daemon.
set -euo pipefail
bouguer=$(realpath "${1:?usage: $0 BOUGUER}")
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d "${TMPDIR:-/tmp}/bouguer-service.XXXXXX")
daemon=
url=

clean_up() {
    if [ -n "$daemon" ]; then
        kill -KILL "$daemon" 2>/dev/null || true
        wait "$daemon" 2>/dev/null || true
    fi
    rm -rf "$work"
}
trap clean_up EXIT

fail() {
    echo "FAILED: $*" >&2
    [ ! -f "$work/log" ] || tail -n 30 "$work/log" >&2
    exit 1
}

# start_daemon [option of serve ...]: on $work/data, with two threads; at $port if that is set, else at any free one.
start_daemon() {
    rm -f "$work/data/port"
    "$bouguer" serve --listen "127.0.0.1:${port:-0}" --data "$work/data" --assets "$source_dir/client-examples/scenes/lee" \
        --threads 2 "$@" >>"$work/out" 2>>"$work/log" &
    daemon=$!
    for _ in $(seq 200); do
        if [ -s "$work/data/port" ]; then
            url="http://127.0.0.1:$(<"$work/data/port")"
            return
        fi
        kill -0 "$daemon" 2>/dev/null || break
        sleep 0.05
    done
    fail "the daemon does not start"
}

# end_daemon SIGNAL: sends it and waits; sets exit_code.
# shellcheck disable=SC2034 # for the scripts that source this
end_daemon() {
    kill "-$1" "$daemon"
    exit_code=0
    wait "$daemon" 2>/dev/null || exit_code=$?
    daemon=
}

# value_of KEY JSON: of the first text member of that name.
value_of() { sed -n "s/.*\"$1\":\"\([^\"]*\)\".*/\1/p" <<<"$2" | head -n 1; }

# submit FILE [curl option ...]: prints the job's id.
submit() {
    local file=$1 answer
    shift
    answer=$(curl -sf -H 'Content-Type: application/json' --data-binary "@$file" "$@" "$url/v1/jobs") || return 1
    value_of id "$answer"
}

state_of() { value_of state "$(curl -sf "$url/v1/jobs/$1")"; }

# wait_for_state ID STATE
wait_for_state() {
    local state='' deadline=$((SECONDS + 100))
    while [ $SECONDS -lt $deadline ]; do
        state=$(state_of "$1")
        [ "$state" != "$2" ] || return 0
        case $state in done | failed | cancelled) fail "job $1 is $state, not $2: $(curl -s "$url/v1/jobs/$1")" ;; esac
        sleep 0.05
    done
    fail "job $1 stays $state and does not become $2"
}

# small_job SAMPLES SEED WIDTH HEIGHT: a job document on standard output.
small_job() {
    cat <<END
{"format":"bouguer-job/1","seed":$2,"stop":{"samples":$1},
 "scene":{"format":"bouguer-scene/1","name":"ball",
  "camera":{"type":"perspective","from":[0,1,5],"at":[0,1,0],"up":[0,1,0],"fov_deg":40,"resolution":[$3,$4]},
  "materials":{"glass":{"type":"hall","reflectance":1,"transmittance":1,"k_sr":0.1,"k_st":0.9,"n":20,"ior":1.3},
   "grey":{"type":"hall","reflectance":{"srgb":[0.8,0.6,0.4]},"k_sr":1,"n":1}},
  "objects":[{"name":"ball","shape":{"type":"sphere","center":[0,1,0],"radius":1},"material":"glass"},
   {"name":"floor","shape":{"type":"plane","point":[0,0,0],"normal":[0,1,0]},"material":"grey"}],
  "lights":[{"type":"directional","direction":[-1,-2,-1],"irradiance":"D65"}]}}
END
}

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# submit.sh and submit.py live through a kill -9 of the daemon and some seconds without it: before they submit, when the
# answer to the submission or to an upload is lost, during the render, and in the middle of a download. They end well, with
# the pictures of an undisturbed run, and one submission stays one job.
#
#   tests/service/clients_survive.sh BOUGUER [SECONDS [CLIENTS]]     3 s by default; 30 for the long form; CLIENTS: a folder
# shellcheck source=tests/service/daemon.sh
. "$(dirname "$0")/daemon.sh"
outage_s=${2:-3}
clients=${3:-$source_dir/client-examples}
proxy=
trap 'kill $(jobs -p) 2>/dev/null || true; clean_up' EXIT

small_job 64 1 160 120 >"$work/job.json"
"$bouguer" render "$work/job.json" -o "$work/reference.exr" >/dev/null
"$bouguer" render "$work/job.json" -o "$work/reference.png" >/dev/null

# start_clients URL: sets the process ids `shell` and `python`.
# shellcheck disable=SC2034 # expect_pictures reads them by name
start_clients() {
    rm -f "$work"/shell.* "$work"/python.*
    BOUGUER_URL=$1 "$clients/submit.sh" "$work/job.json" "$work/shell" >"$work/shell.log" 2>&1 &
    shell=$!
    "$clients/submit.py" --url "$1" --out "$work/python" "$work/job.json" >"$work/python.log" 2>&1 &
    python=$!
}

# expect_pictures MOMENT: both clients end well.
faults=0
expect_pictures() {
    local name
    for name in shell python; do
        if wait "${!name}" && cmp "$work/reference.png" "$work/$name.png" && cmp "$work/reference.exr" "$work/$name.exr" \
            && [ -s "$work/$name.report.json" ]; then
            echo "$name: well after an outage $1"
        else
            echo "$name: NOT well after an outage $1:" >&2
            tail -n 5 "$work/$name.log" >&2
            faults=$((faults + 1))
        fi
    done
}

come_back() {
    sleep "$outage_s" # the outage itself
    start_daemon
}

# start_proxy PATTERN BYTES: see cutting_proxy.py; sets proxy_url.
start_proxy() {
    rm -f "$work"/proxy.*
    python3 "$source_dir/tests/service/cutting_proxy.py" "$port" "$work/proxy.port" "$work/proxy.cuts" "$1" "$2" &
    proxy=$!
    wait_until test -s "$work/proxy.port"
    proxy_url="http://127.0.0.1:$(<"$work/proxy.port")"
}

end_proxy() {
    kill "$proxy"
    wait "$proxy" 2>/dev/null || true
}

# wait_until COMMAND ...: at most a minute.
wait_until() {
    local deadline=$((SECONDS + 60))
    until "$@" >/dev/null 2>&1; do
        [ $SECONDS -lt $deadline ] || fail "it took too long until: $*"
        sleep 0.02
    done
}
some_job_runs() { curl -sf "$url/v1/jobs?state=running" | grep -q '"id"'; }
answers_are_cut() { [ "$(wc -l <"$work/proxy.cuts")" -eq "$1" ]; }
number_of_jobs() { curl -sf "$url/v1/jobs?limit=100" | grep -o '"state":' | wc -l; }

start_daemon
port=${url##*:}
end_daemon KILL
start_clients "$url"
come_back
expect_pictures "before the submission"

start_clients "$url"
wait_until some_job_runs
end_daemon KILL
come_back
expect_pictures "during the render"

before=$(number_of_jobs)
start_proxy 'POST /v1/jobs ' 0
start_clients "$proxy_url"
wait_until answers_are_cut 2
end_daemon KILL
touch "$work/proxy.cuts.over"
come_back
expect_pictures "after which the submission was not answered"
made=$(($(number_of_jobs) - before))
[ "$made" -eq 2 ] || { echo "two submissions became $made jobs" >&2; faults=$((faults + 1)); }
end_proxy

start_proxy 'GET /v1/jobs/[^/]*/image.exr ' 5000
start_clients "$proxy_url"
wait_until answers_are_cut 2
end_daemon KILL
touch "$work/proxy.cuts.over"
come_back
expect_pictures "in the middle of a download"
end_proxy

# Only submit.py uploads.
printf 'ply\nformat ascii 1.0\nelement vertex 3\n%s\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n%s\n' \
    $'property float x\nproperty float y\nproperty float z' $'-1 0 0\n1 0 0\n0 2 0\n3 0 1 2' >"$work/triangle.ply"
sed 's|"shape":{"type":"sphere"[^}]*}|"shape":{"type":"file","path":"triangle.ply"}|' "$work/job.json" >"$work/upload.json"
grep -q triangle.ply "$work/upload.json"
start_proxy 'PUT /v1/assets/' 0
"$clients/submit.py" --url "$proxy_url" --out "$work/python" "$work/upload.json" >"$work/python.log" 2>&1 &
python=$!
wait_until answers_are_cut 1
end_daemon KILL
touch "$work/proxy.cuts.over"
come_back
wait "$python" || fail "submit.py did not upload again: $(tail -n 5 "$work/python.log")"
echo "python: well after an outage after which the upload was not answered"
"$clients/submit.py" --url "$url" --out "$work/undisturbed" "$work/upload.json" >/dev/null
cmp "$work/undisturbed.exr" "$work/python.exr"
end_proxy

end_daemon TERM
[ "$faults" -eq 0 ] || fail "$faults faults"

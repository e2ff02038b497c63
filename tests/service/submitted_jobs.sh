# shellcheck shell=bash
# SPDX-License-Identifier: Apache-2.0
# The jobs of endurance.sh and power_loss.sh: what is posted, and what must have become of it. Sourced after daemon.sh.

here=$(dirname "${BASH_SOURCE[0]}")
submitters=

# make_kinds FOLDER: KIND.json, from a millisecond to a second of work, with KIND.exr and KIND.png.
make_kinds() {
    local job
    mkdir "$1"
    small_job 1 1 16 12 >"$1/tiny.json"
    small_job 1 2 24 24 >"$1/tiny-too.json"
    small_job 16 3 40 30 >"$1/small.json"
    small_job 64 4 64 48 >"$1/some.json"
    small_job 300 5 96 72 >"$1/long.json"
    small_job 1 6 512 256 >"$1/wide.json"
    # Its mesh is a file, which is opened when it is posted and again when it is begun.
    small_job 8 7 40 30 | sed 's|"type":"sphere"[^}]*}|"type":"file","path":"gem.obj"}|' >"$1/mesh.json"
    cp "$source_dir/client-examples/scenes/lee/gem.obj" "$1/"
    for job in "$1"/*.json; do
        "$bouguer" render "$job" -o "${job%.json}.exr" -o "${job%.json}.png" >"$work/out" 2>&1 || fail "$job: $(<"$work/out")"
    done
}

# start_submitters SEED: to the ledger $work/ledger; sets submitters.
start_submitters() {
    python3 "$here/submitters.py" --port-file "$work/data/port" --jobs "$work/jobs" --ledger "$work/ledger" --seed "$1" &
    submitters=$!
}

# end_submitters: once they have ended what they began; their exit code.
end_submitters() {
    local code=0
    kill -TERM "$submitters"
    wait "$submitters" || code=$?
    submitters=
    return $code
}

# check_jobs: on a daemon that is left alone; the exit code and last line of check_jobs.py.
check_jobs() {
    python3 "$here/check_jobs.py" --port-file "$work/data/port" --ledger "$work/ledger" --jobs "$work/jobs" --kept "$work/kept"
}

# check_leftovers: on a daemon that has ended, after check_jobs: what is on the disk belongs to jobs that are there.
check_leftovers() {
    local left result name
    left=$(find "$work/disk/data" -name '*part*' -o -name '*.tmp' -o -name 'port')
    for result in "$work/disk/data/results"/*; do
        name=${result##*/}
        [ ! -e "$result" ] || grep -qx "${name:0:36}" "$work/kept" || left+=" $result"
    done
    [ -z "$left" ] || fail "left over: $left"
}

# shellcheck shell=bash
# SPDX-License-Identifier: Apache-2.0
# The kinds of job of endurance.sh and power_loss.sh, and what an undisturbed run makes of them. Sourced after daemon.sh.

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

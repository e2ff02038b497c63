# shellcheck shell=bash
# SPDX-License-Identifier: Apache-2.0
# What endurance.sh does to a running daemon. Sourced after daemon.sh; every function leaves a daemon that is free of
# faults. A daemon that died of its own ends the test; a lie of /readyz is counted in `untrue`, so that one run tells all.
#
# Random numbers are those of RANDOM, so that its seed gives the same disturbances again.
strace_pid=
untrue=0

# random N: prints 0 .. N-1. Not for a subshell: there RANDOM would begin at the same place each time.
random() { random=$((RANDOM % $1)); }
# pause LONGEST_MS: a random time.
pause() {
    random "$1"
    sleep "$(printf '%d.%03d' $((random / 1000)) $((random % 1000)))"
}

expect_alive() { grep -q '^State:[[:space:]]*[^ZX]' "/proc/$daemon/status" || fail "the daemon died of its own $1"; }

# expect_ready STATUS WHEN: /readyz comes to say so. The time is that of a hang, not of a good answer.
expect_ready() {
    local status='' deadline=$((SECONDS + 30))
    while [ $SECONDS -lt $deadline ]; do
        status=$(curl -s -o "$work/ready" -m 5 -w '%{http_code}' "$url/readyz") || status=none
        [ "$status" != "$1" ] || return 0
        sleep 0.1
    done
    untrue=$((untrue + 1))
    echo "UNTRUE: /readyz says $status and not $1 $2: $(cat "$work/ready" 2>/dev/null)"
}

# --- the process

# unfinished: prints the ids of the jobs that are not at rest, one a line.
unfinished() {
    local state page
    for state in queued running; do
        page=$(curl -sf --retry 5 "$url/v1/jobs?limit=100&state=$state") || return
        grep -o '"id":"[^"]*"' <<<"$page" | cut -d '"' -f 4 || true # none is no failure
    done
}

# settle: every job that is not at rest now ends before this returns.
settle() {
    local ids id state deadline=$((SECONDS + 60))
    ids=$(unfinished) || fail "the daemon does not list its jobs"
    for id in $ids; do
        while state=$(state_of "$id" || true) && [[ ! $state =~ ^(done|failed|cancelled)$ ]] && is_there "$id"; do
            if [ $SECONDS -ge $deadline ]; then
                untrue=$((untrue + 1))
                echo "STUCK: job $id stays ${state:-unseen}"
                return
            fi
            sleep 0.1
        done
    done
}

# is_there ID: as far as the daemon says; somebody may have removed it.
is_there() { [ "$(curl -s -o /dev/null -w '%{http_code}' "$url/v1/jobs/$1")" != 404 ]; }

# A job whose third begin has no end is given up by the daemon, rightly: so no job is killed more than twice.
kills_since_settled=0
count_kill() {
    if [ $kills_since_settled -ge 2 ]; then
        settle
        kills_since_settled=0
    fi
    kills_since_settled=$((kills_since_settled + 1))
}

kill_daemon() {
    end_daemon KILL
    [ "$exit_code" -eq 137 ] || fail "the daemon died of its own, exit code $exit_code, before it was killed"
}

do_kill() {
    count_kill
    pause 1000
    kill_daemon
    start_daemon
}

do_restart() {
    pause 500
    end_daemon TERM
    [ "$exit_code" -eq 0 ] || fail "exit code $exit_code after SIGTERM"
    start_daemon
}

do_freeze() {
    kill -STOP "$daemon"
    pause 1500
    kill -CONT "$daemon"
}

# --- the disk: $work/disk is a small file system of its own

fill_disk() { dd if=/dev/zero of="$work/disk/filler" bs=64K status=none 2>/dev/null || true; }
free_disk() { rm "$work/disk/filler"; }

do_full_disk() {
    fill_disk
    expect_ready 503 "on a full disk"
    pause 1000
    free_disk
    expect_ready 200 "with room on the disk again"
}

do_kill_on_full_disk() {
    count_kill
    fill_disk
    pause 1000
    kill_daemon
    free_disk
    start_daemon
}

# --- system calls that fail

# strace_daemon CALLS FAULT: from now on, until end_strace; see "Tampering" in strace(1).
strace_daemon() {
    strace -qq -f -o /dev/null -p "$daemon" -e "trace=$1" -e "inject=$1:$2" 2>>"$work/strace" &
    strace_pid=$!
    until grep -q '^TracerPid:[[:space:]]*[1-9]' "/proc/$daemon/status"; do
        kill -0 "$strace_pid" 2>/dev/null || fail "strace does not attach: $(tail -n 1 "$work/strace")"
        sleep 0.02
    done
}

end_strace() {
    kill -INT "$strace_pid"
    wait "$strace_pid" || true
    strace_pid=
}

# inject CALLS FAULT: for a moment; work goes on afterwards.
inject() {
    strace_daemon "$1" "$2"
    pause 1500
    expect_alive "while $1 failed with $2"
    end_strace
    expect_ready 200 "after $1 failed with $2"
}

# What is written to or made of a file; not write(2), which wakes threads too.
do_failing_calls() {
    local -a calls=("fsync,fdatasync" pwrite64 "rename,renameat,renameat2" "mkdir,mkdirat" "unlink,unlinkat,rmdir" openat ftruncate)
    local -a errors=(EIO ENOSPC)
    local call first step error
    random ${#calls[@]}; call=${calls[random]}
    random ${#errors[@]}; error=${errors[random]}
    [ "$call" != openat ] || error=EMFILE
    random 5; first=$((random + 1))
    random 6; step=$((random + 1))
    inject "$call" "error=$error:when=$first+$step"
}

# Nothing can be stored, and the daemon says so.
do_no_sync() {
    local error=EIO
    random 2; [ $random -eq 0 ] || error=ENOSPC
    strace_daemon fsync,fdatasync "error=$error"
    expect_ready 503 "while every fsync fails with $error"
    pause 500
    expect_alive "while every fsync failed"
    end_strace
    expect_ready 200 "when fsync works again"
}

# --- descriptors and clients

# slow_clients [option ...]: of slow_clients.py, with a picture to read
slow_clients() {
    python3 "$here/slow_clients.py" --port-file "$work/data/port" --job "$big_job" "$@"
}

do_slow_clients() {
    slow_clients --livez && return
    untrue=$((untrue + 1))
}

do_no_descriptors() {
    local open=("/proc/$daemon/fd"/*) hard
    hard=$(prlimit --pid "$daemon" --nofile --output HARD --noheadings)
    prlimit --pid "$daemon" --nofile="$((${#open[@]} + 3)):"
    slow_clients --each 20 --seconds 1 || true
    expect_alive "without descriptors"
    prlimit --pid "$daemon" --nofile="${hard// /}:"
    expect_ready 200 "with descriptors again"
}

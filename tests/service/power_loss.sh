#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The power fails at random moments: what was acknowledged is there afterwards, with the right bits. And the control: a
# daemon whose syncs do nothing is seen to lose by the same rounds, or they would test nothing.
#
#   tests/service/power_loss.sh BOUGUER SLOPPY_SYNC.so [ROUNDS [SEED]]     3 rounds by default
#
# The data folder is on a file system (ext4) in an image of its own. At the cut the daemon is killed and the image copied as
# it is: what the kernel has not been told to write, and has not written by itself, is not in it; the copy is the disk of the
# next round. Each control swallows the syncs of one part by sloppy_sync.cpp: those of the job store, which is what
# SQLite's synchronous = OFF does, and those of the results.
#
# Limits: a disk that loses what it says it has written, or writes in another order, is not played; ext4 writes names with
# the sync of any file, so a forgotten sync of a folder alone may go unseen. Needs root and loop devices (exit code 77).
# shellcheck source=tests/service/daemon.sh
. "$(dirname "$0")/daemon.sh"
# shellcheck source=tests/service/submitted_jobs.sh
. "$(dirname "$0")/submitted_jobs.sh"
# shellcheck source=tests/service/disturbances.sh
. "$(dirname "$0")/disturbances.sh"
sloppy_sync=$(realpath "${2:?usage: $0 BOUGUER SLOPPY_SYNC.so [ROUNDS [SEED]]}")
rounds=${3:-3}
seed=${4:-$((SRANDOM % 100000))}
RANDOM=$seed

# What a run leaves when it ends in the middle.
end_run() {
    [ -z "$submitters" ] || kill -KILL "$submitters" 2>/dev/null || true
    [ -z "$daemon" ] || { kill -KILL "$daemon" && wait "$daemon"; } 2>/dev/null || true
    daemon=
    ! mountpoint -q "$work/disk" || umount -l "$work/disk"
}
trap 'end_run; clean_up' EXIT

# The kernel writes by itself after five seconds: not here.
insert_disk() { mount -o loop,commit=600 "$work/disk.img" "$work/disk" 2>"$work/said"; }

new_disk() {
    rm -f "$work/disk.img"
    truncate -s 64M "$work/disk.img"
    mkfs.ext4 -q -F "$work/disk.img" 2>"$work/said" && insert_disk
}

cut_power() {
    kill_daemon
    cp --sparse=always "$work/disk.img" "$work/cut.img"
    umount "$work/disk"
    mv "$work/cut.img" "$work/disk.img"
    insert_disk || fail "the file system did not survive: $(<"$work/said")"
}

# lose_power ROUNDS [option of serve ...]: on a new disk; the exit code and last line of check_jobs.
lose_power() {
    local rounds=$1
    shift
    new_disk
    mkdir "$work/disk/data"
    start_daemon "$@"
    start_submitters "$seed"
    for _ in $(seq "$rounds"); do
        count_kill
        sleep 0.5
        pause 1500
        cut_power
        mkdir -p "$work/disk/data" # a power cut in the first moments
        start_daemon "$@"
    done
    end_submitters || true
    check_jobs
}

if ! command -v mkfs.ext4 >/dev/null || ! mkdir "$work/disk" || ! new_disk; then
    echo "SKIPPED: power loss needs root, loop devices and mkfs.ext4: $(cat "$work/said" 2>/dev/null)"
    exit 77
fi
umount "$work/disk"
ln -s disk/data "$work/data"
make_kinds "$work/jobs"

echo "seed $seed, $rounds rounds"
lose_power "$rounds" || fail "power was lost, and more than that; seed $seed"
end_daemon TERM
check_leftovers
umount "$work/disk"

# control PART: a run without the syncs of what has PART in its path, by a daemon that goes on after a loss that it sees.
# A shell of its own, which may fail.
control() (
    trap end_run EXIT
    cat >"$work/sloppy" <<END
#!/bin/sh
LD_PRELOAD='$sloppy_sync' SLOPPY_SYNC='$1' exec '$bouguer' "\$@"
END
    chmod +x "$work/sloppy"
    bouguer=$work/sloppy
    lose_power 1 --accept-loss
)
for part in jobs.sqlite results; do
    ! control "$part" >"$work/control" 2>&1 || fail "without the syncs of $part nothing was lost"
    grep ' acknowledged jobs$' "$work/control" >"$work/counts" || fail "the control did not end: $(<"$work/control")"
    echo "control, without the syncs of $part: $(<"$work/counts")"
done

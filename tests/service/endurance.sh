#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A daemon that is killed, restarted, frozen, left without disk and descriptors, whose system calls fail and whose clients
# hold back, while jobs of many kinds are posted, cancelled and deleted: at the end every acknowledged job is compared with
# an undisturbed run. Nothing may be lost, stuck, doubled or have wrong bits, and nothing may be left over on the disk.
#
#   tests/service/endurance.sh BOUGUER [ROUNDS [SEED]]      20 rounds by default, some two minutes; any number as a soak
#
# The seed is printed and gives the same jobs and disturbances again (not the same moments: those are the machine's). As
# root the data folder is a small file system of its own, which is filled; without, that is left out and said, and so are
# failing system calls where strace may not trace.
# shellcheck source=tests/service/daemon.sh
. "$(dirname "$0")/daemon.sh"
# shellcheck source=tests/service/submitted_jobs.sh
. "$(dirname "$0")/submitted_jobs.sh"
# shellcheck source=tests/service/disturbances.sh
. "$(dirname "$0")/disturbances.sh"
rounds=${2:-20}
seed=${3:-$((SRANDOM % 100000))}
RANDOM=$seed
# What nobody expects to fail must not end the test without a word.
set -o errtrace
trap 'echo "FAILED: $BASH_COMMAND" >&2' ERR
left=()

leave() {
    [ -z "$strace_pid" ] || kill "$strace_pid" 2>/dev/null || true
    [ -z "$submitters" ] || kill -KILL "$submitters" 2>/dev/null || true
    [ -z "$daemon" ] || kill -CONT "$daemon" 2>/dev/null || true
    ! mountpoint -q "$work/disk" || umount -l "$work/disk"
    clean_up
}
trap leave EXIT

# What is dealt out, as far as it can be done here.
deck=(do_kill do_kill do_restart do_freeze do_slow_clients do_no_descriptors)
mkdir -p "$work/disk"
if mount -t tmpfs -o size=48m bouguer-endurance "$work/disk" 2>/dev/null; then
    deck+=(do_full_disk do_kill_on_full_disk)
else
    echo "SKIPPED: filling the disk, which needs root to mount a file system"
fi
if strace -o /dev/null -e trace=none true 2>/dev/null; then
    deck+=(do_failing_calls do_failing_calls do_failing_calls do_no_sync)
else
    echo "SKIPPED: failing system calls, which need strace and the right to trace"
fi
mkdir "$work/disk/data"
ln -s disk/data "$work/data"

make_kinds "$work/jobs"
echo "seed $seed, $rounds rounds"
start_daemon
big_job=$(submit "$work/jobs/wide.json" -H "Idempotency-Key: big")
echo "{\"kind\":\"wide\",\"key\":\"big\",\"id\":\"$big_job\",\"acknowledged\":\"submit\"}" >"$work/ledger-big"
wait_for_state "$big_job" "done"
start_submitters "$seed"

for round in $(seq "$rounds"); do
    # Two a round; the deck is shuffled anew whenever it has been dealt out.
    dealt=
    for _ in 1 2; do
        [ ${#left[@]} -gt 0 ] || left=("${deck[@]}")
        random ${#left[@]}
        disturbance=${left[random]}
        unset "left[random]"
        left=("${left[@]}")
        dealt+=" ${disturbance#do_}"
        $disturbance
        expect_alive "after $disturbance"
    done
    echo "round $round:$dealt"
done

# Left alone, everything comes to rest.
submitters_said=0 jobs_said=0
end_submitters || submitters_said=$?
cat "$work/ledger-big" >>"$work/ledger"
check_jobs || jobs_said=$?
expect_ready 200 "at the end"
[ "$jobs_said$submitters_said$untrue" = 000 ] || fail "see above; the seed was $seed"
end_daemon TERM
[ "$exit_code" -eq 0 ] || fail "exit code $exit_code after the last SIGTERM"
check_leftovers
echo "$rounds rounds, nothing left over"

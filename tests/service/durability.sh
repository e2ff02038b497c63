#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# kill -9 at random moments: every acknowledged job ends as done, with the bytes of an undisturbed run.
#
#   tests/service/durability.sh BOUGUER [ROUNDS]     3 rounds by default; 200 for the long form
# shellcheck source=tests/service/daemon.sh
. "$(dirname "$0")/daemon.sh"
rounds=${2:-3}

# Four kinds of job, so that what is queued, running and finished at a kill differs. All are short: one that is killed three
# times is taken for the cause and fails, and that is what crash_loop.sh is for.
declare -A expected
for kind in 1 2 3 4; do
    small_job $((kind * kind * 4)) "$kind" 40 30 >"$work/job-$kind.json"
    "$bouguer" render "$work/job-$kind.json" -o "$work/reference.exr" >/dev/null
    expected[$kind]=$(sha256sum <"$work/reference.exr")
done

jobs=()  # "kind id" of what was acknowledged
for round in $(seq "$rounds"); do
    start_daemon
    for kind in 1 2 3 4; do
        if id=$(submit "$work/job-$kind.json" -H "Idempotency-Key: $round-$kind"); then jobs+=("$kind $id"); fi
    done
    sleep "0.$((RANDOM % 6))$((RANDOM % 10))"
    end_daemon KILL
done
[ "${#jobs[@]}" -gt 0 ] || fail "no job was acknowledged, so nothing was tested"

start_daemon
for job in "${jobs[@]}"; do
    read -r kind id <<<"$job"
    wait_for_state "$id" "done"
    [ "$(curl -sf "$url/v1/jobs/$id/image.exr" | sha256sum)" = "${expected[$kind]}" ] || fail "job $id differs"
done
again=$(submit "$work/job-1.json" -H "Idempotency-Key: 1-1")
[ "1 $again" = "${jobs[0]}" ] || fail "the idempotency key was lost"
end_daemon TERM
echo "$rounds rounds, ${#jobs[@]} acknowledged jobs, all done with the same bytes"

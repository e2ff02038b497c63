#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A job that ends the daemon three times is not begun a fourth time; orderly stops do not count.
# shellcheck source=tests/service/daemon.sh
. "$(dirname "$0")/daemon.sh"

small_job 1000000 1 64 48 >"$work/endless.json"
small_job 4 2 40 30 >"$work/short.json"

start_daemon
suspect=$(submit "$work/endless.json")
for _ in 1 2 3 4; do
    wait_for_state "$suspect" running
    end_daemon TERM
    start_daemon
done
for crash in 1 2 3; do
    wait_for_state "$suspect" running
    end_daemon KILL
    start_daemon
done
[ "$(state_of "$suspect")" = failed ] || fail "after $crash crashes the job is $(state_of "$suspect")"
view=$(curl -sf "$url/v1/jobs/$suspect")
grep -q '"attempts":3' <<<"$view" || fail "it must count them: $view"
[ "$(value_of failure_code "$view")" = crashed-the-server ] || fail "it must say why: $view"
short=$(submit "$work/short.json")
wait_for_state "$short" "done"
end_daemon TERM

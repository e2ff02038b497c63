#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SIGTERM with work running: the daemon ends with 0, soon, and the next one finishes what was begun.
# shellcheck source=tests/service/daemon.sh
. "$(dirname "$0")/daemon.sh"

small_job 1000000 1 64 48 >"$work/endless.json"
small_job 4 2 64 48 >"$work/short.json"
start_daemon
endless=$(submit "$work/endless.json")
wait_for_state "$endless" running
begin=$SECONDS
end_daemon TERM
[ "$exit_code" -eq 0 ] || fail "exit code $exit_code after SIGTERM"
[ $((SECONDS - begin)) -le 3 ] || fail "draining took $((SECONDS - begin)) s"
[ ! -e "$work/data/port" ] || fail "the port file must go with the daemon"

start_daemon
wait_for_state "$endless" running
short=$(submit "$work/short.json" -H 'Idempotency-Key: once')
again=$(submit "$work/short.json" -H 'Idempotency-Key: once')
[ "$short" = "$again" ] || fail "the same key made two jobs"
wait_for_state "$short" "done"

# A second daemon must not touch the folder of the first.
code=0
"$bouguer" serve --listen 127.0.0.1:0 --data "$work/data" >"$work/second" 2>&1 || code=$?
[ "$code" -eq 1 ] || fail "a second daemon on the same folder ended with $code"
grep -q "another process" "$work/second" || fail "it must say why"

curl -sf -X POST "$url/v1/jobs/$endless/cancel" >/dev/null
wait_for_state "$endless" cancelled
end_daemon TERM
start_daemon
[ "$(state_of "$endless")" = cancelled ] || fail "a cancelled job must stay cancelled"
[ "$(state_of "$short")" = "done" ] || fail "a finished job must stay done"
told=$(curl -s -o /dev/null -w '%{http_code}' -H 'Last-Event-ID: done' "$url/v1/jobs/$short/events")
[ "$told" = 204 ] || fail "a client that was told the end by the former process got $told, not 204"
curl -sf "$url/v1/jobs/$short/image.png" | head -c 4 | grep -q PNG || fail "its picture must stay"
end_daemon TERM

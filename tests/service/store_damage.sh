#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Damage of the data folder is not passed over: a start on less than there was says so and is refused.
# shellcheck source=tests/service/daemon.sh
. "$(dirname "$0")/daemon.sh"

small_job 4 1 40 30 >"$work/short.json"
start_daemon
for _ in 1 2 3; do
    id=$(submit "$work/short.json")
    wait_for_state "$id" "done"
done
removed=$(submit "$work/short.json")
wait_for_state "$removed" "done"
curl -sf -X DELETE "$url/v1/jobs/$removed" >/dev/null
end_daemon KILL
cp -r "$work/data" "$work/whole"

# refused_start NUMBER TEXT: the next start is refused, with one line that has TEXT.
refused_start() {
    local code=0
    "$bouguer" serve --listen 127.0.0.1:0 --data "$work/data" >"$work/refused" 2>&1 || code=$?
    [ "$code" -eq 1 ] || fail "$1: the start ended with $code"
    grep -q "^bouguer:.*$2.*--accept-loss" "$work/refused" || fail "$1: $(<"$work/refused")"
}
restore() {
    rm -rf "$work/data"
    cp -r "$work/whole" "$work/data"
}

start_daemon # a crash alone is no loss
end_daemon KILL
restore
rm "$work/data/jobs.sqlite-wal"
refused_start "without its log" "results of 3 jobs"
restore
rm "$work/data/jobs.sqlite"*
refused_start "with an empty database" "results of 3 jobs"
restore
rm "$work/data/results/$id.tar"
refused_start "without a result" "1 finished jobs have no results"

start_daemon --accept-loss
status=$(curl -s -o "$work/answer" -w '%{http_code}' "$url/v1/jobs/$id/image.png")
[ "$status" = 500 ] || fail "a lost result is answered with $status: $(<"$work/answer")"
grep -q result-damaged "$work/answer" || fail "$(<"$work/answer")"
curl -sf -X DELETE "$url/v1/jobs/$id" >/dev/null
end_daemon TERM
start_daemon # nothing is missing any more
end_daemon TERM
restore
rm "$work/data/jobs.sqlite"*
start_daemon --accept-loss
end_daemon TERM
[ -f "$work/data/lost-results/$id.tar" ] || fail "what has no job must be set aside and not deleted"
start_daemon
end_daemon TERM

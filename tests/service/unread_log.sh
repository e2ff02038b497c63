#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Standard error and standard output are pipes that nobody reads: the daemon serves and ends all the same. Once
# somebody reads, every line is a document, and the lines that found no room are counted.
# shellcheck source=tests/service/daemon.sh
. "$(dirname "$0")/daemon.sh"

requests=12000 # over a megabyte of lines: more than pipe and daemon hold
mkfifo "$work/pipe"
exec 3<>"$work/pipe" # holds it open and does not read

"$bouguer" serve --listen 127.0.0.1:0 --data "$work/data" --threads 2 >"$work/pipe" 2>&1 &
daemon=$!
for _ in $(seq 200); do
    [ ! -s "$work/data/port" ] || break
    sleep 0.05
done
url="http://127.0.0.1:$(<"$work/data/port")" || fail "the daemon does not start"

for _ in $(seq $((requests / 1000))); do
    seq -f "$url/livez?n=%.0f" 1000 | timeout 20 xargs -n 500 curl -sf -o /dev/null --max-time 5 >/dev/null ||
        fail "requests hang behind the log"
done
[ "$(curl -s -o /dev/null -w '%{http_code}' --max-time 2 "$url/livez")" = 200 ] || fail "livez behind the log"

# For a moment somebody reads: it is told what was lost, and the log goes on.
timeout 5 sed '/"log-dropped"/q' <&3 >"$work/lines" || fail "no line tells of those that were lost"
python3 - "$work/lines" "$requests" <<'END' || fail "the log is not what it should be"
import json, sys
lines = [json.loads(line) for line in open(sys.argv[1]) if not line.startswith("listening on")]
requests = sum(line["event"] == "request" for line in lines)
dropped = int(lines[-1]["count"])
assert lines[-1]["level"] == "warning" and dropped > 0
# the rest of the requests, and whatever else was said
assert requests + dropped >= int(sys.argv[2]), (requests, dropped)
END

# Full again: the end must not wait for a reader.
for _ in 1 2 3 4 5 6; do seq -f "$url/livez?n=%.0f" 1000 | xargs -n 500 curl -sf -o /dev/null --max-time 5 >/dev/null; done
begin=$SECONDS
kill -TERM "$daemon"
for _ in $(seq 60); do
    kill -0 "$daemon" 2>/dev/null || break
    sleep 0.05
done
! kill -0 "$daemon" 2>/dev/null || fail "SIGTERM is not felt after $((SECONDS - begin)) s"
exit_code=0
wait "$daemon" || exit_code=$?
daemon=
[ "$exit_code" -eq 0 ] || fail "exit code $exit_code after SIGTERM"

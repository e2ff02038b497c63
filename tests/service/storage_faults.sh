#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A disk that is full and then is not: everything that was acknowledged ends as done, with the right bytes.
# Needs to mount a small file system: 77, skipped, where that is not allowed.
# shellcheck source=tests/service/daemon.sh
. "$(dirname "$0")/daemon.sh"

mkdir "$work/data"
mount -t tmpfs -o size=3m bouguer-test "$work/data" 2>/dev/null || exit 77
clean_up_mount() {
    [ -z "$daemon" ] || kill -KILL "$daemon" 2>/dev/null || true
    wait 2>/dev/null || true
    umount "$work/data"
    rm -rf "$work"
}
trap clean_up_mount EXIT

for kind in 1 2 3; do
    small_job $((kind * 4)) "$kind" 40 30 >"$work/job-$kind.json"
    "$bouguer" render "$work/job-$kind.json" -o "$work/reference-$kind.exr" >/dev/null
done
status_of() { curl -s -o "$work/answer" -w '%{http_code}' "$@" || true; }
wait_for_readiness() {
    local status='' deadline=$((SECONDS + 60))
    while [ $SECONDS -lt $deadline ]; do
        status=$(status_of "$url/readyz")
        [ "$status" != "$1" ] || return 0
        sleep 0.1
    done
    fail "readyz stays $status and does not become $1"
}

start_daemon
wait_for_readiness 200
jobs=()
refused=0
# Until the disk is full, and then some.
for i in $(seq 400); do
    kind=$((i % 3 + 1))
    status=$(status_of -D "$work/head" -H 'Content-Type: application/json' --data-binary "@$work/job-$kind.json" \
        "$url/v1/jobs")
    case $status in
    202) jobs+=("$kind $(value_of id "$(<"$work/answer")")") ;;
    503 | 507)
        grep -qi '^retry-after:' "$work/head" || fail "a refusal without Retry-After: $(<"$work/answer")"
        refused=$((refused + 1))
        [ $refused -lt 20 ] || break
        ;;
    *) fail "status $status: $(<"$work/answer")" ;;
    esac
done
[ $refused -ge 20 ] || fail "3 MiB took all ${#jobs[@]} jobs, so nothing was tested"
wait_for_readiness 503
grep -q '"reason":"storage-' "$work/answer" || fail "readyz must say why: $(<"$work/answer")"
[ "$(status_of "$url/livez")" = 200 ] || fail "it must stay alive"

mount -o remount,size=64m "$work/data"
wait_for_readiness 200
for job in "${jobs[@]}"; do
    read -r kind id <<<"$job"
    wait_for_state "$id" "done"
    curl -sf "$url/v1/jobs/$id/image.exr" | cmp -s - "$work/reference-$kind.exr" || fail "job $id differs"
done
end_daemon TERM
[ "$exit_code" -eq 0 ] || fail "exit code $exit_code after SIGTERM"

# A start on a full disk serves what there is, and works when there is space again.
start_daemon
small_job 1000000 9 64 48 >"$work/endless.json"
endless=$(submit "$work/endless.json")
wait_for_state "$endless" running
end_daemon KILL
dd if=/dev/zero of="$work/data/filler" bs=1k 2>/dev/null || true
port=${url##*:}
"$bouguer" serve --listen "127.0.0.1:$port" --data "$work/data" --threads 2 >>"$work/out" 2>>"$work/log" &
daemon=$!
wait_for_readiness 503
read -r kind id <<<"${jobs[0]}"
curl -sf "$url/v1/jobs/$id/image.exr" | cmp -s - "$work/reference-$kind.exr" || fail "job $id cannot be read"
rm "$work/data/filler"
wait_for_readiness 200
wait_for_state "$endless" running
curl -sf -X POST "$url/v1/jobs/$endless/cancel" >/dev/null
end_daemon TERM
unset port

# A folder that is taken away is noticed: what is written then is lost, however well it goes.
start_daemon
mv "$work/data/jobs.sqlite" "$work/data/away.sqlite"
wait_for_readiness 503
status=$(status_of -H 'Content-Type: application/json' --data-binary "@$work/job-1.json" "$url/v1/jobs")
[ "$status" = 503 ] || fail "a submit without a database is answered with $status"
mv "$work/data/away.sqlite" "$work/data/jobs.sqlite"
wait_for_readiness 200
end_daemon TERM
echo "${#jobs[@]} acknowledged jobs through a full disk, all done with the same bytes"

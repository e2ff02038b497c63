#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SIGTERM is seen before it is felt: for --drain-delay seconds /readyz says 503, on kept and on new connections, no job
# is taken, and all else is served. SIGHUP and the user signals are no reason to end. A second SIGTERM ends at once.
# shellcheck source=tests/service/daemon.sh
. "$(dirname "$0")/daemon.sh"

# On descriptor 3: a connection that stays open between requests.
open_kept() {
    exec 3<>"/dev/tcp/127.0.0.1/${url##*:}"
}
# ask_kept PATH: prints the status of the answer over the kept connection.
ask_kept() {
    local line status='' length=0
    printf 'GET %s HTTP/1.1\r\nHost: %s\r\n\r\n' "$1" "${url#http://}" >&3
    while read -r -t 5 line <&3; do
        line=${line%$'\r'}
        case ${line,,} in
        http/1.1*) read -r _ status _ <<<"$line" ;;
        content-length:*) length=${line##* } ;;
        '') break ;;
        esac
    done
    [ "$length" -eq 0 ] || read -r -t 5 -N "$length" _ <&3
    echo "$status"
}
status_of() { curl -s -o "$work/body" -D "$work/head" -w '%{http_code}' "$@"; }

small_job 4 2 64 48 >"$work/short.json"
start_daemon --drain-delay 60 --health-listen 127.0.0.1:0
for _ in $(seq 200); do
    health=$(sed -n 's/^health at //p' "$work/out")
    [ -z "$health" ] || break
    sleep 0.05
done
[ "$(status_of "$health/readyz")" = 200 ] || fail "the listener for health, at '$health'"
[ "$(status_of "$health/v1/jobs")" = 404 ] || fail "the listener for health tells more than it should"
for signal in HUP USR1 USR2; do kill "-$signal" "$daemon"; done
[ "$(status_of "$url/readyz")" = 200 ] || fail "a signal that means nothing ended the daemon"
short=$(submit "$work/short.json")
wait_for_state "$short" "done"

open_kept
[ "$(ask_kept /readyz)" = 200 ] || fail "readyz before SIGTERM"
kill -TERM "$daemon"
for _ in $(seq 200); do
    ready=$(ask_kept /readyz)
    [ "$ready" != 503 ] || break
    sleep 0.05
done
[ "$ready" = 503 ] || fail "readyz says ${ready:-nothing} over the kept connection after SIGTERM"
[ "$(ask_kept /livez)" = 200 ] || fail "livez while draining"
[ "$(status_of "$url/readyz")" = 503 ] || fail "readyz on a new connection while draining"
[ "$(status_of "$health/readyz")" = 503 ] || fail "readyz of the listener for health while draining"
[ "$(status_of "$url/v1/jobs/$short/image.png")" = 200 ] || fail "results are served while draining"
[ "$(status_of -H 'Content-Type: application/json' --data-binary "@$work/short.json" "$url/v1/jobs")" = 503 ] ||
    fail "a job was taken while draining"
grep -q draining "$work/body" || fail "the refusal must say why: $(<"$work/body")"
grep -qi '^retry-after: [1-9]' "$work/head" || fail "the refusal must say when to try again"

begin=$SECONDS
end_daemon TERM
[ $((SECONDS - begin)) -le 3 ] || fail "a second SIGTERM took $((SECONDS - begin)) s"
exec 3<&-

# Left alone, it ends by itself when the delay is over.
start_daemon --drain-delay 1
end_daemon TERM
[ "$exit_code" -eq 0 ] || fail "exit code $exit_code after the delay"
[ ! -e "$work/data/port" ] || fail "the port file must go with the daemon"

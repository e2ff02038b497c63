#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Submits a scene or a job to a Bouguer daemon with curl, follows its events, saves PNG, OpenEXR and report.
#
#   client-examples/submit.sh SCENE.json [OUT]        writes OUT.png, OUT.exr, OUT.report.json (OUT: the file's name)
#
# Environment: BOUGUER_URL (http://127.0.0.1:8080); for a bare scene also BOUGUER_SAMPLES (16 a pixel) and
# BOUGUER_INTEGRATOR (hall). Needs bash and curl. Exit code 1 when the job is refused or does not end well.
# A daemon that restarts or is busy is waited for: everything is asked again until five minutes have passed without an
# answer, and one submission stays one job.
set -euo pipefail
export LC_ALL=C

if [ ! -r "${1:-}" ]; then
    sed -n '3,11s/^# \{0,1\}//p' "$0" >&2
    exit 2
fi
file=$1
out=${2:-$(basename "$file" .json)}
url=${BOUGUER_URL:-http://127.0.0.1:8080}
# shellcheck source=client-examples/ask.sh
source "$(dirname "${BASH_SOURCE[0]}")/ask.sh"
stream_timeout_s=20 # the daemon says something every 15 s at the least
work=$(mktemp -d)
stream=
trap '[ -z "$stream" ] || kill "$stream" 2>/dev/null; rm -rf "$work"' EXIT

# The value of a number or a plain string in one line of JSON: enough for the daemon's own answers, no parser needed.
value_of() {
    local key=$1 json=$2
    if [[ $json =~ \"$key\":\ *\"?([^,\"\}]*) ]]; then printf '%s' "${BASH_REMATCH[1]}"; fi
}

request_body() {
    if grep -q '"bouguer-job/1"' "$file"; then
        cat "$file"
    else
        printf '{"format":"bouguer-job/1","scene":'
        cat "$file"
        printf ',"integrator":{"type":"%s"},"stop":{"samples":%d}}' \
            "${BOUGUER_INTEGRATOR:-hall}" "${BOUGUER_SAMPLES:-16}"
    fi
}

show_progress() {
    local json=$1 fraction samples seconds left width=30
    fraction=$(value_of fraction "$json")
    samples=$(value_of samples "$json")
    seconds=$(value_of seconds "$json")
    left=$(value_of seconds_left "$json")
    [ -n "$fraction" ] || return 0
    local percent filled bar
    percent=$(awk -v f="$fraction" 'BEGIN { printf "%.0f", 100 * f }')
    filled=$((percent * width / 100))
    printf -v bar '%*s' "$filled" ''
    case $left in ''|null) left=$([ "$percent" -ge 100 ] && echo 0.0 || echo '?') ;; *) left=$(printf '%.1f' "$left") ;; esac
    local line
    line=$(printf '[%-*s] %3d %%  %s samples a pixel  %.1f s  %s s left' \
        "$width" "${bar// /#}" "$percent" "${samples:-0}" "${seconds:-0}" "$left")
    if [ -t 1 ]; then
        printf '\r%s\033[K' "$line"
    elif [ "$percent" -ge "$next_printed" ]; then
        printf '%s\n' "$line"
        next_printed=$((percent / 10 * 10 + 10))
    fi
}

# Shows the server-sent events as long as the stream lasts.
watch() {
    local event='' line
    exec 3< <(exec curl -sN --connect-timeout 10 "$url/v1/jobs/$1/events")
    stream=$!
    while IFS= read -r -t "$stream_timeout_s" -u 3 line; do
        line=${line%$'\r'}
        case $line in
            event:*) event=${line#event:}; event=${event# } ;;
            data:*)
                show_progress "$line"
                [ "$event" != "done" ] || break ;;
        esac
    done
    kill "$stream" 2>/dev/null || true
    stream=
    exec 3<&-
}

# Follows a job to its end; sets `state`. A stream that ends may be broken, so the state is asked for.
follow() {
    next_printed=0
    while true; do
        watch "$1"
        ask "$work/job" "$url/v1/jobs/$1"
        [ "$code" = 200 ] || refuse "The job is lost" "$work/job"
        state=$(value_of state "$(<"$work/job")")
        case $state in done | failed | cancelled) break ;; esac
        pause 500
    done
    if [ -t 1 ]; then echo; fi
}

# The key is one for all attempts: it makes them one submission.
random=$(od -An -N16 -tx1 /dev/urandom | tr -d ' \n')
key=${random:0:8}-${random:8:4}-4${random:13:3}-8${random:17:3}-${random:20:12}
request_body >"$work/body"
ask "$work/answer" -H 'Content-Type: application/json' -H "Idempotency-Key: $key" --data-binary "@$work/body" "$url/v1/jobs"
if [ "$code" != 202 ] && [ "$code" != 200 ]; then refuse "The daemon refused the job" "$work/answer"; fi
id=$(value_of id "$(<"$work/answer")")
echo "job $id"
follow "$id"
if [ "$state" != "done" ]; then
    printf 'The job ended as "%s":\n' "$state" >&2
    cat "$work/job" >&2
    exit 1
fi
for result in image.png:png image.exr:exr report:report.json; do
    ask "$work/result" "$url/v1/jobs/$id/${result%:*}"
    [ "$code" = 200 ] || refuse "There is no ${result%:*}" "$work/result"
    cp "$work/result" "$out.${result#*:}"
done

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Submits a scene or a job to a Bouguer daemon with curl, follows its events, saves PNG, OpenEXR and report.
#
#   client-examples/submit.sh SCENE.json [OUT]        writes OUT.png, OUT.exr, OUT.report.json (OUT: the file's name)
#
# Environment: BOUGUER_URL (http://127.0.0.1:8080); for a bare scene also BOUGUER_SAMPLES (16 a pixel) and
# BOUGUER_INTEGRATOR (hall). Needs bash and curl. Exit code 1 when the job is refused or does not end well.
set -euo pipefail
export LC_ALL=C

if [ ! -r "${1:-}" ]; then
    sed -n '3,9s/^# \{0,1\}//p' "$0" >&2
    exit 2
fi
file=$1
out=${2:-$(basename "$file" .json)}
url=${BOUGUER_URL:-http://127.0.0.1:8080}

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

# Follows the server-sent events until "done"; sets `state`. A broken stream is taken up again.
follow() {
    local id=$1 event='' line
    state='' next_printed=0
    while [ -z "$state" ]; do
        while IFS= read -r line; do
            line=${line%$'\r'}
            case $line in
                event:*) event=${line#event:}; event=${event# } ;;
                data:*)
                    if [ "$event" = "done" ]; then state=$(value_of state "$line"); fi
                    show_progress "$line" ;;
            esac
        done < <(curl -sN "$url/v1/jobs/$id/events" || true)
        [ -n "$state" ] || { sleep 1; curl -sf "$url/v1/jobs/$id" >/dev/null || { state=lost; }; }
    done
    if [ -t 1 ]; then echo; fi
}

answer=$(request_body | curl -sS -w '\n%{http_code}' -H 'Content-Type: application/json' --data-binary @- "$url/v1/jobs")
code=${answer##*$'\n'}
answer=${answer%$'\n'*}
if [ "$code" != 202 ] && [ "$code" != 200 ]; then
    printf 'The daemon refused the job (%s):\n%s\n' "$code" "$answer" >&2
    exit 1
fi
id=$(value_of id "$answer")
echo "job $id"
follow "$id"
if [ "$state" != "done" ]; then
    printf 'The job ended as "%s":\n' "$state" >&2
    curl -sS "$url/v1/jobs/$id" >&2 || true
    exit 1
fi
curl -sSf -o "$out.png" "$url/v1/jobs/$id/image.png"
curl -sSf -o "$out.exr" "$url/v1/jobs/$id/image.exr"
curl -sSf -o "$out.report.json" "$url/v1/jobs/$id/report"

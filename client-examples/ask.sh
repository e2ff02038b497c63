# shellcheck shell=bash
# SPDX-License-Identifier: Apache-2.0
# Asks a Bouguer daemon with curl, and lives through its restarts. Sourced by the scripts beside it.

patience_s=300        # without an answer
longest_pause_ms=5000 # between two attempts, if the daemon does not ask for a longer one

# pause MILLISECONDS: that, and up to half as much again, so that not all clients come back at once.
pause() {
    local ms=$(($1 + RANDOM % ($1 / 2 + 1)))
    sleep "$((ms / 1000)).$(printf '%03d' $((ms % 1000)))"
}

# ask FILE CURL_OPTION ...: puts the body of the answer into FILE and its status into `code`. Asks again, ever more
# slowly or as the daemon says, while nobody answers, the answer is torn, or it is that of a busy daemon.
ask() {
    local file=$1 end=$((SECONDS + patience_s)) pause_ms=250 answer reason retry_after ms
    shift
    while true; do
        answer=$(curl -sS -o "$file" -w '%{http_code} %header{retry-after}' --connect-timeout 10 \
            --speed-limit 1 --speed-time 60 "$@" 2>"$file.fault") || answer=000
        read -r code retry_after <<<"$answer"
        case $code in
            000) reason=$(<"$file.fault") ;;
            408 | 429 | 502 | 503 | 504 | 507) reason=$code ;;
            *) return 0 ;;
        esac
        ms=$pause_ms
        if [[ $retry_after =~ ^[0-9]{1,4}$ ]] && [ $((10#$retry_after * 1000)) -gt "$ms" ]; then ms=$((10#$retry_after * 1000)); fi
        if [ $((SECONDS + ms / 1000)) -ge "$end" ]; then
            echo "No answer within $patience_s s: $reason" >&2
            exit 1
        fi
        [ "$pause_ms" -gt 250 ] || echo "No answer ($reason); trying again for $patience_s s" >&2
        pause "$ms"
        pause_ms=$((pause_ms * 2 < longest_pause_ms ? pause_ms * 2 : longest_pause_ms))
    done
}

# refuse WHAT FILE: a final refusal, shown with all that the daemon says.
refuse() {
    printf '%s (%s):\n' "$1" "$code" >&2
    cat "$2" >&2
    exit 1
}

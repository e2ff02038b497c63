# SPDX-License-Identifier: Apache-2.0
# Sourced by the checks of this folder: `start_daemon BINARY` runs a daemon on a free port with its data in a new folder
# $work, sets $url, and ends both with the script.
# shellcheck shell=bash

work=$(mktemp -d)
daemon=
end_daemon() {
    if [ -n "$daemon" ]; then
        kill -TERM "$daemon" 2>/dev/null || true
        wait "$daemon" 2>/dev/null || true
    fi
    rm -rf "$work"
}
trap end_daemon EXIT

start_daemon() {
    "$@" serve --listen 127.0.0.1:0 --data "$work/data" >"$work/daemon.log" 2>&1 &
    daemon=$!
    for _ in $(seq 100); do
        [ ! -s "$work/data/port" ] || break
        sleep 0.1
    done
    [ -s "$work/data/port" ] || { cat "$work/daemon.log" >&2; return 1; }
    url="http://127.0.0.1:$(<"$work/data/port")"
    export url
}

# Fails unless file $1 begins with the bytes $2, in hexadecimal.
expect_magic() {
    local found
    found=$(head -c $((${#2} / 2)) "$1" | od -An -tx1 | tr -d ' \n')
    [ "$found" = "$2" ] || { echo "$1 begins with $found, not $2" >&2; return 1; }
}
expect_png() { expect_magic "$1" 89504e470d0a1a0a; }
expect_exr() { expect_magic "$1" 762f3101; }

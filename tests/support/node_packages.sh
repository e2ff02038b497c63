# SPDX-License-Identifier: Apache-2.0
# Sourced by tests that use tools from npm.
# shellcheck shell=bash

# node_packages FOLDER NAME@VERSION ...: installs them into FOLDER, once; a change of the list installs anew.
node_packages() {
    local folder=$1 wanted
    shift
    wanted="$*"
    [ "$(cat "$folder/installed.txt" 2>/dev/null || true)" != "$wanted" ] || return 0
    rm -rf "$folder"
    mkdir -p "$folder"
    npm install --prefix "$folder" --save-exact --no-audit --no-fund --loglevel=error "$@"
    printf '%s\n' "$wanted" >"$folder/installed.txt"
}

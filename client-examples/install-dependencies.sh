#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the Debian packages (12 and 13) that Bouguer needs, and only those that are not there yet.
#
#   client-examples/install-dependencies.sh build          to compile and use the daemon
#   client-examples/install-dependencies.sh build test     and to run its tests
#
# The one list of packages: quickstart.sh, tests/run.sh and the Dockerfile call this. Works as root or with sudo.
set -euo pipefail

# A word is a package; "package:command" is a package that is wanted only where that command is missing.
build_packages=(
    g++ cmake ninja-build pkgconf:pkg-config ca-certificates
    libembree-dev libtbb-dev libopenimageio-dev libexpected-dev
    libjpeg-dev liblcms2-dev zlib1g-dev
    nlohmann-json3-dev libssl-dev
    libcpp-httplib-dev libspdlog-dev libsqlitecpp-dev libsqlite3-dev libcli11-dev
    curl:curl
)
test_packages=(
    libgtest-dev clang-format:clang-format shellcheck python3:python3 python3-venv nodejs:node npm:npm
    chromium:chromium
    strace:strace e2fsprogs:mkfs.ext4 mount:mount util-linux:prlimit
)

is_installed() { [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

wanted=()
for group in "${@:-build}"; do
    case $group in
        build) wanted+=("${build_packages[@]}") ;;
        test) wanted+=("${test_packages[@]}") ;;
        *) echo "usage: $0 [build] [test]" >&2; exit 2 ;;
    esac
done

missing=()
for word in "${wanted[@]}"; do
    package=${word%%:*}
    if [ "$package" != "$word" ]; then
        command -v "${word#*:}" >/dev/null || missing+=("$package")
    elif ! is_installed "$package"; then
        missing+=("$package")
    fi
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "Not root and no sudo. Install these yourself: ${missing[*]}" >&2; exit 1; }
    as_root=(sudo)
fi
echo "Installing: ${missing[*]}"
quietly="-qq -o=Dpkg::Use-Pty=0"
# shellcheck disable=SC2086
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get $quietly update
# shellcheck disable=SC2086
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get $quietly install -y --no-install-recommends "${missing[@]}" >/dev/null

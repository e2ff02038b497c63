#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs what the tests need (Debian 12 or 13, as root or with sudo), builds the release preset and runs every test.
# Everything that is checked is a test of ctest, so its closing lines say how it went. Arguments go to ctest,
# e.g. tests/run.sh -R Includes.
set -euo pipefail
cd "$(dirname "$0")/.."

stage() {
    local name=$1 begin=$SECONDS
    shift
    echo "== $name"
    "$@"
    echo "== $name took $((SECONDS - begin)) s"
}

stage "install" client-examples/install-dependencies.sh build test
stage "configure" cmake --preset release -DBOUGUER_BUILD_TESTS=ON
stage "build" cmake --build --preset release
echo "== test"
exec ctest --preset release -j "$(nproc)" "$@"

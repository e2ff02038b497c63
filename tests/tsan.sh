#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the server's tests with ThreadSanitizer and runs them; any report fails. Arguments go to the tests, e.g. the long
# form of the stress: tests/tsan.sh --gtest_filter='JobStress.*' --gtest_repeat=10
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset tsan -DBOUGUER_BUILD_TESTS=ON
cmake --build --preset tsan --target server_tests
export TSAN_OPTIONS="suppressions=$PWD/tests/tsan.supp halt_on_error=0 exitcode=66"
exec build/tsan/tests/server/server_tests --gtest_brief=1 "$@"

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Fails with a diff-like list when a C++ source is not as clang-format 14 (Debian 12's) would write it.
# Exit 77, "skipped", where that version is not installed: others break some lines differently.
set -euo pipefail
cd "$(dirname "$0")/../.."
clang-format --version 2>/dev/null | grep -q 'version 14\.' || { echo "clang-format 14 is not installed"; exit 77; }
find renderer api server tests client-examples \( -name '*.h' -o -name '*.cpp' \) -print0 |
    xargs -0 clang-format --dry-run --Werror

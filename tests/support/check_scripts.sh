#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Fails when shellcheck finds fault with a script.
set -euo pipefail
cd "$(dirname "$0")/../.."
mapfile -t scripts < <(grep -rlE '^#!.*\b(ba)?sh$' --include='*.sh' client-examples tests)
shellcheck -x .ci/run "${scripts[@]}"

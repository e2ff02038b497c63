#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Lints api/openapi.yaml, and with it the schemas that it names, and api/openapi.json, which is served, with Redocly's
# linter: no error and no warning. Needs node 18 or later and npm; the linter goes into build/openapi-lint, once.
# Usage: tests/api/lint_openapi.sh
set -euo pipefail
cd "$(dirname "$0")/../.."

# The version for old nodes (Debian 12 has 18) comes in 257 packages, that for newer ones in one.
linter="@redocly/cli@1.34.5"
if node -e 'const [a, b] = process.versions.node.split("."); process.exit(a > 20 || (a == 20 && b >= 19) ? 0 : 1)'; then
    linter="@redocly/cli@2.77.0"
fi
folder=build/openapi-lint

# shellcheck source=tests/support/node_packages.sh
source tests/support/node_packages.sh
node_packages "$folder" "$linter"
export REDOCLY_TELEMETRY=off REDOCLY_SUPPRESS_UPDATE_NOTICE=true
exec "$folder/node_modules/.bin/redocly" lint --extends=recommended-strict api/openapi.yaml api/openapi.json

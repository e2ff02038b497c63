#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs pages_survive.mjs. Needs chromium, node 18 or later and npm; playwright-core goes into build/browser, once.
#
#   tests/browser/pages_survive.sh BOUGUER [SECONDS [PAGE [SCREENSHOTS]]]
#
# SECONDS without the daemon (3); PAGE: the folder of the page that comes from elsewhere (client-examples/web);
# SCREENSHOTS: a folder for them.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
bouguer=$(realpath "${1:?usage: $0 BOUGUER}")
work=$(mktemp -d "${TMPDIR:-/tmp}/bouguer-browser.XXXXXX")
trap 'rm -rf "$work"' EXIT
# shellcheck source=tests/support/node_packages.sh
source "$root/tests/support/node_packages.sh"
node_packages "$root/build/browser" playwright-core@1.56.1
cp "$root/tests/browser/"*.mjs "$work" # beside the packages, where node looks for them
ln -s "$root/build/browser/node_modules" "$work/node_modules"
node "$work/pages_survive.mjs" "$bouguer" "$root" "$work" "${2:-3}" "${3:-$root/client-examples/web}" "${4:-}"

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes TypeScript types of the description that a daemon serves, compiles submit_job.ts with them as strictly as the compiler
# can, and runs it against the daemon. Needs node 18 or later and npm; the tools go into build/typescript-client, once.
#
#   tests/clients/typescript.sh BOUGUER
# shellcheck source=tests/service/daemon.sh
. "$(dirname "$0")/../service/daemon.sh"
# shellcheck source=tests/support/node_packages.sh
. "$source_dir/tests/support/node_packages.sh"
tools=$source_dir/build/typescript-client
node_packages "$tools" openapi-typescript@7.13.0 openapi-fetch@0.17.0 typescript@5.9.3

start_daemon
cp "$source_dir"/tests/clients/{submit_job.ts,tsconfig.json} "$work"
ln -s "$tools/node_modules" "$work/node_modules" # where node and the compiler look for them
cd "$work"
echo '{ "type": "module" }' >package.json
curl -sf -o openapi.json "$url/v1/openapi.json"
# Without the option what has a default would have to be given in a job.
node_modules/.bin/openapi-typescript openapi.json --default-non-nullable false -o openapi.d.ts
node_modules/.bin/tsc -p tsconfig.json
node submit_job.js "$url"
end_daemon TERM

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# submit.sh and submit.py render a scene over HTTP to equal pictures, and fail on a document that is refused;
# submit.py uploads the files that a scene names and prints warnings.
set -euo pipefail
cd "$(dirname "$0")"
bouguer=$1 examples=../../client-examples
# shellcheck source=tests/examples/daemon.sh
source daemon.sh
start_daemon "$bouguer"

BOUGUER_URL=$url BOUGUER_SAMPLES=4 "$examples/submit.sh" "$examples/scenes/grey-card.json" "$work/shell"
"$examples/submit.py" --url "$url" --samples 4 --out "$work/python" "$examples/scenes/grey-card.json"
expect_png "$work/shell.png"
expect_exr "$work/shell.exr"
cmp "$work/shell.png" "$work/python.png"
cmp "$work/shell.exr" "$work/python.exr"
grep -q relative_rmse "$work/python.report.json"

# What the scene names is uploaded the first time only.
textures=$examples/scenes/textures/textures.json
"$examples/submit.py" --url "$url" --samples 1 --out "$work/first" "$textures" >"$work/first.log"
"$examples/submit.py" --url "$url" --samples 1 --out "$work/second" "$textures" >"$work/second.log"
grep -q 'uploaded poster.png' "$work/first.log"
if grep -q uploaded "$work/second.log"; then
    echo "submit.py uploaded a file twice" >&2
    exit 1
fi
cmp "$work/first.png" "$work/second.png"

# What is valid and probably not meant is said.
python3 - "$examples/scenes/grey-card.json" >"$work/spare.json" <<'END'
import json, sys
scene = json.load(open(sys.argv[1]))
scene["materials"]["spare"] = {"type": "hall", "k_sr": 0.5}
print(json.dumps(scene))
END
"$examples/submit.py" --url "$url" --samples 1 --out "$work/spare" "$work/spare.json" 2>"$work/spare.log"
grep -q 'warning: /scene/materials/spare: ' "$work/spare.log"

printf '{"format":"bouguer-scene/1","camera":{"type":"perspective","fov_deg":400}}' >"$work/bad.json"
if BOUGUER_URL=$url "$examples/submit.sh" "$work/bad.json" "$work/bad" 2>"$work/refusal"; then
    echo "submit.sh took a refusal for a success" >&2
    exit 1
fi
grep -q 'fov_deg' "$work/refusal"
if "$examples/submit.py" --url "$url" --out "$work/bad" "$work/bad.json" 2>"$work/refusal"; then
    echo "submit.py took a refusal for a success" >&2
    exit 1
fi
grep -q 'fov_deg' "$work/refusal"

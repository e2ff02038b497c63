#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What `bouguer` answers on the command line: exit codes, texts and files.
# shellcheck source=tests/service/daemon.sh
. "$(dirname "$0")/daemon.sh"

# expect CODE WORDS command ...: runs it; its exit code is CODE, and what it says on either stream contains WORDS.
expect() {
    local code=$1 words=$2 got=0
    shift 2
    "$@" >"$work/said" 2>&1 || got=$?
    [ "$got" -eq "$code" ] || { cat "$work/said"; fail "exit code $got, not $code: $*"; }
    grep -qF -- "$words" "$work/said" || { cat "$work/said"; fail "does not say \"$words\": $*"; }
}

small_job 2 1 32 24 >"$work/job.json"
sed 's/"seed"/"sead"/; s/"k_sr":1,/"k_sr":2,/' "$work/job.json" >"$work/bad.json"
echo '{' >"$work/broken.json"

expect 0 "bouguer 0." "$bouguer" --version
expect 0 "Embree" "$bouguer" --version
expect 0 "Usage" "$bouguer" --help
expect 0 "--wavelength-step" "$bouguer" render --help
expect 2 "Usage" "$bouguer"
expect 2 "" "$bouguer" paint
expect 2 "" "$bouguer" render "$work/job.json"
expect 2 "--samples" "$bouguer" render "$work/job.json" -o "$work/x.png" --samples 0
expect 2 "--samples" "$bouguer" render "$work/job.json" -o "$work/x.png" --samples many
expect 2 ".png or .exr" "$bouguer" render "$work/job.json" -o "$work/x.jpg"
expect 2 "--resolution" "$bouguer" render "$work/job.json" -o "$work/x.png" --resolution 10
expect 2 "lee-9300k" "$bouguer" render "$work/job.json" -o "$work/x.png" --display tv
expect 2 "--exposure" "$bouguer" render "$work/job.json" -o "$work/x.png" --exposure -1
expect 2 "No such file" "$bouguer" render "$work/none.json" -o "$work/x.png"
expect 2 "/sead: " "$bouguer" render "$work/bad.json" -o "$work/x.png"
[ ! -e "$work/x.png" ] || fail "a refused command must write nothing"
expect 1 "cannot make" "$bouguer" render "$work/job.json" -o "$work/no/such/x.png"
expect 2 "--white" "$bouguer" render "$work/job.json" -o "$work/x.png" --white amber

expect 0 "valid" "$bouguer" validate "$work/job.json"
expect 2 "/sead: " "$bouguer" validate "$work/bad.json"
expect 2 "/scene/materials/grey/k_sr: " "$bouguer" validate "$work/bad.json"
expect 2 "(found 2, allowed " "$bouguer" validate "$work/bad.json"
expect 2 "" "$bouguer" validate "$work/broken.json"
expect 0 "left out" "$bouguer" plan "$work/job.json"
expect 0 '"kernel"' "$bouguer" plan "$work/job.json" --json

expect 2 "--allow-remote" "$bouguer" serve --listen 0.0.0.0:0 --data "$work/data"
expect 2 "HOST:PORT" "$bouguer" serve --listen 8080 --data "$work/data"
expect 1 "" "$bouguer" serve --listen 127.0.0.1:0 --data /proc/none

# Flags go before the document; a scene is a job with every default.
expect 0 "3 samples a pixel" "$bouguer" render "$work/job.json" -o "$work/a.png" -o "$work/a.exr" --samples 3 \
    --report "$work/report.json"
[ "$(head -c 4 "$work/a.exr" | od -An -tx1 | tr -d ' ')" = 762f3101 ] || fail "no OpenEXR file"
[ "$(head -c 8 "$work/a.png" | od -An -tx1 | tr -d ' ')" = 89504e470d0a1a0a ] || fail "no PNG file"
grep -q '"error"' "$work/report.json" || fail "no report"
expect 0 "wrote" "$bouguer" render "$source_dir/client-examples/scenes/grey-card.json" -o "$work/b.png" \
    --resolution 20x10 --integrator rgb --display lee-9300k --exposure 0.5 --seed 9 --max-depth 2 --threads 1
[ "$(od -An -tu1 -j16 -N8 "$work/b.png" | tr -s ' ')" = " 0 0 0 20 0 0 0 10" ] || fail "the resolution is not 20 x 10"

# Two pictures: of the same job the same; as shown in a PNG nearly so.
expect 0 "maximum          0 at (0, 0)" "$bouguer" compare "$work/a.exr" "$work/a.exr"
expect 0 '"metric":"CIEDE2000"' "$bouguer" compare "$work/a.exr" "$work/a.png" --json -o "$work/map.png" --white A
[ "$(head -c 4 "$work/map.png" | od -An -tx1 | tr -d ' ')" = 89504e47 ] || fail "no map"
expect 2 "differ in size" "$bouguer" compare "$work/a.exr" "$work/b.png"
expect 2 "render it first" "$bouguer" compare "$work/a.exr" "$work/job.json"
expect 2 "--exposure" "$bouguer" compare "$work/a.exr" "$work/a.exr" --exposure 0
expect 2 "No such file" "$bouguer" compare "$work/a.exr" "$work/none.exr"

# Results go where a link or a device leads; neither is replaced by a file. What cannot be printed is a failure.
touch "$work/kept"
ln -s kept "$work/link"
expect 0 "wrote" "$bouguer" render "$work/job.json" -o "$work/b.png" --report "$work/link"
[ -L "$work/link" ] || fail "the link was replaced"
grep -q '"error"' "$work/kept" || fail "the report is not behind the link"
if [ -c /dev/full ]; then
    code=0
    "$bouguer" plan "$work/job.json" >/dev/full 2>&1 || code=$?
    [ "$code" -eq 1 ] || fail "exit code $code when the disk is full"
fi

# SIGINT: at once, with the newest complete pass and exit code 1.
# (What a script starts in the background ignores SIGINT unless told otherwise.)
env --default-signal=INT "$bouguer" render "$work/job.json" -o "$work/cut.png" --samples 1000000 >"$work/said" 2>&1 &
render=$!
sleep 1
kill -INT "$render"
code=0
wait "$render" || code=$?
[ "$code" -eq 1 ] || fail "exit code $code after SIGINT"
grep -q "newest complete pass" "$work/said" || fail "it must say what it wrote"
[ -s "$work/cut.png" ] || fail "the complete pass must be written"
[ -z "$(find "$work" -name '*.part-*')" ] || fail "partial files are left"

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A document of 6 KB that asks for a monstrous picture holds nobody up, and time limits hold within its first pass.
# shellcheck source=tests/service/daemon.sh
. "$(dirname "$0")/daemon.sh"

# monster STOP: 60 spheres of glass in each other, every ray split 64 times in a row, 8 million pixels.
monster() {
    local objects='' radius
    for i in $(seq 60); do
        radius=$(awk "BEGIN { print 1 + $i / 50 }")
        objects+="{\"name\":\"s$i\",\"shape\":{\"type\":\"sphere\",\"center\":[0,0,0],\"radius\":$radius},\"material\":\"glass\"},"
    done
    cat <<END
{"format":"bouguer-job/1","integrator":{"type":"hall","max_depth":64,"min_throughput":0},"stop":$1,
 "scene":{"format":"bouguer-scene/1","name":"monster",
  "camera":{"type":"perspective","from":[0,0,6],"at":[0,0,0],"up":[0,1,0],"fov_deg":40,"resolution":[4096,2048]},
  "materials":{"glass":{"type":"hall","reflectance":1,"transmittance":1,"k_sr":0.5,"k_st":0.5,"n":20,"ior":1.3,"mirror":true}},
  "objects":[${objects%,}],
  "lights":[{"type":"directional","direction":[-1,-2,-1],"irradiance":"D65"}]}}
END
}

# member KEY JSON: of the first number of that name.
member() { sed -n "s/.*\"$1\":\([0-9.]*\).*/\1/p" <<<"$2" | head -n 1; }

monster '{"samples":1}' >"$work/monster.json"
monster '{"seconds":1}' >"$work/short.json"
small_job 16 1 32 32 >"$work/small.json"
start_daemon --max-seconds 20

# It would take weeks: one of its samples follows a million rays and takes seconds. Two of them have two threads, and a small
# job comes later.
first=$(submit "$work/monster.json")
second=$(submit "$work/monster.json")
wait_for_state "$first" running
wait_for_state "$second" running
rays=0
for _ in $(seq 200); do
    rays=$(member rays "$(curl -sf "$url/v1/jobs/$first")")
    [ "$rays" = 0 ] || break
    sleep 0.05
done
[ "$rays" != 0 ] || fail "what is under way shows no rays"
begin=$SECONDS
small=$(submit "$work/small.json")
wait_for_state "$small" "done"
[ $((SECONDS - begin)) -le 10 ] || fail "a small job took $((SECONDS - begin)) s beside a monstrous one"
[ "$(state_of "$first")" = running ] || fail "the first job is no longer running: this test sees nothing"
"$bouguer" render "$work/small.json" -o "$work/cli.exr" >/dev/null
curl -sf -o "$work/http.exr" "$url/v1/jobs/$small/image.exr"
cmp "$work/http.exr" "$work/cli.exr" || fail "the small job has other bits than alone"

# The job's own limit, in its first pass.
curl -sf -X DELETE "$url/v1/jobs/$second" >/dev/null
short=$(submit "$work/short.json")
wait_for_state "$short" "done"
job=$(curl -sf "$url/v1/jobs/$short")
awk "BEGIN { exit !($(member seconds "$job") <= 10) }" || fail "a job of 1 s rendered for $(member seconds "$job") s"
report=$(curl -sf "$url/v1/jobs/$short/report")
grep -q '"stopped_by":"seconds"' <<<"$report" || fail "it does not say that the time was over"
grep -q '"unfinished_pass":{"pixels":8388608,"without_sample":[1-9]' <<<"$report" || fail "it does not say what is missing"
curl -sf -o "$work/short.png" "$url/v1/jobs/$short/image.png" || fail "there is no picture"

# And the server's.
wait_for_state "$first" "done"
grep -q '"stopped_by":"server-limit"' <<<"$(curl -sf "$url/v1/jobs/$first/report")" ||
    fail "it does not say that the server ended it"

# The command line's likewise, with a picture and a word.
"$bouguer" render "$work/monster.json" --seconds 1 --resolution 512x256 --threads 2 -o "$work/cli.png" >"$work/said" 2>&1 ||
    fail "the command line: $(<"$work/said")"
grep -q "have no sample" "$work/said" || fail "the command line does not say what is missing: $(<"$work/said")"
end_daemon TERM
[ "$exit_code" = 0 ] || fail "the daemon ended with $exit_code"

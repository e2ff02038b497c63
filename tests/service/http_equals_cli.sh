#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The same job by HTTP and by `bouguer render` gives the same bytes.
# shellcheck source=tests/service/daemon.sh
. "$(dirname "$0")/daemon.sh"

small_job 8 7 97 61 >"$work/job.json"
start_daemon
id=$(submit "$work/job.json")
wait_for_state "$id" "done"
"$bouguer" render "$work/job.json" -o "$work/cli.exr" -o "$work/cli.png" --threads 3 >/dev/null
for name in exr png; do
    curl -sf -o "$work/http.$name" "$url/v1/jobs/$id/image.$name"
    cmp "$work/http.$name" "$work/cli.$name" || fail "image.$name differs"
done
# Shown otherwise without rendering: as if it had been rendered so. XYZ keeps the film to the bit.
sed 's/"seed"/"output":{"color_space":"xyz"},"seed"/' "$work/job.json" >"$work/xyz.json"
id=$(submit "$work/xyz.json")
wait_for_state "$id" "done"
curl -sf -o "$work/again.png" "$url/v1/jobs/$id/image.png?display=display-p3&exposure=2&white=A&gamut=desaturate"
"$bouguer" render "$work/job.json" -o "$work/so.png" --display display-p3 --exposure 2 --white A --gamut desaturate \
    >/dev/null
cmp "$work/again.png" "$work/so.png" || fail "what is asked for again differs from what is rendered so"
small_job 8 8 97 61 >"$work/other.json"
"$bouguer" render "$work/other.json" -o "$work/other.exr" >/dev/null
! cmp -s "$work/other.exr" "$work/cli.exr" || fail "another seed must give another picture, or this test sees nothing"
end_daemon TERM

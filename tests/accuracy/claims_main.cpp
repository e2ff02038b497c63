// SPDX-License-Identifier: Apache-2.0
// Prints claimed against true error of a scene.
//
//     claims SCENE.json [WIDTH HEIGHT [SEEDS [SAMPLES [REFERENCE_FACTOR]]]]

#include <cstdio>
#include <cstdlib>

#include "tests/accuracy/claims.h"
#include "tests/support/scene_files.h"

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(
            stderr,
            "usage: claims SCENE.json [WIDTH HEIGHT [SEEDS [SAMPLES [REFERENCE_FACTOR]]]]\n");
        return 2;
    }
    const auto number = [&](int i, int fallback) {
        return argc > i ? std::atoi(argv[i]) : fallback;
    };
    auto job = bouguer::test::load_job(argv[1]);
    job.settings.resolution = {number(2, 160), number(3, 120)};
    bouguer::test::ClaimSettings claims;
    claims.seeds = number(4, claims.seeds);
    claims.samples = static_cast<std::uint32_t>(number(5, 64));
    claims.reference_factor = static_cast<std::uint32_t>(number(6, 100));
    const auto scene = bouguer::renderer::build_scene(job.scene).value();
    std::printf("samples  claimed    true       claimed/true  interval holds truth\n");
    for (const auto& [samples, row] : bouguer::test::compare_claims(scene, job.settings, claims)) {
        std::printf("%7u  %.6f   %.6f   %.3f         %.2f of %d\n", samples, row.claimed, row.truth,
                    row.ratio(), row.covered, row.seeds);
    }
    return 0;
}

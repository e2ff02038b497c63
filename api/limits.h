// SPDX-License-Identifier: Apache-2.0
// Every limit on what a client may ask for, in one struct. Each has a test that hits it and a row
// in the README.
#pragma once

#include <cstddef>
#include <cstdint>

namespace bouguer::api {

struct Limits {
    std::size_t body_bytes = 8U << 20U;
    int json_depth = 32;
    std::size_t problems = 100;    ///< reported of one document; the rest is counted
    std::size_t name_bytes = 200;  ///< of names and labels
    std::size_t objects = 10'000;
    std::size_t instances = 100'000;  ///< of all objects together
    std::size_t materials = 1'000;
    std::size_t lights = 1'000;
    std::size_t spectra = 1'000;
    std::size_t spectrum_samples = 10'000;
    std::size_t spectrum_parts = 64;        ///< factors of a product, with those of its factors
    std::size_t product_work = 10'000'000;  ///< of the products of a scene, see ReadSpectrum
    std::size_t spectrum_references = 32;   ///< spectra that refer to spectra, in a row
    std::size_t textures = 1'000;
    std::size_t texture_pixels = 16'777'216;        ///< of one image: 4096 x 4096
    std::size_t scene_texture_pixels = 33'554'432;  ///< of all image textures of a scene
    std::size_t mesh_vertices = 10'000'000;
    std::size_t mesh_triangles = 20'000'000;
    std::int64_t pixels = 8'388'608;   ///< 4096 x 2048
    int resolution = 16'384;           ///< a side
    std::int64_t samples = 1'000'000;  ///< a pixel
    double pixel_samples = 1e11;       ///< pixels x samples
    double seconds = 86'400;           ///< of a stop rule
    int max_depth = 1000;
    std::size_t labels = 32;
    std::size_t transform_steps = 100;         ///< of one transform
    std::uint64_t memory_bytes = 4ULL << 30U;  ///< estimated for film and geometry of one job
};

}  // namespace bouguer::api

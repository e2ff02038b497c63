// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/flat_faces.h"

#include <variant>

#include "renderer/geometry/bounds.h"
#include "tests/support/parallel_render.h"
#include "tests/support/scene_files.h"
#include "tests/support/source_folder.h"

namespace bouguer::test {
namespace {

using namespace renderer;

std::optional<Bounds> extent_of(const Shape& shape) {
    Bounds bounds;
    if (const auto* mesh = std::get_if<std::shared_ptr<const TriangleMesh>>(&shape)) {
        for (const Vec3 p : (*mesh)->positions) bounds.add(p);
    } else if (const auto* box = std::get_if<Box>(&shape)) {
        bounds.add(box->min);
        bounds.add(box->max);
    } else {
        return std::nullopt;
    }
    return bounds;
}

/// Mean over the pixels whose centres lie in [x0, x1] x [y0, y1], in pixels.
Xyz mean_over(const Picture& picture, Real x0, Real x1, Real y0, Real y1) {
    Xyz sum;
    int pixels = 0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            if (x + 0.5 < x0 || x + 0.5 > x1 || y + 0.5 < y0 || y + 0.5 > y1) continue;
            const float* p = &picture.xyz[3 * (static_cast<std::size_t>(y) *
                                                   static_cast<std::size_t>(picture.width) +
                                               static_cast<std::size_t>(x))];
            sum += Xyz{p[0], p[1], p[2]};
            ++pixels;
        }
    }
    return sum * (1.0 / pixels);
}

}  // namespace

api::JobRequest example_job(const std::string& path, const Replacements& replacements) {
    const auto file = tests::source_folder() / "client-examples/scenes" / path;
    std::string text = read_file(file);
    for (const auto& [from, to] : replacements) {
        const std::size_t at = text.find(from);
        if (at == std::string::npos) throw std::runtime_error(path + " has no " + from);
        text.replace(at, from.size(), to);
    }
    return read_job(text, file);
}

Picture render_picture(const api::JobRequest& job) {
    StopRule stop;
    stop.samples = 1;
    const auto render = Render::create(build_scene(job.scene).value(), job.settings, stop).value();
    run_to_end(*render, 2);
    return *render->picture();
}

std::map<std::string, Xyz> colours_of_faces(const SceneDescription& scene, const Picture& picture) {
    const Real pixels_per_unit = picture.height / std::get<OrthographicCamera>(scene.camera).height;
    std::map<std::string, Xyz> colours;
    for (const ObjectDescription& object : scene.objects) {
        const auto extent = extent_of(object.placed.shape);
        if (!extent) continue;
        const Vec3 middle = extent->middle();
        const Vec3 quarter = 0.5 * extent->half_size();
        const auto column = [&](Real x) { return 0.5 * picture.width + x * pixels_per_unit; };
        const auto row = [&](Real y) { return 0.5 * picture.height - y * pixels_per_unit; };
        colours[object.name] =
            mean_over(picture, column(middle.x - quarter.x), column(middle.x + quarter.x),
                      row(middle.y + quarter.y), row(middle.y - quarter.y));
    }
    return colours;
}

}  // namespace bouguer::test

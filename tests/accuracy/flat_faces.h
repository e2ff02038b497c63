// SPDX-License-Identifier: Apache-2.0
// Scenes that are seen straight on: the colour of each of their faces, as it stands in the picture.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "api/job_document.h"
#include "renderer/render.h"

namespace bouguer::test {

/// Parts of a document and what stands in their place.
using Replacements = std::vector<std::pair<std::string, std::string>>;

/// A scene of client-examples/scenes, e.g. "colour/metamers-A.json", as a job. Each replacement
/// takes the first place where its text stands.
[[nodiscard]] api::JobRequest example_job(const std::string& path,
                                          const Replacements& replacements = {});

/// The finished picture of `job`, one sample a pixel: enough where nothing is noisy.
[[nodiscard]] renderer::Picture render_picture(const api::JobRequest& job);

/// The mean XYZ of every object with an extent (mesh or box), by its name, over the middle half of
/// what it covers in x and y. The camera of `scene` is orthographic and looks along -z at the
/// origin; `picture` has the scene's shape in any resolution.
[[nodiscard]] std::map<std::string, renderer::Xyz> colours_of_faces(
    const renderer::SceneDescription& scene, const renderer::Picture& picture);

}  // namespace bouguer::test

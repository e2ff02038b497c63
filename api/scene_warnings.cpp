// SPDX-License-Identifier: Apache-2.0
#include "api/scene_warnings.h"

#include "api/body_warnings.h"
#include "api/camera_warnings.h"
#include "api/light_warnings.h"
#include "api/material_warnings.h"
#include "api/mesh_warnings.h"
#include "api/placed_objects.h"
#include "api/spectral_warnings.h"
#include "api/warning_sink.h"

namespace bouguer::api {

void warn_of_scene(const renderer::SceneDescription& scene, const std::string& pointer,
                   Problems& problems) {
    WarningSink sink(pointer, problems);
    const auto places = places_of(scene);
    warn_of_materials(scene, sink);
    warn_of_meshes(scene, sink);
    warn_of_bodies(scene, places, sink);
    warn_of_lights(scene, places, sink);
    warn_of_camera(scene, places, sink);
}

void warn_of_job(const renderer::SceneDescription& scene, const renderer::RenderSettings& settings,
                 const renderer::OutputSettings& output, const std::string& pointer,
                 Problems& problems) {
    WarningSink sink(pointer, problems);
    warn_of_narrow_spectra(scene, settings, sink);
    warn_of_exposure(scene, output, sink);
}

}  // namespace bouguer::api

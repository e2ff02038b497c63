// SPDX-License-Identifier: Apache-2.0
#include "api/spectral_warnings.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "api/json_value.h"
#include "renderer/spectrum/quadrature.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::api {
namespace {

using renderer::Real;
using renderer::SceneDescription;
using renderer::SpectrumPtr;
using renderer::SurfaceSpectrum;

/// Spectra that nodes may miss some of, each once.
class RoughSpectra {
  public:
    explicit RoughSpectra(Real step_nm) : step_nm_(step_nm) {}
    void add(const SpectrumPtr& s) {
        if (s && s->is_rough(step_nm_) && seen_.insert(s.get()).second) all_.push_back(s);
    }
    void add(const SurfaceSpectrum& s) {
        if (!s.spectrum) return;
        for (const SpectrumPtr& part : s.parts()) add(part);
    }
    [[nodiscard]] const std::vector<SpectrumPtr>& all() const { return all_; }

  private:
    Real step_nm_;
    std::set<const renderer::Spectrum*> seen_;
    std::vector<SpectrumPtr> all_;
};

std::set<std::size_t> used_materials(const SceneDescription& scene) {
    std::set<std::size_t> used;
    for (const auto& object : scene.objects) used.insert(object.material);
    return used;
}

std::vector<SpectrumPtr> rough_lights(const SceneDescription& scene, Real step_nm) {
    RoughSpectra lights(step_nm);
    for (const auto& light : scene.lights) {
        if (const auto* point = std::get_if<renderer::PointLight>(&light)) {
            lights.add(point->intensity);
        } else {
            lights.add(std::get<renderer::DirectionalLight>(light).irradiance);
        }
    }
    if (scene.environment) lights.add(scene.environment->radiance);
    for (const std::size_t m : used_materials(scene)) lights.add(scene.materials[m].emission);
    return lights.all();
}

/// What a surface makes of a light, in Y: as nodes have it, and as it is.
struct Meeting {
    double light = 0, seen = 0, right = 0;
    /// Off by a tenth, of something that is not dark.
    [[nodiscard]] bool is_wrong() const {
        const double most = std::max(seen, right);
        return most > 1e-3 * light && std::abs(seen - right) > 0.1 * most;
    }
};

Meeting meeting_of(const SpectrumPtr& light, const SpectrumPtr& colour, Real step_nm) {
    const SpectrumPtr product = renderer::product_spectrum(light, colour);
    Meeting meeting;
    for (const renderer::QuadratureNode& node : renderer::quadrature(step_nm)) {
        const double mean = light->tent_mean(node.lambda_nm, step_nm) * node.weight.y;
        meeting.light += mean;
        meeting.seen += mean * colour->tent_mean(node.lambda_nm, step_nm);
        meeting.right += product->tent_mean(node.lambda_nm, step_nm) * node.weight.y;
    }
    return meeting;
}

std::string text_of(const Meeting& meeting, Real step_nm) {
    std::string text = "its colour and a light's are both narrow against the " +
                       number_text(step_nm) + " nm from wavelength to wavelength: ";
    if (!(meeting.right > 1e-6 * meeting.seen)) return text + "light shows where there is none";
    char times[32];
    std::snprintf(times, sizeof times, "%.2g", meeting.seen / meeting.right);
    return text + "it shows " + times + " times the light that there is";
}

}  // namespace

void warn_of_narrow_spectra(const SceneDescription& scene, const renderer::RenderSettings& settings,
                            WarningSink& sink) {
    if (settings.integrator != renderer::IntegratorType::Hall) return;
    const Real step_nm = settings.wavelength_step_nm;
    const std::vector<SpectrumPtr> lights = rough_lights(scene, step_nm);
    int left = 32;  // pairs that are looked at: each is integrated
    for (const std::size_t m : used_materials(scene)) {
        RoughSpectra colours(step_nm);
        for (const SurfaceSpectrum& colour : renderer::needs_of(scene.materials[m]).colours)
            colours.add(colour);
        Meeting worst;
        for (const SpectrumPtr& colour : colours.all()) {
            for (const SpectrumPtr& light : lights) {
                if (worst.is_wrong() || left-- <= 0) continue;
                worst = meeting_of(light, colour, step_nm);
            }
        }
        if (!worst.is_wrong()) continue;
        sink.warn("/materials/" + pointer_token(scene.materials[m].name), "narrow-spectra-meet",
                  text_of(worst, step_nm),
                  "ask for a smaller wavelength_step_nm, or put the filter before the lamp as a "
                  "product of spectra");
    }
}

}  // namespace bouguer::api

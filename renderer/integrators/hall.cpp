// SPDX-License-Identifier: Apache-2.0
#include "renderer/integrators/hall.h"

#include <array>

#include "renderer/integrators/hall_walk.h"

namespace bouguer::renderer {
namespace {

template <bool Transparency, bool Ambient>
class Hall final : public Integrator {
  public:
    Hall(const Scene& scene, SpectralBasis basis, const RenderSettings& settings)
        : scene_(scene),
          basis_(std::move(basis)),
          settings_(settings),
          tables_(scene, basis_),
          wavelengths_(basis_) {}

    std::unique_ptr<TraceScratch> make_scratch() const override {
        return std::make_unique<HallScratch>(tables_, scene_.geometry());
    }

    Xyz trace(const Ray& ray, const PixelSampler& sampler, TraceScratch& scratch,
              TraceCounters& counters) const override {
        return HallWalk<Transparency, Ambient>(scene_, tables_, basis_, wavelengths_, settings_,
                                               sampler, static_cast<HallScratch&>(scratch),
                                               counters)
            .run(ray);
    }

  private:
    const Scene& scene_;
    const SpectralBasis basis_;
    const RenderSettings settings_;
    const HallTables tables_;
    const WavelengthSampler wavelengths_;
};

template <bool Transparency, bool Ambient>
std::unique_ptr<Integrator> make(const Scene& scene, SpectralBasis basis,
                                 const RenderSettings& settings) {
    return std::make_unique<Hall<Transparency, Ambient>>(scene, std::move(basis), settings);
}

}  // namespace

std::unique_ptr<Integrator> make_hall(const Scene& scene, SpectralBasis basis,
                                      const RenderSettings& settings, HallFeatures features) {
    constexpr std::array kKernels{&make<false, false>, &make<false, true>, &make<true, false>,
                                  &make<true, true>};
    return kKernels[2U * (features.transparency ? 1 : 0) + (features.ambient ? 1 : 0)](
        scene, std::move(basis), settings);
}

HallFeatures choose_hall_features(const SceneNeeds& needs, const RenderSettings& settings) {
    if (!settings.specialise) return {};
    return {needs.transparency, needs.ambient};
}

std::string hall_kernel_name(HallFeatures features) {
    return std::string("hall<transparency=") + (features.transparency ? "1" : "0") +
           ",ambient=" + (features.ambient ? "1" : "0") + ">";
}

}  // namespace bouguer::renderer

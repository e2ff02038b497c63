// SPDX-License-Identifier: Apache-2.0
// What every integrator does: the colour that arrives along one camera ray.
#pragma once

#include <cstdint>
#include <memory>

#include "renderer/core/trace_limits.h"
#include "renderer/core/vec3.h"
#include "renderer/media/interface.h"
#include "renderer/samplers/pixel_sampler.h"
#include "renderer/scene/scene.h"
#include "renderer/settings.h"
#include "renderer/spectrum/spectral_basis.h"

namespace bouguer::renderer {

/// What happened on the way, for report and health. Added up over units.
struct TraceCounters {
    std::uint64_t rays = 0;
    std::uint64_t rays_cut_by_depth = 0, rays_cut_by_threshold = 0;
    double depth_throughput = 0, threshold_throughput = 0;  ///< weight in Y of what was cut
    double light = 0;                                       ///< Y of what the samples found
    double depth_light = 0, threshold_light = 0;  ///< Y that the cut rays may have carried
    std::uint64_t blackened_samples = 0;          ///< that found nothing, and were cut
    LostBodies lost_bodies;
    std::uint64_t medium_stack_overflows = 0, shadow_rays_cut = 0;
    std::uint64_t total_reflections = 0;
    TraceCounters& operator+=(const TraceCounters& other);
};

/// Working memory of one thread. Made once a unit, so that no sample allocates.
class TraceScratch {
  public:
    virtual ~TraceScratch() = default;

    TraceLimits limits;

    /// Once true, samples under way end early and what they give means nothing. Cheap enough for
    /// every ray.
    [[nodiscard]] bool has_given_up() {
        if (limits.give_up != nullptr && limits.give_up->load(std::memory_order_relaxed)) {
            return true;
        }
        return time() >= limits.give_up_at;
    }
    /// Whether it is time to leave off between two samples.
    [[nodiscard]] bool is_to_pause() { return time() >= limits.pause_at; }

  private:
    /// How often the time is asked for before the clock is looked at again.
    static constexpr std::uint32_t kAsksPerLook = 32;

    /// Some asks old.
    [[nodiscard]] TraceLimits::Clock::time_point time() {
        if (asks_++ % kAsksPerLook == 0) last_look_ = TraceLimits::Clock::now();
        return last_look_;
    }

    std::uint32_t asks_ = 0;
    TraceLimits::Clock::time_point last_look_;
};

/// Immutable and thread-safe; each thread brings its own scratch and counters.
class Integrator {
  public:
    virtual ~Integrator() = default;
    [[nodiscard]] virtual std::unique_ptr<TraceScratch> make_scratch() const = 0;
    /// XYZ of the radiance along `ray`. Pure function of scene, settings, ray and sampler.
    virtual Xyz trace(const Ray& ray, const PixelSampler& sampler, TraceScratch& scratch,
                      TraceCounters& counters) const = 0;
};

}  // namespace bouguer::renderer

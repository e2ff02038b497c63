// SPDX-License-Identifier: Apache-2.0
#include "renderer/integrators/integrator.h"

namespace bouguer::renderer {

TraceCounters& TraceCounters::operator+=(const TraceCounters& other) {
    rays += other.rays;
    rays_cut_by_depth += other.rays_cut_by_depth;
    rays_cut_by_threshold += other.rays_cut_by_threshold;
    depth_throughput += other.depth_throughput;
    threshold_throughput += other.threshold_throughput;
    light += other.light;
    depth_light += other.depth_light;
    threshold_light += other.threshold_light;
    blackened_samples += other.blackened_samples;
    for (const auto& [object, count] : other.lost_bodies) lost_bodies[object] += count;
    medium_stack_overflows += other.medium_stack_overflows;
    shadow_rays_cut += other.shadow_rays_cut;
    total_reflections += other.total_reflections;
    return *this;
}

}  // namespace bouguer::renderer

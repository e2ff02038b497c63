// SPDX-License-Identifier: Apache-2.0
#include "renderer/integrators/hall.h"

#include <algorithm>
#include <array>

#include "renderer/core/hash.h"
#include "renderer/integrators/hall_tables.h"
#include "renderer/media/medium_stack.h"
#include "renderer/media/refraction.h"
#include "renderer/samplers/warp.h"

namespace bouguer::renderer {
namespace {

/// Kinds of random numbers at one node of the tree of rays.
enum Dimension : std::uint64_t { kDimensionEnvironment = 1, kDimensionAmbient = 2 };

class HallScratch final : public TraceScratch {
  public:
    HallScratch(std::size_t blocks, int max_depth)
        : radiance(blocks),
          light(blocks),
          blocks_(blocks),
          throughput_(blocks * static_cast<std::size_t>(max_depth + 2)),
          peaks_(static_cast<std::size_t>(max_depth + 2)) {}

    /// The weight with which a ray of `depth` reaches the camera.
    Float8* throughput(int depth) {
        return throughput_.data() + blocks_ * static_cast<std::size_t>(depth);
    }

    /// The largest of its numbers, before absorption on the ray's own way.
    float& peak(int depth) { return peaks_[static_cast<std::size_t>(depth)]; }

    Float8Vector radiance;  ///< of the sample, so far
    Float8Vector light;     ///< tint of a shadow ray, or the ambient illuminant

  private:
    std::size_t blocks_;
    Float8Vector throughput_;
    std::vector<float> peaks_;
};

/// A hit seen from the side that the ray comes from.
struct SurfacePoint {
    Hit hit;
    const HallSurface* surface;
    std::uint64_t body;
    bool entering;  ///< the ray comes from outside the body
    bool is_sheet;
    Vec3 n, ng;  ///< shading and geometric normal, turned to the viewer
};

/// A length that stands for infinity where 0 * infinity must not arise: through it nothing comes
/// that is absorbed at all.
constexpr Real kEndless = 1e30;

constexpr std::uint64_t body_of(const Hit& hit) {
    return (std::uint64_t{hit.object} << 32U) | hit.instance;
}

/// One sample's walk through the tree of rays.
template <bool Transparency, bool Ambient>
class HallWalk {
  public:
    HallWalk(const Scene& scene, const HallTables& tables, const SpectralBasis& basis,
             const RenderSettings& settings, const PixelSampler& sampler, HallScratch& scratch,
             TraceCounters& counters)
        : scene_(scene),
          tables_(tables),
          basis_(basis),
          settings_(settings),
          sampler_(sampler),
          scratch_(scratch),
          counters_(counters),
          blocks_(tables.spectra.blocks()) {}

    Xyz run(const Ray& camera_ray) {
        std::fill(scratch_.radiance.begin(), scratch_.radiance.end(), splat(0));
        std::fill_n(scratch_.throughput(0), blocks_, splat(1));
        scratch_.peak(0) = 1;
        follow(camera_ray, 0, MediumStack{}, 1);
        return basis_.to_xyz(reinterpret_cast<const float*>(scratch_.radiance.data()));
    }

  private:
    /// Adds what arrives along `ray`, weighted by throughput(depth), to the sample. `node` names
    /// the place in the tree.
    void follow(const Ray& ray, int depth, MediumStack media, std::uint64_t node) {
        if (scratch_.has_given_up()) return;
        ++nodes_;
        ++counters_.rays;
        const auto hit = scene_.geometry().intersect(ray);
        if (!hit) {
            if constexpr (Transparency) {
                // Inside a body without end, or one that the ray slipped out of: nothing comes that
                // the body absorbs.
                if (media.innermost() != MediumStack::kOutside) ++counters_.unmatched_exits;
                absorb(media, kEndless, scratch_.throughput(depth));
            }
            if (tables_.environment) add(depth, 1, tables_.row(*tables_.environment));
            return;
        }
        const SurfacePoint at = describe(ray, *hit);
        if constexpr (Transparency) {
            if (began_inside(at, media) && depth > 0) ++counters_.unmatched_exits;
            absorb(media, hit->t, scratch_.throughput(depth));
        }
        add_lamps(at, depth, media);
        if (tables_.environment && !at.surface->mirror) add_environment(at, depth, media, node);
        if constexpr (Ambient) add_ambient(at, depth, node);
        spawn(ray, at, depth, media, node);
    }

    [[nodiscard]] SurfacePoint describe(const Ray& ray, const Hit& hit) const {
        SurfacePoint at{hit,
                        &tables_.surface_of(hit.object),
                        body_of(hit),
                        dot(ray.d, hit.ng) < 0,
                        tables_.object_is_sheet[hit.object],
                        hit.ns,
                        hit.ng};
        if (!at.entering) {
            at.n = -at.n;
            at.ng = -at.ng;
        }
        return at;
    }

    /// Whether the ray comes out of a body that it never entered. Then it was inside from its
    /// origin on: the camera may stand in a body, and of two bodies that touch the second is
    /// entered in the very point where the first is left.
    [[nodiscard]] static bool began_inside(const SurfacePoint& at, MediumStack& media) {
        const bool inside =
            !at.entering && !at.is_sheet && at.surface->transmits && !media.holds(at.body);
        if (inside) media.enter(at.body);
        return inside;
    }

    /// Equation 1 over a segment of length b inside the innermost body.
    void absorb(const MediumStack& media, Real b, Float8* weight) const {
        if (media.innermost() == MediumStack::kOutside) return;
        const HallSurface& inside =
            tables_.surface_of(static_cast<std::uint32_t>(media.innermost() >> 32U));
        if (!inside.absorbs) return;
        attenuate(weight, tables_.row(inside.log_transmittance), static_cast<float>(b), blocks_);
    }

    // ---- local terms ----

    /// radiance += throughput(depth) * scale * a * b * c
    void add(int depth, float scale, const Float8* a, const Float8* b = nullptr,
             const Float8* c = nullptr) {
        accumulate(scratch_.radiance.data(), scratch_.throughput(depth), scale, a, b, c, blocks_);
    }

    /// First terms of equations 3 and 4: every lamp by itself.
    void add_lamps(const SurfacePoint& at, int depth, const MediumStack& media) {
        for (std::size_t l = 0; l < scene_.lights().size() && !scratch_.has_given_up(); ++l) {
            const LightSample light = scene_.lights()[l].sample(at.hit.p);
            const Real cosine = dot(at.n, light.wi);
            const bool behind = cosine <= 0;
            // Where interpolated and real normal disagree on the side that the lamp is on, nothing
            // arrives: a ray to it would not go through the surface that the term is about.
            if (behind != (dot(at.ng, light.wi) <= 0)) continue;
            const float k = behind ? at.surface->k_st : at.surface->k_sr;
            if (k == 0 || cosine == 0 || light.scale == 0) continue;
            const auto scale =
                static_cast<float>(light.scale) * k * lobe(std::abs(cosine), at.surface->n);
            if (!(scale > 0)) continue;
            const Float8* emission = tables_.row(tables_.light_emission[l]);
            const Float8* factor =
                tables_.row(behind ? at.surface->transmittance : at.surface->reflectance);
            add_if_visible(at, light.wi, light.distance, behind, depth, media, scale, emission,
                           factor);
        }
    }

    /// The environment over the lobe (L.N)^n' by one direction drawn from it: the integral of the
    /// lobe is 2 pi / (n' + 1).
    void add_environment(const SurfacePoint& at, int depth, const MediumStack& media,
                         std::uint64_t node) {
        if (at.surface->k_sr == 0) return;
        const Vec2 u = sampler_.get_2d(mix(node) + kDimensionEnvironment);
        const Vec3 wi = Frame(at.n).to_world(sample_cosine_power(u, at.surface->n));
        if (dot(at.ng, wi) <= 0) return;
        const auto scale = static_cast<float>(at.surface->k_sr * 2 * kPi / (at.surface->n + 1));
        add_if_visible(at, wi, std::numeric_limits<Real>::infinity(), false, depth, media, scale,
                       tables_.row(*tables_.environment), tables_.row(at.surface->reflectance));
    }

    void add_if_visible(const SurfacePoint& at, Vec3 wi, Real distance, bool behind, int depth,
                        const MediumStack& media, float scale, const Float8* emission,
                        const Float8* factor) {
        const Ray shadow{leave_surface(at.hit, wi), wi};
        if constexpr (!Transparency) {
            ++counters_.rays;
            if (!scene_.geometry().occluded(shadow, distance)) add(depth, scale, emission, factor);
        } else {
            MediumStack on_path = media;
            if (behind) cross(at, on_path);
            bool tinted = false;
            if (!light_passes(shadow, distance, on_path, tinted)) return;
            if (tinted) {
                add(depth, scale, emission, factor, scratch_.light.data());
            } else {
                add(depth, scale, emission, factor);
            }
        }
    }

    /// Follows a shadow ray straight through transparent bodies. False: something opaque is in the
    /// way. When `tinted`, the transmittance of the way is in scratch.light.
    bool light_passes(Ray ray, Real distance, MediumStack media, bool& tinted) {
        Float8* tint = scratch_.light.data();
        for (int surfaces = 0; surfaces < kMaxShadowSurfaces; ++surfaces) {
            ++counters_.rays;
            const auto hit = scene_.geometry().intersect_within(ray, distance);
            if (!hit) {
                if (!tinted && media.innermost() == MediumStack::kOutside) return true;
                begin_tint(tint, tinted);
                absorb(media, std::min(distance, kEndless), tint);
                return true;
            }
            if (!tables_.surface_of(hit->object).transmits) return false;
            begin_tint(tint, tinted);
            const SurfacePoint at = describe(ray, *hit);
            if (began_inside(at, media)) ++counters_.unmatched_exits;
            absorb(media, hit->t, tint);
            multiply(tint, at.surface->k_st, tables_.row(at.surface->transmittance), blocks_);
            cross(at, media);
            ray.o = leave_surface(*hit, ray.d);
            distance -= hit->t;
        }
        ++counters_.shadow_rays_cut;
        return false;
    }

    void begin_tint(Float8* tint, bool& tinted) const {
        if (!tinted) std::fill_n(tint, blocks_, splat(1));
        tinted = true;
    }

    /// Second terms of equations 3 and 4: equation 2.
    void add_ambient(const SurfacePoint& at, int depth, std::uint64_t node) {
        if (!scene_.ambient()) return;
        const AmbientDescription& ambient = *scene_.ambient();
        const Float8* illuminant = ambient_illuminant(at.hit.p);
        const bool comes_out = !at.entering && at.surface->transmits && !at.is_sheet;
        const auto neighbour = [&](std::uint32_t object, Real weight) {
            const HallSurface& s = tables_.surface_of(object);
            add(depth, static_cast<float>(ambient.k_a * weight), illuminant,
                tables_.row(comes_out ? s.neighbour_transmittance : s.neighbour_reflectance));
        };
        if (const auto* given = std::get_if<ExplicitWeights>(&ambient.weights)) {
            for (std::uint32_t object = 0; object < given->k.size(); ++object) {
                if (object != at.hit.object && given->k[object] > 0)
                    neighbour(object, given->k[object]);
            }
            return;
        }
        // A point that weighs little in the sample gets few of the rays.
        const int most = std::get<HemisphereWeights>(ambient.weights).rays;
        const int rays =
            std::clamp(static_cast<int>(std::ceil(most * scratch_.peak(depth))), 1, most);
        const Frame frame(comes_out ? -at.n : at.n);
        for (int i = 0; i < rays; ++i) {
            const Vec2 u =
                sampler_.get_2d(mix(node) + kDimensionAmbient, static_cast<std::uint32_t>(i),
                                static_cast<std::uint32_t>(most));
            const Vec3 d = frame.to_world(sample_cosine_power(u, 1));
            ++counters_.rays;
            const auto seen = scene_.geometry().intersect({leave_surface(at.hit, d), d});
            if (seen && body_of(*seen) != at.body) neighbour(seen->object, 1.0 / rays);
        }
    }

    const Float8* ambient_illuminant(Vec3 p) {
        if (tables_.ambient_illuminant) return tables_.row(*tables_.ambient_illuminant);
        Float8* sum = scratch_.light.data();
        std::fill_n(sum, blocks_, splat(0));
        for (std::size_t l = 0; l < scene_.lights().size(); ++l) {
            const auto scale = static_cast<float>(scene_.lights()[l].sample(p).scale);
            accumulate(sum, scale, tables_.row(tables_.light_emission[l]), blocks_);
        }
        return sum;
    }

    // ---- recursive terms ----

    void spawn(const Ray& ray, const SurfacePoint& at, int depth, const MediumStack& media,
               std::uint64_t node) {
        const HallSurface& s = *at.surface;
        std::optional<Vec3> refracted;
        if constexpr (Transparency) {
            if (s.transmits) {
                MediumStack beyond = media;
                cross(at, beyond);
                refracted = refracted_direction(ray.d, at, media, beyond);
                if (refracted) {
                    const bool cut =
                        !weigh(depth, s.k_st, tables_.row(s.transmittance), 0, nullptr);
                    if (!cut)
                        follow({leave_surface(at.hit, *refracted), *refracted}, depth + 1, beyond,
                               mix(node + 1));
                } else {
                    ++counters_.total_reflections;
                }
            }
        }
        const bool total_reflection = Transparency && s.transmits && !refracted;
        if (!s.mirror && !total_reflection) return;
        const Vec3 reflected = reflected_direction(ray.d, at);
        const bool cut = !weigh(depth, s.mirror ? s.k_sr : 0, tables_.row(s.reflectance),
                                total_reflection ? s.k_st : 0, tables_.row(s.transmittance));
        if (!cut)
            follow({leave_surface(at.hit, reflected), reflected}, depth + 1, media, mix(node + 2));
    }

    /// throughput(depth + 1) = throughput(depth) * (ka a + kb b). False: the ray is not worth
    /// following or may not be; what it carries is booked.
    bool weigh(int depth, float ka, const Float8* a, float kb, const Float8* b) {
        Float8* to = scratch_.throughput(depth + 1);
        const float peak = blend(to, scratch_.throughput(depth), ka, a, kb, b, blocks_);
        scratch_.peak(depth + 1) = peak;
        if (peak == 0) return false;
        if (depth >= settings_.max_depth || nodes_ >= kMaxNodesPerSample) {
            ++counters_.rays_cut_by_depth;
            counters_.depth_throughput += luminous_weight(to);
            return false;
        }
        if (peak < settings_.min_throughput) {
            ++counters_.rays_cut_by_threshold;
            counters_.threshold_throughput += luminous_weight(to);
            return false;
        }
        return true;
    }

    /// Y of a throughput, as if light of constant spectrum and radiance 1 came that way.
    [[nodiscard]] double luminous_weight(const Float8* weight) const {
        return basis_.to_xyz(reinterpret_cast<const float*>(weight)).y;
    }

    /// The bodies around a ray once it has gone through the surface.
    void cross(const SurfacePoint& at, MediumStack& media) {
        if (at.is_sheet) return;
        if (!at.entering) {
            media.leave(at.body);
        } else if (!media.enter(at.body)) {
            ++counters_.medium_stack_overflows;
        }
    }

    [[nodiscard]] Real index_of(const MediumStack& media) const {
        if (media.innermost() == MediumStack::kOutside) return 1;
        return tables_.surface_of(static_cast<std::uint32_t>(media.innermost() >> 32U)).ior;
    }

    /// Interpolated normals can send a ray to the wrong side of the real surface; then the
    /// geometric normal decides.
    [[nodiscard]] static Vec3 reflected_direction(Vec3 d, const SurfacePoint& at) {
        const Vec3 r = reflect(d, at.n);
        return dot(r, at.ng) > 0 ? r : reflect(d, at.ng);
    }

    [[nodiscard]] std::optional<Vec3> refracted_direction(Vec3 d, const SurfacePoint& at,
                                                          const MediumStack& before,
                                                          const MediumStack& beyond) const {
        if (at.is_sheet) return d;
        const Real eta = index_of(before) / index_of(beyond);
        auto t = dot(d, at.n) < 0 ? refract(d, at.n, eta) : std::nullopt;
        if (!t || dot(*t, at.ng) >= 0) t = refract(d, at.ng, eta);
        return t;
    }

    const Scene& scene_;
    const HallTables& tables_;
    const SpectralBasis& basis_;
    const RenderSettings& settings_;
    const PixelSampler& sampler_;
    HallScratch& scratch_;
    TraceCounters& counters_;
    const std::size_t blocks_;
    int nodes_ = 0;
};

template <bool Transparency, bool Ambient>
class Hall final : public Integrator {
  public:
    Hall(const Scene& scene, SpectralBasis basis, const RenderSettings& settings)
        : scene_(scene), basis_(std::move(basis)), settings_(settings), tables_(scene, basis_) {}

    std::unique_ptr<TraceScratch> make_scratch() const override {
        return std::make_unique<HallScratch>(tables_.spectra.blocks(), settings_.max_depth);
    }

    Xyz trace(const Ray& ray, const PixelSampler& sampler, TraceScratch& scratch,
              TraceCounters& counters) const override {
        return HallWalk<Transparency, Ambient>(scene_, tables_, basis_, settings_, sampler,
                                               static_cast<HallScratch&>(scratch), counters)
            .run(ray);
    }

  private:
    const Scene& scene_;
    const SpectralBasis basis_;
    const RenderSettings settings_;
    const HallTables tables_;
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

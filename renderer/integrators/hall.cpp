// SPDX-License-Identifier: Apache-2.0
#include "renderer/integrators/hall.h"

#include <algorithm>
#include <array>

#include "renderer/integrators/hall_boundary.h"
#include "renderer/integrators/hall_path.h"
#include "renderer/integrators/hall_tables.h"
#include "renderer/samplers/warp.h"
#include "renderer/samplers/wavelength_sampler.h"

namespace bouguer::renderer {
namespace {

/// Kinds of random numbers: at one node of the tree of rays, or of a whole sample.
enum Dimension : std::uint64_t {
    kDimensionEnvironment = 1,
    kDimensionAmbient = 2,
    kDimensionWavelength = 3
};

/// A length that stands for infinity where 0 * infinity must not arise: through it nothing comes
/// that is absorbed at all.
constexpr Real kEndless = 1e30;

/// One sample's walk through the tree of rays.
template <bool Transparency, bool Ambient>
class HallWalk {
  public:
    HallWalk(const Scene& scene, const HallTables& tables, const SpectralBasis& basis,
             const WavelengthSampler& wavelengths, const RenderSettings& settings,
             const PixelSampler& sampler, HallScratch& scratch, TraceCounters& counters)
        : scene_(scene),
          tables_(tables),
          basis_(basis),
          wavelengths_(wavelengths),
          settings_(settings),
          sampler_(sampler),
          scratch_(scratch),
          counters_(counters),
          blocks_(tables.spectra.blocks()) {}

    Xyz run(const Ray& camera_ray) {
        std::fill(scratch_.radiance.begin(), scratch_.radiance.end(), splat(0));
        std::fill_n(scratch_.throughput(0), blocks_, splat(1));
        scratch_.peak(0) = 1;
        follow(camera_ray, Path{});
        return basis_.to_xyz(reinterpret_cast<const float*>(scratch_.radiance.data()));
    }

  private:
    /// Adds what arrives along `ray`, weighted by throughput(path.depth), to the sample.
    void follow(const Ray& ray, Path path) {
        if (scratch_.has_given_up()) return;
        ++nodes_;
        ++counters_.rays;
        const auto hit = scene_.geometry().intersect(ray);
        if (!hit) {
            if constexpr (Transparency) {
                // Inside a body without end, or one that the ray slipped out of: nothing comes that
                // the body absorbs.
                if (path.media.innermost() != MediumStack::kOutside) ++counters_.unmatched_exits;
                absorb(path.media, kEndless, scratch_.throughput(path.depth));
            }
            if (tables_.environment) add(path, 1, tables_.row(*tables_.environment));
            return;
        }
        const SurfacePoint at = describe(ray, *hit);
        if constexpr (Transparency) {
            if (began_inside(at, path.media) && path.depth > 0) ++counters_.unmatched_exits;
            absorb(path.media, hit->t, scratch_.throughput(path.depth));
        }
        if (at.surface->emission)
            add(path, 1, colours_at(at).row(*at.surface->emission, SurfaceColours::kFirst));
        add_lamps(at, path);
        if (tables_.environment) add_environment(at, path);
        if constexpr (Ambient) add_ambient(at, path);
        spawn(ray, at, path);
    }

    [[nodiscard]] SurfacePoint describe(const Ray& ray, const Hit& hit) const {
        SurfacePoint at{hit,
                        &tables_.surface_of(hit.object),
                        body_of(hit),
                        dot(ray.d, hit.ng) < 0,
                        tables_.object_is_sheet[hit.object],
                        hit.ns,
                        hit.ng,
                        -ray.d,
                        {}};
        if (!at.entering) {
            at.n = -at.n;
            at.ng = -at.ng;
        }
        if (at.surface->has_texture) at.uv = scene_.geometry().surface_uv(hit);
        return at;
    }

    SurfaceColours& colours_at(const SurfacePoint& at) {
        scratch_.colours.move_to(at.uv);
        return scratch_.colours;
    }

    /// Equation 1 over a segment of length b inside the innermost body.
    void absorb(const MediumStack& media, Real b, Float8* weight) const {
        const Surface* inside = inside_of(media, tables_);
        if (inside == nullptr || !inside->log_transmittance) return;
        attenuate(weight, tables_.spectra.split_row(*inside->log_transmittance), b, blocks_);
    }

    // ---- local terms ----

    /// radiance += throughput * scale * a * b * c
    void add(const Path& path, float scale, const Float8* a, const Float8* b = nullptr,
             const Float8* c = nullptr) {
        accumulate(scratch_.radiance.data(), scratch_.throughput(path.depth), scale, a, b, c,
                   blocks_);
    }

    /// First terms of equations 3 and 4: every lamp by itself.
    void add_lamps(const SurfacePoint& at, const Path& path) {
        for (std::size_t l = 0; l < scene_.lights().size() && !scratch_.has_given_up(); ++l) {
            const LightSample light = scene_.lights()[l].sample(at.hit.p);
            const Real cosine = dot(at.n, light.wi);
            const bool behind = cosine <= 0;
            // Where interpolated and real normal disagree on the side that the lamp is on, nothing
            // arrives: a ray to it would not go through the surface that the term is about.
            if (behind != (dot(at.ng, light.wi) <= 0)) continue;
            if (cosine == 0 || light.scale == 0) continue;
            const Response response =
                behind ? transmit(at, light.wi, path)
                       : at.surface->model->reflect(at.n, at.wo, light.wi, colours_at(at));
            add_if_visible(at, light.wi, light.distance, behind, path,
                           static_cast<float>(light.scale), tables_.row(tables_.light_emission[l]),
                           response);
        }
    }

    [[nodiscard]] Response transmit(const SurfacePoint& at, Vec3 wi, const Path& path) {
        if (!at.surface->transmits) return {};
        return at.surface->model->transmit(at.n, at.wo, wi, boundary_of(at, path.media, tables_),
                                           colours_at(at));
    }

    /// The environment, by one direction that the surface draws.
    void add_environment(const SurfacePoint& at, const Path& path) {
        const Vec2 u = sampler_.get_2d(mix(path.node) + kDimensionEnvironment);
        const auto sample = at.surface->model->sample(at.n, at.wo, u, colours_at(at));
        if (!sample || dot(at.ng, sample->wi) <= 0) return;
        add_if_visible(at, sample->wi, std::numeric_limits<Real>::infinity(), false, path, 1,
                       tables_.row(*tables_.environment), sample->response);
    }

    void add_if_visible(const SurfacePoint& at, Vec3 wi, Real distance, bool behind,
                        const Path& path, float scale, const Float8* emission,
                        const Response& response) {
        const auto gives = [&](const Term& term) { return scale * term.scale > 0; };
        if (std::none_of(response.begin(), response.end(), gives)) return;
        bool tinted = false;
        if (!arrives(at, wi, distance, behind, path.media, tinted)) return;
        for (const Term& term : response) {
            if (!gives(term)) continue;
            if (tinted) {
                add(path, scale * term.scale, emission, term.colour, scratch_.light.data());
            } else {
                add(path, scale * term.scale, emission, term.colour);
            }
        }
    }

    /// Whether light from wi gets to the point; what bodies on its way leave of it is in
    /// scratch.light when `tinted`.
    bool arrives(const SurfacePoint& at, Vec3 wi, Real distance, bool behind,
                 const MediumStack& media, bool& tinted) {
        const Ray shadow{leave_surface(at.hit, wi), wi};
        if constexpr (!Transparency) {
            ++counters_.rays;
            return !scene_.geometry().occluded(shadow, distance);
        }
        MediumStack on_path = media;
        if (behind) cross(at, on_path);
        return light_passes(shadow, distance, on_path, tinted);
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
            const Term through = shares(at, media, scratch_.colours_in_shadow).refracted;
            multiply(tint, through.scale, through.colour, blocks_);
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
    void add_ambient(const SurfacePoint& at, const Path& path) {
        if (!scene_.ambient()) return;
        const AmbientDescription& ambient = *scene_.ambient();
        const Float8* illuminant = ambient_illuminant(at.hit.p);
        const bool comes_out = at.comes_out();
        if (std::holds_alternative<ConstantWeights>(ambient.weights)) {
            if (comes_out) return;
            for (const Term& own : at.surface->model->ambient(colours_at(at))) {
                const float scale = static_cast<float>(ambient.k_a) * own.scale;
                if (scale > 0) add(path, scale, illuminant, own.colour);
            }
            return;
        }
        const auto neighbour = [&](std::uint32_t object, Real weight) {
            const Surface& s = tables_.surface_of(object);
            add(path, static_cast<float>(ambient.k_a * weight), illuminant,
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
            std::clamp(static_cast<int>(std::ceil(most * scratch_.peak(path.depth))), 1, most);
        const Frame frame(comes_out ? -at.n : at.n);
        for (int i = 0; i < rays; ++i) {
            const Vec2 u =
                sampler_.get_2d(mix(path.node) + kDimensionAmbient, static_cast<std::uint32_t>(i),
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

    void spawn(const Ray& ray, const SurfacePoint& at, const Path& path) {
        bool turned_back = false, parted = false;
        if constexpr (Transparency) {
            if (at.surface->transmits) {
                MediumStack beyond = path.media;
                cross(at, beyond);
                parted = !path.one_wavelength && !at.is_sheet &&
                         (disperses(path.media, tables_) || disperses(beyond, tables_));
                const auto refracted =
                    refracted_direction(ray.d, at, eta_of(at, path.media, beyond));
                if (refracted) {
                    follow_share(at, *refracted, path.next(beyond, 1, parted),
                                 shares(at, path.media).refracted, {}, parted);
                } else {
                    ++counters_.total_reflections;
                    turned_back = true;
                }
            }
        }
        if (!at.surface->mirror && !turned_back) return;
        const Vec3 reflected = reflected_direction(ray.d, at);
        // The share that is turned back goes with the mirrored ray, unless it is of one wavelength
        // and the other is not.
        if (turned_back && parted) {
            follow_share(at, reflected, path.next(path.media, 3, true),
                         shares(at, path.media).refracted, {}, true);
            turned_back = false;
            if (!at.surface->mirror) return;
        }
        const Shares share = shares(at, path.media);
        follow_share(at, reflected, path.next(path.media, 2, false),
                     at.surface->mirror ? share.reflected : Term{},
                     turned_back ? share.refracted : Term{}, false);
    }

    /// Sends a ray on with throughput(before) * (a + b); when `parted`, of one wavelength only.
    void follow_share(const SurfacePoint& at, Vec3 d, const Path& next, const Term& a,
                      const Term& b, bool parted) {
        if (weigh(next.depth, a, b, parted)) follow({leave_surface(at.hit, d), d}, next);
    }

    /// throughput(depth) = throughput(depth - 1) * (a + b). False: the ray is not worth following
    /// or may not be; what it carries is booked.
    bool weigh(int depth, const Term& a, const Term& b, bool parted) {
        if (a.scale == 0 && b.scale == 0) return false;
        Float8* to = scratch_.throughput(depth);
        const Term& first = a.scale == 0 ? b : a;
        float peak = blend(to, scratch_.throughput(depth - 1), first.scale, first.colour,
                           a.scale == 0 ? 0 : b.scale, b.colour, blocks_);
        if (parted) peak = keep_one_wavelength(to);
        scratch_.peak(depth) = peak;
        if (peak == 0) return false;
        if (depth > settings_.max_depth || nodes_ >= kMaxNodesPerSample) {
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

    /// Ends all wavelengths but the sample's own, which takes their place on average. Returns what
    /// it weighs.
    float keep_one_wavelength(Float8* row) {
        const WavelengthSample& kept = wavelength();
        auto* values = reinterpret_cast<float*>(row);
        const float weight = values[kept.node] * kept.inverse_probability;
        std::fill_n(row, blocks_, splat(0));
        values[kept.node] = weight;
        return weight;
    }

    /// The same for the whole tree of rays, so that branches which part in different places agree.
    const WavelengthSample& wavelength() {
        if (!wavelength_) wavelength_ = wavelengths_.sample(sampler_.get_2d(kDimensionWavelength));
        return *wavelength_;
    }

    /// Y of a throughput, as if light of constant spectrum and radiance 1 came that way.
    [[nodiscard]] double luminous_weight(const Float8* weight) const {
        return basis_.to_xyz(reinterpret_cast<const float*>(weight)).y;
    }

    // ---- boundaries ----

    /// The bodies around a ray once it has gone through the surface.
    void cross(const SurfacePoint& at, MediumStack& media) {
        if (!step_through(at, media)) ++counters_.medium_stack_overflows;
    }

    [[nodiscard]] Shares shares(const SurfacePoint& at, const MediumStack& media,
                                SurfaceColours& colours) const {
        colours.move_to(at.uv);
        return at.surface->model->shares(dot(at.n, at.wo), boundary_of(at, media, tables_),
                                         colours);
    }
    [[nodiscard]] Shares shares(const SurfacePoint& at, const MediumStack& media) {
        return shares(at, media, scratch_.colours);
    }

    /// Index before over index beyond, for the wavelength of the sample where it makes a
    /// difference.
    [[nodiscard]] Real eta_of(const SurfacePoint& at, const MediumStack& before,
                              const MediumStack& beyond) {
        return at.is_sheet ? 1 : index_of(before) / index_of(beyond);
    }

    [[nodiscard]] Real index_of(const MediumStack& media) {
        const Surface* inside = inside_of(media, tables_);
        if (inside == nullptr) return 1;
        return inside->dispersive_ior ? inside->dispersive_ior->at(wavelength().lambda_nm)
                                      : inside->ior;
    }

    const Scene& scene_;
    const HallTables& tables_;
    const SpectralBasis& basis_;
    const WavelengthSampler& wavelengths_;
    const RenderSettings& settings_;
    const PixelSampler& sampler_;
    HallScratch& scratch_;
    TraceCounters& counters_;
    const std::size_t blocks_;
    int nodes_ = 0;
    std::optional<WavelengthSample> wavelength_;  ///< drawn when first needed
};

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
        return std::make_unique<HallScratch>(tables_.spectra, settings_.max_depth);
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

// SPDX-License-Identifier: Apache-2.0
// The walk of the Hall kernel (see hall.h for what it computes).
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "renderer/integrators/hall.h"
#include "renderer/integrators/hall_boundary.h"
#include "renderer/integrators/hall_path.h"
#include "renderer/integrators/hall_tables.h"
#include "renderer/samplers/warp.h"
#include "renderer/samplers/wavelength_sampler.h"

namespace bouguer::renderer {

/// Kinds of random numbers: at one node of the tree of rays, or of a whole sample.
enum Dimension : std::uint64_t {
    kDimensionEnvironment = 1,
    kDimensionAmbient = 2,
    kDimensionWavelength = 3
};

/// A length that stands for infinity where 0 * infinity must not arise: through it nothing comes
/// that is absorbed at all.
constexpr Real kEndless = 1e30;
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

/// One sample's walk through the tree of rays, the heaviest ray first: what is left when the
/// sample ends early is what weighs least.
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
        scratch_.rays.clear();
        scratch_.interfaces.reset_counts();
        begin(camera_ray);
        while (!scratch_.rays.empty() && !scratch_.has_given_up()) {
            PendingRay& ray = scratch_.rays.take();
            if (is_negligible(ray.path)) {
                book(ray, counters_.rays_cut_by_threshold, cut_by_threshold_);
            } else {
                const float before = found_;
                const double weight = ray.path.weight;
                follow(ray);
                found_ = largest(scratch_.radiance.data(), blocks_);
                brightest_ = std::max(brightest_, (found_ - before) / weight);
            }
            scratch_.rays.release(ray);
        }
        return finish();
    }

  private:
    void begin(const Ray& camera_ray) {
        PendingRay& ray = scratch_.rays.open();
        ray.start = {};
        ray.start.p = camera_ray.o;
        ray.d = camera_ray.d;
        ray.path = {};
        if constexpr (Transparency) ray.path.media = camera_media(camera_ray.o);
        scratch_.rays.throughput(ray).set_to_ones();
        scratch_.rays.add(ray);
        brightest_ = static_cast<double>(tables_.brightest_emission);
    }

    /// The bodies that the camera stands in: for an orthographic one, at this ray.
    const MediumStack& camera_media(Vec3 p) {
        if (!scratch_.camera_at || *scratch_.camera_at != p) {
            scratch_.camera_at = p;
            scratch_.camera_media = tables_.bodies.around(p);
        }
        return scratch_.camera_media;
    }

    Xyz finish() {
        counters_.rays += scratch_.interfaces.queries();
        counters_.medium_stack_overflows += scratch_.interfaces.overflows();
        const Xyz value = basis_.to_xyz(reinterpret_cast<const float*>(scratch_.radiance.data()));
        counters_.light += value.y;
        counters_.depth_throughput += cut_by_depth_;
        counters_.threshold_throughput += cut_by_threshold_;
        counters_.depth_light += cut_by_depth_ * brightest_;
        counters_.threshold_light += cut_by_threshold_ * brightest_;
        if (found_ == 0 && cut_by_depth_ + cut_by_threshold_ > 0) ++counters_.blackened_samples;
        return value;
    }

    /// Adds what arrives along the ray to the sample, and sends on what goes on from there.
    void follow(PendingRay& ray) {
        ++nodes_;
        Path& path = ray.path;
        carried_ = &scratch_.rays.throughput(ray);
        SurfacePoint at;
        if (!find(ray.start, ray.d, kInfinity, path.media, at.face)) return leave_scene(ray);
        describe(ray.d, at);
        if constexpr (Transparency) {
            if (at.face.matter == Matter::Opaque) {
                absorb_to_end(path.media, {ray.start.p, ray.d}, at.face.hit.t, *carried_,
                              ends_at(at.face.hit));
            } else {
                absorb(path.media, at.face.hit.t, *carried_);
            }
        }
        if (at.surface->emission)
            add(1, colours_at(at).row(*at.surface->emission, SurfaceColours::kFirst));
        add_lamps(at, path);
        if (tables_.environment) add_environment(at, path);
        if constexpr (Ambient) add_ambient(at, path);
        spawn(ray, at);
    }

    void leave_scene(PendingRay& ray) {
        if constexpr (Transparency) {
            absorb_to_end(ray.path.media, {ray.start.p, ray.d}, kEndless, *carried_,
                          [&](BodyId body) { return tables_.bodies.may_leave_along(body, ray.d); });
        }
        if (tables_.environment) add(1, tables_.row(*tables_.environment));
    }

    /// The next interface along `d`; without transparency, the next surface.
    bool find(const RayStart& start, Vec3 d, Real t_max, MediumStack& media, Interface& face) {
        if constexpr (Transparency) {
            return scratch_.interfaces.next(start, d, t_max, media, face, counters_.lost_bodies);
        }
        ++counters_.rays;
        if (!scene_.geometry().nearest({start.origin(d), d}, t_max, face.hit)) return false;
        face.entering = dot(face.hit.ng, d) < 0;
        return true;
    }

    /// Fills all of `at` but its face.
    void describe(Vec3 d, SurfacePoint& at) const {
        const Hit& hit = at.face.hit;
        at.surface = &tables_.surface_of(hit.object);
        const Real side = dot(d, hit.ng) < 0 ? 1 : -1;
        at.n = side * hit.ns;
        at.ng = side * hit.ng;
        at.wo = -d;
        if (at.surface->has_texture) at.uv = scene_.geometry().surface_uv(hit);
    }

    SurfaceColours& colours_at(const SurfacePoint& at) {
        scratch_.colours.move_to(at.uv);
        return scratch_.colours;
    }

    /// Equation 1 over a segment of length b inside the body that is there.
    void absorb(const MediumStack& media, Real b, Throughput& throughput) const {
        const Surface* inside = inside_of(media, tables_);
        if (inside != nullptr && inside->absorption)
            throughput.absorb(*inside->absorption, tables_.spectra, b);
    }

    // ---- bodies that a ray lost track of ----

    /// Equation 1 over the last segment of a ray: a body that `may_end` denies has been left
    /// without meeting its surface. It is counted, and asked how far it reaches.
    template <class MayEnd>
    void absorb_to_end(MediumStack media, const Ray& ray, Real b, Throughput& throughput,
                       const MayEnd& may_end) {
        Real done = 0;
        while (media.current() != MediumStack::kOutside) {
            const BodyId body = media.current();
            Real end = b;
            if (!may_end(body)) {
                lose(body);
                end = std::min(tables_.bodies.way_inside(body, ray), b);
            }
            if (end > done) absorb(media, end - done, throughput);
            done = std::max(done, end);
            media.leave(body);
        }
    }

    void lose(BodyId body) { ++counters_.lost_bodies[tables_.bodies.object_of(body)]; }

    /// A ray to a lamp ends at `hit`.
    void note_end(const MediumStack& media, const Hit& hit) {
        const auto may_end = ends_at(hit);
        for (const BodyId body : media) {
            if (!may_end(body)) lose(body);
        }
    }

    /// Whether a ray in a body may end at `hit`.
    auto ends_at(const Hit& hit) const {
        return [this, &hit](BodyId body) {
            return tables_.bodies.may_end_at(body, hit.p, scene_.geometry().reach(hit));
        };
    }

    /// The same of a ray that gets to a lamp.
    auto ends_at_lamp(const Ray& ray, Real distance) const {
        return [this, ray, distance](BodyId body) {
            return distance == kInfinity
                       ? tables_.bodies.may_leave_along(body, ray.d)
                       : tables_.bodies.may_end_at(body, ray.at(distance), 1e-6 * distance);
        };
    }

    // ---- local terms ----

    /// radiance += throughput * tint * scale * a * b
    void add(double scale, const Float8* a, const Float8* b = nullptr,
             const Throughput* tint = nullptr) {
        carried_->accumulate(scratch_.radiance.data(), scale, a, b, tint);
    }

    /// First terms of equations 3 and 4: every lamp by itself.
    void add_lamps(const SurfacePoint& at, const Path& path) {
        for (std::size_t l = 0; l < scene_.lights().size() && !scratch_.has_given_up(); ++l) {
            const LightSample light = scene_.lights()[l].sample(at.face.hit.p);
            const Real cosine = dot(at.n, light.wi);
            const bool behind = cosine <= 0;
            // Where interpolated and real normal disagree on the side that the lamp is on, a ray to
            // it would not go through the surface that the term is about. On what is opaque the
            // smooth surface decides, from which rays to lamps start.
            const bool disagree = behind != (dot(at.ng, light.wi) <= 0);
            if (disagree && (behind || at.face.matter != Matter::Opaque)) continue;
            if (cosine == 0 || light.scale == 0) continue;
            const Response response =
                behind ? transmit(at, light.wi, path)
                       : at.surface->model->reflect(at.n, at.wo, light.wi, colours_at(at));
            add_if_visible(at, light.wi, light.distance, behind, path.media, light.scale,
                           tables_.row(tables_.light_emission[l]), response);
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
        add_if_visible(at, sample->wi, kInfinity, false, path.media, 1,
                       tables_.row(*tables_.environment), sample->response);
    }

    void add_if_visible(const SurfacePoint& at, Vec3 wi, Real distance, bool behind,
                        const MediumStack& media, double scale, const Float8* emission,
                        const Response& response) {
        const auto gives = [&](const Term& term) {
            return scale * static_cast<double>(term.scale) > 0;
        };
        if (std::none_of(response.begin(), response.end(), gives)) return;
        bool is_tinted = false;
        if (!arrives(at, wi, distance, behind, media, is_tinted)) return;
        for (const Term& term : response) {
            if (!gives(term)) continue;
            add(scale * static_cast<double>(term.scale), emission, term.colour,
                is_tinted ? &scratch_.tint : nullptr);
        }
    }

    /// Whether light from wi gets to the point; if tinted, then by scratch.tint.
    bool arrives(const SurfacePoint& at, Vec3 wi, Real distance, bool behind,
                 const MediumStack& media, bool& is_tinted) {
        RayStart start = at.face.start(behind);
        const Vec3 lamp = start.p + distance * wi;  // if it is not infinitely far
        if (at.face.matter == Matter::Opaque && !at.face.is_crowded) start_from_smooth(at, start);
        if constexpr (!Transparency) {
            ++counters_.rays;
            const Vec3 o = start.origin(wi);
            if (distance == kInfinity) return !scene_.geometry().occluded({o, wi}, distance);
            const Real way = length(lamp - o);
            return !scene_.geometry().occluded({o, (lamp - o) / way}, way);
        }
        const Vec3 moved = start.p - at.face.hit.p;
        if (moved == Vec3{})
            return light_passes(start, wi, distance, behind ? at.face.beyond : media, is_tinted);
        if (distance != kInfinity) {
            distance = length(lamp - start.p);
            wi = (lamp - start.p) / distance;
        }
        // Other bodies may be there, where the surface comes out of one.
        const bool may_differ = tables_.bodies.is_near_others(at.face.hit, length(moved));
        return light_passes(start, wi, distance,
                            may_differ ? tables_.bodies.around(start.p) : media, is_tinted);
    }

    /// Rays to lamps leave the smooth surface that a mesh stands for, not its facets.
    void start_from_smooth(const SurfacePoint& at, RayStart& start) const {
        start.p = scene_.geometry().smooth_point(at.face.hit);
        if (start.p != at.face.hit.p) start.ng = at.n;
    }

    /// Follows a ray to a lamp straight through transparent bodies. False: something opaque is in
    /// the way.
    bool light_passes(RayStart start, Vec3 wi, Real distance, MediumStack media, bool& is_tinted) {
        for (int surfaces = 0; surfaces < kMaxShadowSurfaces; ++surfaces) {
            SurfacePoint at;
            if (!find(start, wi, distance, media, at.face)) {
                if (media.current() == MediumStack::kOutside) return true;
                begin_tint(is_tinted);
                absorb_to_end(media, {start.p, wi}, std::min(distance, kEndless), scratch_.tint,
                              ends_at_lamp({start.p, wi}, distance));
                return true;
            }
            if (at.face.matter == Matter::Opaque) {
                note_end(media, at.face.hit);
                return false;
            }
            begin_tint(is_tinted);
            describe(wi, at);
            absorb(media, at.face.hit.t, scratch_.tint);
            const Term through = shares(at, media, scratch_.colours_in_shadow).refracted;
            if (through.scale == 0) return false;
            scratch_.tint.multiply(through);
            media = at.face.beyond;
            start = at.face.start(true);
            distance -= at.face.hit.t;
        }
        ++counters_.shadow_rays_cut;
        return false;
    }

    void begin_tint(bool& is_tinted) const {
        if (!is_tinted) scratch_.tint.set_to_ones();
        is_tinted = true;
    }

    /// Second terms of equations 3 and 4: equation 2.
    void add_ambient(const SurfacePoint& at, const Path& path) {
        if (!scene_.ambient()) return;
        const AmbientDescription& ambient = *scene_.ambient();
        const Hit& hit = at.face.hit;
        const Float8* illuminant = ambient_illuminant(hit.p);
        const bool comes_out = at.comes_out();
        if (std::holds_alternative<ConstantWeights>(ambient.weights)) {
            if (comes_out) return;
            for (const Term& own : at.surface->model->ambient(colours_at(at))) {
                const double scale = ambient.k_a * static_cast<double>(own.scale);
                if (scale > 0) add(scale, illuminant, own.colour);
            }
            return;
        }
        const auto neighbour = [&](std::uint32_t object, Real weight) {
            const Surface& s = tables_.surface_of(object);
            add(ambient.k_a * weight, illuminant,
                tables_.row(comes_out ? s.neighbour_transmittance : s.neighbour_reflectance));
        };
        if (const auto* given = std::get_if<ExplicitWeights>(&ambient.weights)) {
            for (std::uint32_t object = 0; object < given->k.size(); ++object) {
                if (object != hit.object && given->k[object] > 0)
                    neighbour(object, given->k[object]);
            }
            return;
        }
        // A point that weighs little in the sample gets few of the rays.
        const int most = std::get<HemisphereWeights>(ambient.weights).rays;
        const int rays = static_cast<int>(
            std::clamp(std::ceil(most * path.weight), 1.0, static_cast<double>(most)));
        const Frame frame(comes_out ? -at.n : at.n);
        for (int i = 0; i < rays; ++i) {
            const Vec2 u =
                sampler_.get_2d(mix(path.node) + kDimensionAmbient, static_cast<std::uint32_t>(i),
                                static_cast<std::uint32_t>(most));
            const Vec3 d = frame.to_world(sample_cosine_power(u, 1));
            ++counters_.rays;
            const auto seen = scene_.geometry().intersect({leave_surface(hit, d), d});
            if (seen && (seen->object != hit.object || seen->instance != hit.instance))
                neighbour(seen->object, 1.0 / rays);
        }
    }

    const Float8* ambient_illuminant(Vec3 p) {
        if (tables_.ambient_illuminant) return tables_.row(*tables_.ambient_illuminant);
        Float8* sum = scratch_.numbers.data();
        std::fill_n(sum, blocks_, splat(0));
        for (std::size_t l = 0; l < scene_.lights().size(); ++l) {
            const auto scale = static_cast<float>(scene_.lights()[l].sample(p).scale);
            accumulate(sum, scale, tables_.row(tables_.light_emission[l]), blocks_);
        }
        return sum;
    }

    // ---- recursive terms ----

    void spawn(const PendingRay& ray, const SurfacePoint& at) {
        const Path& path = ray.path;
        bool turned_back = false, parted = false;
        if constexpr (Transparency) {
            if (at.surface->transmits) {
                const MediumStack& beyond = at.face.beyond;
                parted = !path.one_wavelength && !at.is_sheet() &&
                         (disperses(path.media, tables_) || disperses(beyond, tables_));
                const auto refracted =
                    refracted_direction(ray.d, at, eta_of(at, path.media, beyond));
                if (refracted) {
                    send(ray, at, {*refracted, &beyond, 1, true, parted},
                         shares(at, path.media).refracted, {});
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
            send(ray, at, {reflected, &path.media, 3, false, true},
                 shares(at, path.media).refracted, {});
            turned_back = false;
            if (!at.surface->mirror) return;
        }
        const Shares share = shares(at, path.media);
        send(ray, at, {reflected, &path.media, 2, false, false},
             at.surface->mirror ? share.reflected : Term{}, turned_back ? share.refracted : Term{});
    }

    /// Where a ray goes on from a surface.
    struct Way {
        Vec3 d;
        const MediumStack* media;
        std::uint64_t number;  ///< tells the rays apart that leave one point
        bool goes_through;
        bool parted;  ///< with one wavelength only
    };

    /// Sends a ray on with the weight of `from` times (a + b). What may not be followed is booked.
    void send(const PendingRay& from, const SurfacePoint& at, const Way& way, const Term& a,
              const Term& b) {
        if (a.scale == 0 && b.scale == 0) return;
        PendingRay& ray = scratch_.rays.open();
        const Path& path = from.path;
        Throughput& throughput = scratch_.rays.throughput(ray);
        double weight = throughput.blend(*carried_, a, b);
        if (way.parted)
            weight = throughput.keep(wavelength().node, wavelength().inverse_probability);
        ray.path = {path.depth + 1, mix(path.node + way.number), *way.media,
                    path.one_wavelength || way.parted, weight};
        if (weight == 0) return scratch_.rays.release(ray);
        if (ray.path.depth > settings_.max_depth || nodes_ >= kMaxNodesPerSample) {
            book(ray, counters_.rays_cut_by_depth, cut_by_depth_);
            return scratch_.rays.release(ray);
        }
        ray.start = at.face.start(way.goes_through);
        ray.d = way.d;
        scratch_.rays.add(ray);
    }

    /// Whether a ray can add little to what the sample has found, judged by the brightest light
    /// that the sample and the scene have shown.
    [[nodiscard]] bool is_negligible(const Path& path) const {
        return path.weight * brightest_ < settings_.min_throughput * static_cast<double>(found_);
    }

    /// Counts a ray that is not followed.
    void book(const PendingRay& ray, std::uint64_t& count, double& weight) {
        ++count;
        weight += luminous_weight(scratch_.rays.throughput(ray));
    }

    /// The one that takes the place of all others where they part. The same for the whole tree of
    /// rays, so that branches which part in different places agree.
    const WavelengthSample& wavelength() {
        if (!wavelength_) wavelength_ = wavelengths_.sample(sampler_.get_2d(kDimensionWavelength));
        return *wavelength_;
    }

    /// Y of a throughput, as if light of constant spectrum and radiance 1 came that way.
    [[nodiscard]] double luminous_weight(const Throughput& throughput) const {
        const double factor = throughput.normalise(scratch_.numbers);
        if (factor == 0) return 0;
        return factor * basis_.to_xyz(reinterpret_cast<const float*>(scratch_.numbers.data())).y;
    }

    // ---- boundaries ----

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
        return at.is_sheet() ? 1 : index_of(before) / index_of(beyond);
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
    Throughput* carried_ = nullptr;  ///< by the ray that is followed
    int nodes_ = 0;
    float found_ = 0;       ///< the largest number of the sample's radiance so far
    double brightest_ = 0;  ///< the most that a ray of weight 1 has found or may find
    double cut_by_depth_ = 0, cut_by_threshold_ = 0;  ///< weights in Y
    std::optional<WavelengthSample> wavelength_;      ///< drawn when first needed
};

}  // namespace bouguer::renderer

// SPDX-License-Identifier: Apache-2.0
// The facade: build a scene, render units, read the film. What the api and the server know of the
// renderer.
//
//     auto scene = build_scene(description);                      // once; shared by jobs
//     auto render = Render::create(*scene, settings, stop);
//     while (auto unit = render->next_unit()) {                   // any thread, under a lock
//         render->trace(*unit);                                   // outside the lock
//         render->merge(*unit, seconds_so_far);
//     }
//     auto picture = render->picture();
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/core/trace_limits.h"
#include "renderer/report.h"
#include "renderer/scene/description.h"
#include "renderer/settings.h"

namespace bouguer::renderer {

class Scene;       // scene/scene.h: immutable, thread-safe
class UnitResult;  // film/unit_result.h: include it where units are traced

/// Error{InvalidInput}: a value that only the renderer can judge. Error{Internal}: memory.
[[nodiscard]] Result<std::shared_ptr<const Scene>> build_scene(const SceneDescription& description);

/// What `scene` needs under `settings`; no ray is shot.
[[nodiscard]] Plan make_plan(const Scene& scene, const RenderSettings& settings);

/// The smallest piece of work: one tile x one range of samples. Same scene, settings and unit: same
/// bits.
struct Unit {
    std::uint32_t pass = 0;
    int x = 0, y = 0, width = 0, height = 0;  ///< tile, pixels of the full resolution
    std::uint32_t first_sample = 0, num_samples = 0;
};

/// The picture as linear floats, [height][width][3], row 0 on top.
struct Picture {
    int width = 0, height = 0;
    std::vector<float> xyz;  ///< CIE XYZ normalised as in spectrum/colour.h
};

/// A render under way. NOT thread-safe except trace(), which is const and may run on any number of
/// threads at once; everything else is called under the owner's lock.
class Render {
  public:
    [[nodiscard]] static Result<std::unique_ptr<Render>> create(std::shared_ptr<const Scene> scene,
                                                                const RenderSettings& settings,
                                                                const StopRule& stop);
    virtual ~Render() = default;

    /// The next unit of the current pass, one that was given back before all others; null when the
    /// pass has none left to hand out (others may still be running) or the render has ended. The
    /// next pass begins once every unit of this one was merged.
    [[nodiscard]] virtual std::shared_ptr<UnitResult> next_unit() = 0;
    /// Goes on with `unit` to its end or as far as `limits` let it. A complete unit is a pure
    /// function of scene, settings and unit.
    virtual void trace(UnitResult& unit, const TraceLimits& limits = {}) const = 0;
    /// Takes a complete unit; `seconds` is the wall time since the render began. Returns whether
    /// this ended a pass: then the picture is complete, the error curve has a new point, and the
    /// stop rule was consulted.
    virtual bool merge(const UnitResult& unit, double seconds) = 0;
    /// Hands back a unit that is not complete.
    virtual void give_back(std::shared_ptr<UnitResult> unit) = 0;

    /// The moment, in seconds since the render began, when the owner gives up what is under way and
    /// calls end_late(): the time that the stop rule allows and half a second in which a pass may
    /// still come to its end. Empty: never.
    [[nodiscard]] virtual std::optional<double> deadline_s() const = 0;
    /// Ends a render that is late. No unit is under way: all that were handed out came back. In the
    /// first pass the picture becomes what there is of it, and the report says so
    /// (Health::unfinished_pass); later the newest complete pass stays, whose error is known.
    virtual void end_late() = 0;

    [[nodiscard]] virtual bool finished() const = 0;
    [[nodiscard]] virtual std::uint32_t current_pass() const = 0;
    [[nodiscard]] virtual bool has_units() const = 0;  ///< whether next_unit() would give one
    /// Share of the work done, [0, 1], by the stop rule that is nearest.
    [[nodiscard]] virtual double progress(double seconds) const = 0;
    [[nodiscard]] virtual std::uint32_t samples_done() const = 0;  ///< a pixel, complete passes
    [[nodiscard]] virtual std::uint64_t rays() const = 0;          ///< of units given back, too
    /// Rays counted, error(t), health, plan, bias, stopped_by. Timings are the caller's.
    [[nodiscard]] virtual Report report() const = 0;
    /// The newest complete pass, or after end_late() what there is of the first. Null before.
    [[nodiscard]] virtual std::shared_ptr<const Picture> picture() const = 0;
};

/// The file bytes of a picture; deterministic: equal pictures give equal bytes.
[[nodiscard]] Result<std::string> encode_png(const Picture& picture, const OutputSettings& output,
                                             ImageInfo* info = nullptr);
[[nodiscard]] Result<std::string> encode_exr(const Picture& picture, const OutputSettings& output);

/// "Embree 3.13.5", "OpenImageIO 2.4.7" ...
[[nodiscard]] std::vector<std::string> library_versions();

}  // namespace bouguer::renderer

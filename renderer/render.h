// SPDX-License-Identifier: Apache-2.0
// The facade: build a scene, render units, read the film. What the api and the server know of the
// renderer.
//
//     auto scene = build_scene(description);                      // once; shared by jobs
//     auto render = Render::create(*scene, settings, stop);
//     while (auto unit = render->next_unit())                     // any thread, under the caller's
//     lock
//         render->merge(render->trace(*unit), seconds_so_far);    // trace() outside the lock
//     Picture picture = render->picture(output);
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/core/result.h"
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

    /// The next unit of the current pass; empty when the pass has none left to hand out (others may
    /// still be running) or the render has ended. The next pass begins once every unit of this one
    /// was merged.
    [[nodiscard]] virtual std::optional<Unit> next_unit() = 0;
    /// Pure function of scene, settings and unit. When `give_up`, which may be null, becomes true,
    /// it returns null within the time of a few rays.
    [[nodiscard]] virtual std::unique_ptr<UnitResult> trace(
        const Unit& unit, const std::atomic<bool>* give_up = nullptr) const = 0;
    /// Takes a unit's result; `seconds` is the wall time since the render began. Returns whether
    /// this ended a pass: then the picture is complete, the error curve has a new point, and the
    /// stop rule was consulted.
    virtual bool merge(std::unique_ptr<UnitResult> result, double seconds) = 0;
    /// Hands back a unit that was taken and will not be traced (its worker stops); it will be
    /// handed out again.
    virtual void give_back(const Unit& unit) = 0;

    [[nodiscard]] virtual bool finished() const = 0;
    [[nodiscard]] virtual std::uint32_t current_pass() const = 0;
    [[nodiscard]] virtual bool has_units() const = 0;  ///< whether next_unit() would give one
    /// Share of the work done, [0, 1], by the stop rule that is nearest.
    [[nodiscard]] virtual double progress(double seconds) const = 0;
    [[nodiscard]] virtual std::uint32_t samples_done() const = 0;  ///< a pixel, complete passes
    [[nodiscard]] virtual std::uint64_t rays() const = 0;
    /// Rays counted, error(t), health, plan, bias, stopped_by. Timings are the caller's.
    [[nodiscard]] virtual Report report() const = 0;
    /// The newest complete pass. Empty before the first.
    [[nodiscard]] virtual std::optional<Picture> picture() const = 0;
};

/// The file bytes of a picture; deterministic: equal pictures give equal bytes.
[[nodiscard]] Result<std::string> encode_png(const Picture& picture, const OutputSettings& output,
                                             ImageInfo* info = nullptr);
[[nodiscard]] Result<std::string> encode_exr(const Picture& picture, const OutputSettings& output);

/// "Embree 3.13.5", "OpenImageIO 2.4.7" ...
[[nodiscard]] std::vector<std::string> library_versions();

}  // namespace bouguer::renderer

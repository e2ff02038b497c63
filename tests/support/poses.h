// SPDX-License-Identifier: Apache-2.0
// Places and sizes in which a scene must look the same.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/support/hall_look.h"

namespace bouguer::renderer::test {

/// A turn, a size and a place, and what it makes of points and directions.
struct Pose {
    const char* name;
    Real scale = 1;
    Transform transform;
    /// Radius of a sphere about zero that the scene also has; 0: none.
    Real companion = 0;

    [[nodiscard]] Vec3 point(Vec3 p) const { return transform.point(p); }
    [[nodiscard]] Vec3 direction(Vec3 d) const { return normalize(transform.direction(d)); }
};

/// Every pose; pose_name() names the instances of a test.
[[nodiscard]] std::vector<Pose> poses();
inline std::string pose_name(const testing::TestParamInfo<Pose>& param) { return param.param.name; }

/// A scene in a pose: bodies, lamps and looks are given in the coordinates that the pose moves.
class PosedScene {
  public:
    explicit PosedScene(Pose pose);

    /// `spin_rad` turns the shape about z first.
    PosedScene& add(Shape shape, HallMaterial material, int priority = 0, Real spin_rad = 0);
    PosedScene& place(PlacedShape placed, HallMaterial material, int priority = 0,
                      Real spin_rad = 0);
    PosedScene& sun(Vec3 direction, double irradiance = 1);
    /// `intensity` by the distance in the coordinates that the pose moves.
    PosedScene& lamp(Vec3 position, double intensity = 1);
    /// Before anything else is added: what else the scene has is as bright.
    PosedScene& environment(double radiance = 1);
    /// What the last body gives out by itself.
    PosedScene& shining(double radiance);

    [[nodiscard]] Seen look(Vec3 from, Vec3 at);

    SceneBuilder builder;

  private:
    Pose pose_;
    std::shared_ptr<const Scene> scene_;
};

}  // namespace bouguer::renderer::test

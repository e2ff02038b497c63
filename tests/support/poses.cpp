// SPDX-License-Identifier: Apache-2.0
#include "tests/support/poses.h"

namespace bouguer::renderer::test {

std::vector<Pose> poses() {
    const Transform turn = Transform::rotate({1, 2, 3}, 0.7);
    const auto sized = [](Real s) { return Transform::scale({s, s, s}); };
    return {{"AsItIs", 1, {}},
            {"Turned", 1, Transform::translate({0.3, -0.2, 0.9}) * turn},
            {"Small", 1e-4, turn * sized(1e-4)},
            {"Large", 1e5, Transform::translate({3e5, 1e5, 2e5}) * turn * sized(1e5)},
            {"FarFromZero", 1, Transform::translate({1e4, -2e4, 3e4}) * turn},
            {"FarFromAnother", 1, Transform::translate({1e4, -2e4, 3e4}) * turn, 1},
            {"BesideAPlanet", 1, Transform::translate({1e4, 1e4, 1e4}), 1e4}};
}

PosedScene::PosedScene(Pose pose) : pose_(std::move(pose)) {
    if (pose_.companion > 0) builder.add(Sphere{{0, 0, 0}, pose_.companion}, matt(0));
    builder.description.metres_per_unit = 1 / pose_.scale;
}

PosedScene& PosedScene::add(Shape shape, HallMaterial material, int priority, Real spin_rad) {
    return place({std::move(shape)}, std::move(material), priority, spin_rad);
}

PosedScene& PosedScene::place(PlacedShape placed, HallMaterial material, int priority,
                              Real spin_rad) {
    for (Transform& t : placed.instances)
        t = pose_.transform * t * Transform::rotate({0, 0, 1}, spin_rad);
    if (material.absorption) material.absorption->thickness *= pose_.scale;
    builder.place(std::move(placed), std::move(material), priority);
    return *this;
}

PosedScene& PosedScene::sun(Vec3 direction, double irradiance) {
    builder.light(test::sun(pose_.direction(direction), irradiance));
    return *this;
}

PosedScene& PosedScene::lamp(Vec3 position, double intensity) {
    builder.light(PointLight{pose_.point(position), constant_spectrum(intensity)});
    return *this;
}

PosedScene& PosedScene::environment(double radiance) {
    if (pose_.companion > 0) shining(radiance);
    builder.description.environment = ConstantEnvironment{constant_spectrum(radiance)};
    return *this;
}

PosedScene& PosedScene::shining(double radiance) {
    builder.description.materials.back().emission = constant_spectrum(radiance);
    return *this;
}

Seen PosedScene::look(Vec3 from, Vec3 at) {
    if (!scene_) scene_ = builder.build();
    return test::look(*scene_, pose_.point(from), pose_.point(at));
}

}  // namespace bouguer::renderer::test

// SPDX-License-Identifier: Apache-2.0
#include "renderer/media/body_table.h"

#include <algorithm>

#include "tests/renderer/geometry/geometry_testing.h"
#include "tests/support/meshes.h"

namespace bouguer::renderer {
namespace {

using test::build;

BodyDescription body(int priority = 0, std::uint32_t instances = 1) {
    BodyDescription description;
    description.matter = Matter::Body;
    description.priority = priority;
    description.instances = instances;
    return description;
}

BodyDescription matter(Matter of) {
    BodyDescription description;
    description.matter = of;
    return description;
}

/// Three spheres of radius 1 that overlap about zero.
std::vector<PlacedShape> overlapping() {
    return {{Sphere{{-0.5, 0, 0}, 1}}, {Sphere{{0, 0.5, 0}, 1}}, {Sphere{{0.5, 0, 0}, 1}}};
}

/// The object that is at a point; -1: none.
int object_at(const BodyTable& table, const Geometry& g, Vec3 p) {
    const BodyId current = table.around(p - g.origin()).current();
    return current == MediumStack::kOutside ? -1 : static_cast<int>(table.object_of(current));
}

TEST(BodyTable, TheHighestPriorityIsThere) {
    const auto g = build(overlapping());
    const auto at = [&](int a, int b, int c, Vec3 p) {
        return object_at(BodyTable(std::vector{body(a), body(b), body(c)}, *g), *g, p);
    };
    EXPECT_EQ(at(0, 1, 2, {}), 2);
    EXPECT_EQ(at(0, 2, 1, {}), 1);
    EXPECT_EQ(at(-1, -3, -2, {}), 0);
    EXPECT_EQ(at(0, 1, 2, {-0.7, 0.1, 0}), 1);  // of the first two
    EXPECT_EQ(at(0, 1, 2, {-1.4, 0, 0}), 0);
    EXPECT_EQ(at(0, 1, 2, {0, -2, 0}), -1);
}

TEST(BodyTable, AtEqualPriorityTheFirstIsThere) {
    const auto g = build(overlapping());
    const BodyTable equal(std::vector{body(), body(), body()}, *g);
    EXPECT_EQ(object_at(equal, *g, {}), 0);
    EXPECT_EQ(object_at(equal, *g, {0.7, 0.1, 0}), 1);
    const BodyTable mixed(std::vector{body(0), body(1), body(1)}, *g);
    EXPECT_EQ(object_at(mixed, *g, {}), 1);
}

TEST(BodyTable, OfTheInstancesOfOneObjectTheFirstIsThere) {
    const std::vector<PlacedShape> shapes{
        {Box{{5, -1, -1}, {7, 1, 1}}},
        {Sphere{}, {Transform::translate({0.5, 0, 0}), Transform::translate({-0.5, 0, 0})}}};
    const auto g = build(shapes);
    const BodyTable table(std::vector{body(), body(0, 2)}, *g);
    const auto hit = [&](Vec3 from, Vec3 d) {
        return table.body_of(*g->intersect({from - g->origin(), d}));
    };
    const BodyId right = hit({4, 0, 0}, {-1, 0, 0}), left = hit({-4, 0, 0}, {1, 0, 0});
    EXPECT_EQ(hit({6, 0, 9}, {0, 0, -1}), 0U);
    EXPECT_EQ(right, 1U);
    EXPECT_EQ(left, 2U);
    EXPECT_EQ(table.object_of(right), 1U);
    EXPECT_EQ(table.object_of(left), 1U);
    const MediumStack media = table.around(-g->origin());
    EXPECT_EQ(media.current(), right);
    EXPECT_TRUE(media.holds(left));
    EXPECT_EQ(table.around(Vec3{-1, 0, 0} - g->origin()).current(), left);
}

// Camera and lamps may begin in any of them.
TEST(BodyTable, KnowsTheBodiesAroundAPointForEveryShape) {
    const std::vector<PlacedShape> shapes{
        {Plane{{0, 0.5, 0}, {0, 1, 0}}},   {Box{{-1, -1, -1}, {1, 1, 1}}},
        {Cylinder{{0, -1, 0}, {0, 1, 0}}}, {test::icosphere(2)},
        {Disk{{}, {0, 1, 0}, 3}},          {Sphere{{}, 0.5}}};
    const auto g = build(shapes);
    std::vector<BodyDescription> objects(shapes.size(), body());
    objects[4] = matter(Matter::Sheet);
    objects[5] = matter(Matter::Opaque);
    const BodyTable table(objects, *g);
    const MediumStack inside = table.around(Vec3{0, 0.1, 0} - g->origin());
    EXPECT_EQ(std::vector<BodyId>(inside.begin(), inside.end()), (std::vector<BodyId>{0, 1, 2, 3}));
    const MediumStack above = table.around(Vec3{0, 0.7, 0} - g->origin());
    EXPECT_EQ(std::vector<BodyId>(above.begin(), above.end()), (std::vector<BodyId>{1, 2, 3}));
    const MediumStack deep = table.around(Vec3{50, -1e6, 7} - g->origin());
    EXPECT_EQ(std::vector<BodyId>(deep.begin(), deep.end()), (std::vector<BodyId>{0}));
}

TEST(BodyTable, AnOpenMeshIsAroundNothing) {
    const auto g = build({{test::cube()}, {Sphere{}}});
    auto open = body();
    open.is_closed = false;
    const BodyTable table(std::vector{open, body()}, *g);
    EXPECT_EQ(object_at(table, *g, {}), 1);
    EXPECT_EQ(object_at(table, *g, {0.9, 0.9, 0.9}), -1);
    EXPECT_FALSE(table.may_end_at(0, -g->origin(), 1e-6));
    EXPECT_TRUE(table.may_end_at(1, -g->origin(), 1e-6));
}

TEST(BodyTable, SaysWhatAnObjectIs) {
    const auto g = build(overlapping());
    auto disk = matter(Matter::Sheet);
    disk.is_flat = true;
    const BodyTable table(std::vector{matter(Matter::Opaque), disk, body()}, *g);
    EXPECT_EQ(table.matter_of(0), Matter::Opaque);
    EXPECT_EQ(table.matter_of(1), Matter::Sheet);
    EXPECT_EQ(table.matter_of(2), Matter::Body);
    EXPECT_FALSE(table.is_flat(0));
    EXPECT_TRUE(table.is_flat(1));
    EXPECT_FALSE(table.empty());
    EXPECT_TRUE(BodyTable(std::vector{matter(Matter::Opaque), disk, disk}, *g).empty());
}

/// Whether the hit on the top of object 0, the box [-1, 1]^3, is near what object 1 is.
bool is_near(const Shape& other, Matter own, Matter of_other) {
    const auto g = build({{Box{{-1, -1, -1}, {1, 1, 1}}}, {other}});
    const BodyTable table(std::vector{matter(own), matter(of_other)}, *g);
    std::vector<Hit> all;
    g->crossings({Vec3{0.1, 0.5, 0.2} - g->origin(), {0, 1, 0}}, 0, 0.6, all);
    const auto top =
        std::find_if(all.begin(), all.end(), [](const Hit& hit) { return hit.object == 0; });
    EXPECT_NE(top, all.end());
    return top != all.end() && table.is_near_others(*top, 1e-6);
}

TEST(BodyTable, KnowsWhatTouches) {
    using enum Matter;
    const Box on_top{{-1, 1, -1}, {1, 2, 1}}, above{{-1, 1.1, -1}, {1, 2, 1}};
    EXPECT_TRUE(is_near(on_top, Body, Body));
    EXPECT_TRUE(is_near(on_top, Body, Opaque));
    EXPECT_TRUE(is_near(on_top, Opaque, Body));
    EXPECT_TRUE(is_near(on_top, Sheet, Opaque));
    EXPECT_FALSE(is_near(on_top, Opaque, Opaque)) << "of the opaque any may be met";
    EXPECT_FALSE(is_near(above, Body, Body));
    EXPECT_TRUE(is_near(Plane{{0, 1, 0}, {0, -1, 0}}, Body, Body));
    EXPECT_TRUE(is_near(Disk{{0, 1, 0}, {0, 1, 0}, 1}, Body, Opaque));
    EXPECT_FALSE(is_near(Disk{{0.9, 1, 0.9}, {0, 1, 0}, 0.1}, Body, Opaque)) << "elsewhere";
    EXPECT_TRUE(is_near(Sphere{{0.1, 2, 0.2}, 1}, Body, Body)) << "in the point";
    EXPECT_FALSE(is_near(Sphere{{0.5, 2, 0.2}, 1}, Body, Body));
}

TEST(BodyTable, KnowsWhereRaysMayEnd) {
    const auto g = build({{Sphere{{2, 0, 0}, 1}}, {Plane{{0, -3, 0}, {0, 1, 0}}}});
    const BodyTable table(std::vector{body(), body()}, *g);
    EXPECT_TRUE(table.may_end_at(0, Vec3{2, 0.5, 0} - g->origin(), 1e-9));
    EXPECT_FALSE(table.may_end_at(0, Vec3{3.1, 0, 0} - g->origin(), 1e-9));
    EXPECT_TRUE(table.may_end_at(0, Vec3{3.1, 0, 0} - g->origin(), 0.2));
    EXPECT_TRUE(table.may_end_at(1, Vec3{0, -50, 0} - g->origin(), 1e-9));
    // Only what has no end is left by the way of no surface.
    EXPECT_FALSE(table.may_leave_along(0, {0, -1, 0}));
    EXPECT_TRUE(table.may_leave_along(1, {0, -1, 0}));
    EXPECT_TRUE(table.may_leave_along(1, normalize({1, -1e-6, 0})));
    EXPECT_FALSE(table.may_leave_along(1, normalize({1, 1e-6, 0})));
}

}  // namespace
}  // namespace bouguer::renderer

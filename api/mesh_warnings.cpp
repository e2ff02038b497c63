// SPDX-License-Identifier: Apache-2.0
#include "api/mesh_warnings.h"

#include <set>

#include "api/placed_objects.h"

namespace bouguer::api {
namespace {

void warn_of_file(const std::string& at, const renderer::MeshNotes& notes, WarningSink& sink) {
    if (!notes.materials.empty()) {
        sink.warn(at, "mesh-materials-dropped",
                  "the materials that the file names are not read: " + notes.materials.text(),
                  "give each part an object and a material of its own");
    }
    if (!notes.dropped.empty()) {
        sink.warn(at, "mesh-parts-dropped",
                  "the file has more than is read: " + notes.dropped.text(),
                  "see that the surface does not need them");
    }
    if (notes.crossed_polygons > 0) {
        sink.warn(at, "mesh-crossed-polygons",
                  std::to_string(notes.crossed_polygons) + " polygons have borders that cross",
                  "cut them into triangles before");
    }
}

void warn_of_mending(const std::string& at, const renderer::MeshTopology& topology,
                     WarningSink& sink) {
    if (topology.doubled_triangles > 0) {
        sink.warn(at, "mesh-doubled",
                  std::to_string(topology.doubled_triangles) +
                      " triangles lie in the place of others and are left out",
                  "remove them from the mesh");
    }
}

void warn_of_sides(const std::string& at, const renderer::MeshTopology& topology,
                   WarningSink& sink) {
    if (topology.flipped_triangles > 0) {
        sink.warn(at, "mesh-inside-out",
                  std::to_string(topology.flipped_triangles) +
                      " triangles wind the wrong way and are turned round",
                  "let triangles wind counter-clockwise as seen from outside");
    }
    if (topology.is_closed) return;
    sink.warn(at, "mesh-open",
              "the material has an inside and this mesh has none: " +
                  (topology.open_edges > 0 ? std::to_string(topology.open_edges) + " open edges"
                                           : std::string("its surface has one side only")),
              "close it; where it is meant as a sheet, use a material without index and "
              "absorption");
}

}  // namespace

void warn_of_meshes(const renderer::SceneDescription& scene, WarningSink& sink) {
    std::set<const renderer::TriangleMesh*> seen, with_inside;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const renderer::TriangleMesh* mesh = mesh_of(scene.objects[i]);
        if (mesh == nullptr) continue;
        const std::string at = WarningSink::object(i) + "/shape";
        const bool is_new = seen.insert(mesh).second;
        if (is_new) warn_of_file(at, mesh->notes, sink);
        if (!mesh->topology) continue;
        if (is_new) warn_of_mending(at, *mesh->topology, sink);
        // Whether its sides matter is the material's, so it may be another object's.
        if (!is_sheet(scene, scene.objects[i]) && with_inside.insert(mesh).second)
            warn_of_sides(at, *mesh->topology, sink);
    }
}

}  // namespace bouguer::api

// What every pixel costs: for lectures and charts of the structures.
#pragma once

#include <string>
#include <vector>

#include "4_partitioning/effort.h"
#include "renderer/render.h"

namespace rays {

/// For every pixel (one sample at its centre, all its rays together) how many primitives were asked, in the first lane,
/// and how many cells or nodes were visited, in the second. Without a structure every primitive is asked.
Film cost_map(const Scene& scene, const RenderOptions& options);

/// Writes the two lanes as the channels `tests` and `nodes`.
void write_cost_map(const Film& map, const std::string& path);

/// What the camera ray of a pixel visits, in order: the boxes of cells or leaves.
struct Visit {
    Effort effort;  ///< of this ray alone; Effort::visited is null
    std::vector<Bounds> boxes;
};
Visit visit_of(const Scene& scene, const RenderOptions& options, int column, int row);

/// {"tests":..,"nodes":..,"visited":[[minx,miny,minz,maxx,maxy,maxz],...]}
std::string visit_to_json(const Visit& visit);

}  // namespace rays

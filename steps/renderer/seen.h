// Which shapes a picture shows: what the camera's rays meet first.
#pragma once

#include <array>
#include <string>

#include "core/scene.h"
#include "renderer/render.h"

namespace rays {

inline constexpr std::size_t kShapeKinds = static_cast<std::size_t>(ShapeKind::bicubic_patch) + 1;

/// For each ShapeKind the number of pixels whose centre sees such a shape first. The scene must be prepared.
std::array<std::int64_t, kShapeKinds> shapes_seen(const Scene& scene, const RenderOptions& options);

/// {"seen":{"spheres":1200,"planes":0,...}}
std::string seen_to_json(const std::array<std::int64_t, kShapeKinds>& seen);

}  // namespace rays

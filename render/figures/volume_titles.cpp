#include "render/figures/volume_titles.h"

#include "scb/any_hierarchy.h"

namespace scb::render {

std::string_view volume_title(VolumeKind kind) {
    switch (kind) {
        case VolumeKind::scb:
            break;
        case VolumeKind::ball:
            return "ball";
        case VolumeKind::ritter:
            return "ball (Ritter)";
        case VolumeKind::obb:
            return "OBB";
        case VolumeKind::scb2:
            return "SCB2";
        case VolumeKind::aabb:
            return "AABB";
        case VolumeKind::aabb_exact:
            return "AABB (exact)";
        default:
            return with_volume_type(kind, []<Volume V>() -> std::string_view {
                if constexpr (ConvexVolume<V>) return V::title;
                return "";
            });
    }
    return "SCB";
}

std::string volume_title(const TraceHeader& header) {
    if (!header.engine) return std::string(volume_title(header.volume));
    const std::string& volumes = header.engine->volumes;
    return header.engine->name + (volumes.empty() ? "" : ", " + volumes);
}

}  // namespace scb::render

#pragma once

#include <optional>
#include <string_view>

#include "scb/any_hierarchy.h"

namespace scb::app {

/// Table 3 of the paper for a scene and a hierarchy: means per frame.
struct Table3Entry {
    double ms, n_v, n_p;  ///< on an Intel T2600 at 2.16 GHz
};

/// The entry for a benchmark scene. Table 3 has none for other scenes and for Ritter's balls. Its
/// OBB figures are RAPID's.
std::optional<Table3Entry> table_3(std::string_view scene, VolumeKind kind);

}  // namespace scb::app

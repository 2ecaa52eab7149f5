#pragma once

#include <string>
#include <vector>

#include "tests/recordings/distance_engine.h"
#include "tests/recordings/small_engine.h"

namespace scb {

/// The errors of both small engines, which scb_record_bug records.
inline std::vector<std::string> all_bug_names() {
    std::vector<std::string> names(bug_names, bug_names + bug_count);
    names.insert(names.end(), distance_bug_names, distance_bug_names + distance_bug_count);
    return names;
}

/// Records the engine with the error of this index of all_bug_names.
inline void record_bug(int index, const std::string& path) {
    if (index < bug_count)
        record_small_engine(static_cast<Bug>(index), path);
    else
        record_distance_engine(static_cast<DistanceBug>(index - bug_count), path);
}

}  // namespace scb

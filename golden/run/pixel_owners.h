#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "golden/run/run_case.h"

namespace scb::golden {

/// Names the owners of the pixels of a case's pictures.
class Owners {
  public:
    /// Reads the scene, and the index.json that the run has left. Levels are from the scene as it
    /// is now, so they are left out if the baseline was made of other meshes. If the scene cannot
    /// be read, nothing has a name. Throws InputError if index.json cannot be read.
    Owners(const GoldenCase& golden, const GoldenRunSettings& settings,
           const std::filesystem::path& index, bool same_meshes);

    /// "node 412 of A, level 7", "triangle 17 of B", "pair 3"; empty if it has no name.
    std::string name(std::uint32_t id) const;

  private:
    /// The meaning of the ids from `first` on: nodes or triangles of a body, or pairs.
    struct IdRange {
        std::string what, body;
        std::uint32_t first = 0, count = 0;
    };

    void add_ranges(const nlohmann::json& index);

    std::vector<IdRange> ranges_;
    std::map<std::string, std::vector<std::uint16_t>> depths_;  // per body, per node
    bool same_meshes_;
};

}  // namespace scb::golden

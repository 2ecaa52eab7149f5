#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/report/table.h"
#include "app/study/scene_query.h"
#include "core/distance/deepest_vertices.h"

namespace scb::app {

/// The contact patches of queries, and the deepest vertex of each body in each patch.
class PatchReport {
  public:
    /// Refers to the query.
    explicit PatchReport(const SceneQuery& query);

    /// Adds the patches of a query of the chosen bodies. `found` are its pairs.
    void add(int frame, const Collision& found);

    /// The patches of the last query, and its `deepest_vertex`, as JSON.
    nlohmann::ordered_json json() const;
    /// Per pair of the last query its patch, from 1.
    std::vector<std::uint32_t> patch_of_pairs() const;

    /// All patches so far: a table with the largest patches of each query, and sentences.
    std::string text() const;
    /// All patches so far as CSV.
    std::string csv() const;

  private:
    /// The deepest vertices of a side; none: not judged.
    using Deepest = std::optional<std::vector<std::optional<DeepVertex>>>;
    /// A deepest vertex, with its bodies and its place in the tables.
    struct Place {
        int frame = 0;
        std::size_t patch = 0;
        std::string body, in;
        DeepVertex vertex;
    };

    const JoinedMesh& joined(std::size_t body);
    /// Why depths of the chosen bodies on this side are not judged; empty: they are.
    std::string doubt(std::size_t side, const Collision& found);
    Deepest deepest(std::size_t side, const Pose& b_to_a, const Collision& found);
    const std::string& name(std::size_t side) const;
    void add_row(int frame, std::size_t patch);
    std::string deepest_words() const;

    static constexpr std::size_t most_rows = 20;  ///< of a query, in the text

    const SceneQuery& query_;
    std::map<std::size_t, JoinedMesh> joined_;  ///< by mesh
    Table all_, largest_;                       ///< for programs, and for readers
    std::set<std::string> doubts_;
    std::optional<Place> deepest_;  ///< of all queries

    // Of the last query.
    std::size_t pair_count_ = 0;
    std::vector<ContactPatch> patches_;
    std::array<Deepest, 2> of_sides_;
    std::optional<Place> deepest_here_;
};

}  // namespace scb::app

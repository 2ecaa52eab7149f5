#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/query/query_options.h"
#include "app/report/table.h"
#include "app/study/scene_query.h"
#include "core/distance/first_contact.h"

namespace scb::app {

struct MotionOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query;
    double tolerance = 0.001;  ///< in frames
    bool json = false, csv = false;
};

/// The first contact between each two queried frames, of one pair of bodies.
class MotionReport {
  public:
    /// Refers to its arguments.
    MotionReport(const MotionOptions& options, SceneQuery& query);

    /// Thrown by `add`.
    struct Interrupted {};

    /// Looks for contact from one frame to the next queried one. Throws Interrupted once
    /// `is_interrupted`, and leaves the step out.
    void add(int from, int to, const std::function<bool()>& is_interrupted);
    std::size_t steps() const { return steps_.size(); }
    std::string text() const;

  private:
    /// What happened between two frames. Times are in frames.
    struct Step {
        int from = 0, to = 0;
        FirstContact found;
        bool begins_in_contact = false, ends_in_contact = false;

        bool has_contact() const { return found.outcome == ContactOutcome::contact; }
        /// Whether queries at both frames miss the contact.
        bool is_jumped() const { return has_contact() && !begins_in_contact && !ends_in_contact; }
    };

    nlohmann::ordered_json json() const;
    Table table() const;
    std::string sentences() const;

    const MotionOptions& options_;
    SceneQuery& query_;
    std::optional<IndexPair> closest_;  ///< of the last distance: the next query begins there
    std::vector<Step> steps_;
};

}  // namespace scb::app

#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/query/contact_intervals.h"
#include "app/query/expected_pairs.h"
#include "app/query/inside_report.h"
#include "app/query/layout_options.h"
#include "app/query/patch_report.h"
#include "app/query/query_options.h"
#include "app/report/table.h"
#include "app/study/scene_query.h"
#include "scenes/recordings/recorded_trace.h"

namespace scb::app {

struct CollideCommandOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query;
    QueryLimits limits;
    bool first = false, json = false, csv = false;
    std::string pairs_out;
    std::string expect;  ///< a file of pairs to compare with; empty: none
    LayoutOptions layout;
    bool patches = false;
    std::string contacts;  ///< --contacts; empty: all pairs, and contacts are not told apart
};

/// Totals of all frames. Collisions are not kept, since each holds its pairs.
struct CollideSums {
    std::size_t frames = 0, pairs = 0;  ///< `frames` counts whole frames
    std::uint64_t n_v = 0, n_p = 0, n_u = 0;
    StageCounts stages{};
    bool complete = true;

    void add(const Collision& found) {
        pairs += found.pairs.size();
        n_v += found.n_v;
        n_p += found.n_p;
        n_u += found.n_u;
        complete &= found.complete;
        for (std::size_t s = 0; s < stage_count; ++s) stages[s] += found.stages[s];
    }
    double mean(std::uint64_t sum) const {
        return frames == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(frames);
    }
};

/// Output of the command, frame by frame: a table, CSV or JSON, and the pairs of triangles. If the
/// scene has several pairs of bodies, each row or query names its bodies.
class CollideReport {
  public:
    /// Refers to its arguments. `recorded`: the recording of the queries of one pair of bodies, or
    /// null.
    CollideReport(const CollideCommandOptions& options, SceneQuery& query,
                  scenes::RecordedTrace* recorded);

    /// Makes the queries of a frame.
    void add(int frame);

    const CollideSums& sums() const { return sums_; }
    const std::string& pairs() const { return pairs_; }
    /// Whether all pairs so far are the expected ones; true if no pairs are expected.
    bool agrees() const { return !comparison_ || comparison_->agrees(); }

    /// Rows of the expected pairs that are not compared; empty: none.
    std::string note() const { return comparison_ ? comparison_->note() : ""; }

    /// The text of all frames so far; to be called once.
    std::string text();

  private:
    struct RecordedCounts;
    /// From the expected pairs; none: no pairs are expected.
    using ExpectedDifference = std::optional<PairComparison::Difference>;

    /// The number of pairs that only touch. Keeps the pairs of the chosen contacts.
    std::size_t choose_contacts(Collision& found, int frame);
    bool is_all_contacts() const { return options_.contacts == "all"; }
    bool leaves_out_contacts() const { return !options_.contacts.empty() && !is_all_contacts(); }

    /// `i`: the pair of bodies.
    void add(std::size_t i, int frame, Collision found);

    void add_json(int frame, const Collision& found, std::size_t touching,
                  const std::optional<RecordedCounts>& there, const ExpectedDifference& difference);

    void add_row(int frame, const Collision& found, std::size_t touching,
                 const std::optional<RecordedCounts>& there, const ExpectedDifference& difference);

    /// For a choice of contacts: how many others there are.
    std::string left_out_words() const;

    /// Explains the columns of the recording.
    std::string recorded_words() const;

    /// For frames without contact: whether a body lies inside the other.
    std::string apart_words() const;

    /// For several pairs of bodies: the pairs that never met, and bodies that lie inside others.
    std::string many_words();

    /// For several frames: those in which bodies are in contact.
    std::string contact_words();
    nlohmann::ordered_json contact_json();

    static constexpr std::size_t most_named_pairs = 8;

    const CollideCommandOptions& options_;
    SceneQuery& query_;
    scenes::RecordedTrace* recorded_;
    std::optional<PairComparison> comparison_;  ///< with --expect
    std::optional<PatchReport> patches_;        ///< with --patches
    std::vector<Stage> stages_;
    CollideSums sums_;
    Table table_;
    std::string pairs_;
    nlohmann::ordered_json json_frames_ = nlohmann::ordered_json::array(),
                           json_inside_ = nlohmann::ordered_json::array();
    std::size_t all_touching_ = 0;     ///< pairs of all queries that only touch
    std::size_t left_out_ = 0;         ///< pairs of all queries that are not of the chosen contacts
    std::uint64_t grazing_ = 0;        ///< recorded pairs within the tolerance
    std::deque<InsideReport> inside_;  ///< per pair of bodies
    std::vector<bool> met_;            ///< per pair of bodies
    std::vector<ContactIntervals> intervals_;  ///< per pair of bodies, of the chosen contacts
};

}  // namespace scb::app

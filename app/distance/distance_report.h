#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/pictures/picture_options.h"
#include "app/query/contact_intervals.h"
#include "app/query/inside_report.h"
#include "app/query/layout_options.h"
#include "app/query/query_options.h"
#include "app/report/table.h"
#include "app/study/scene_query.h"
#include "render/figures/distance_plot.h"

namespace scb::app {

struct DistanceCommandOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query;
    bool first = false, seeded = false, prove = false, json = false, csv = false;
    bool expects_clear = false;  ///< fails if triangles are within the tolerance
    std::string pairs_out;
    LayoutOptions layout;
    PictureOptions picture{.output = ""};  ///< of the plot
};

/// Output of the command, frame by frame: a table, CSV or JSON, and the pairs of triangles within a
/// tolerance. If the scene has several pairs of bodies, each row or query names its bodies.
class DistanceReport {
  public:
    /// Refers to its arguments.
    DistanceReport(const DistanceCommandOptions& options, SceneQuery& query);

    /// Makes the queries of a frame.
    void add(int frame);

    std::size_t frames() const { return frames_; }
    /// Whether every distance was certified, with --prove.
    bool is_proven() const { return not_proven_ == 0; }
    /// Whether no frame has triangles within the tolerance, or a body inside the other. None if
    /// frames are missing, or a body may be inside another that is not closed.
    std::optional<bool> is_clear() const;
    /// The verdict on the clearance.
    std::string clearance_words() const;
    /// The pairs within the tolerance, as CSV.
    const std::string& pairs() const { return pairs_; }
    /// The text of all frames so far; to be called once.
    std::string text();
    /// The distances, frame by frame.
    render::DistancePlot plot();

  private:
    /// What is kept of each pair of bodies.
    struct Bodies {
        InsideReport inside;
        ContactIntervals near;  ///< frames with contact, or with triangles within the tolerance
        std::optional<IndexPair> closest{};  ///< the triangles of the frame before
        render::DistanceLine line{};
    };
    /// The smallest distance of all queries.
    struct Least {
        Distance found;
        int frame = 0;
        BodyPair bodies{};
    };

    const DistanceQuery& asked() const { return *query_.distance; }
    bool lists_pairs() const { return asked().within && !options_.first; }
    DistanceOptions limits(const Bodies& bodies) const;
    void add_distance(Bodies& bodies, int frame);
    void add_pairs(Bodies& bodies, int frame);
    /// Whether triangles of the chosen bodies intersect, given all pairs within some distance.
    bool intersect(std::span<const IndexPair> pairs, int frame) const;
    /// Certifies the distance, and lists the certificate's bounds.
    nlohmann::ordered_json prove(int frame, const Distance& found);
    /// Adds a row for the chosen bodies, and its JSON. `judges_inside`: whether bodies without
    /// contact are to be judged.
    void add_row(Bodies& bodies, int frame, const Distance& work, std::vector<Cell> cells,
                 nlohmann::ordered_json json, bool judges_inside);
    std::vector<Cell> mean_cells() const;
    std::string title() const;
    std::string least_words();
    std::string words_of(const Least& least, const std::string& name);
    std::string inside_text();
    std::string proof_words() const;
    std::string near_words();
    nlohmann::ordered_json json();

    const DistanceCommandOptions& options_;
    SceneQuery& query_;
    std::vector<Stage> stages_;
    Table table_;
    std::string pairs_;
    nlohmann::ordered_json json_frames_ = nlohmann::ordered_json::array();
    std::deque<Bodies> bodies_;                 ///< per pair of bodies
    std::optional<Least> least_, least_apart_;  ///< of all queries; of bodies that are apart
    std::size_t frames_ = 0;                    ///< whole frames
    std::size_t proven_ = 0, not_proven_ = 0;   ///< distances
    std::vector<int> not_clear_;                ///< see is_clear
    std::size_t open_ = 0;                      ///< queries that may hide a body inside another
    std::uint64_t found_ = 0;                   ///< pairs of triangles within the tolerance
    Distance work_;                             ///< the sums of the counts
};

}  // namespace scb::app

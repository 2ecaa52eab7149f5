#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/study/scene_query.h"
#include "scb/triangle_overlap.h"

namespace scb::app {

/// Pairs of triangles in a file, as `scb collide --pairs-out` writes them.
class PairFile {
  public:
    /// Keeps the pairs of the frames and bodies of the query. Throws InputError, naming file and
    /// line: columns or numbers are missing, or the scene has no such frame, body or triangle.
    PairFile(const std::string& path, const SceneQuery& query);

    /// The pairs of the bodies SceneQuery::pairs[i]: ascending, each once.
    std::vector<IndexPair> pairs(std::size_t i, int frame) const;

    const std::string& path() const { return path_; }
    /// How many rows are of other frames and bodies; empty: none.
    std::string note() const;

  private:
    struct Row {
        std::uint32_t bodies = 0;  ///< index into SceneQuery::pairs
        int frame = 0;
        IndexPair triangles;

        friend auto operator<=>(const Row&, const Row&) = default;
    };
    /// Rows of frames that are not queried, and rows of the others whose bodies are not.
    struct NotCompared {
        std::size_t of_frames = 0, of_bodies = 0;
    };
    class Reader;

    std::string path_;
    std::vector<Row> rows_;
    NotCompared not_compared_;
};

/// Compares the pairs that queries find with those in a file, frame by frame.
class PairComparison {
  public:
    /// Refers to the query.
    PairComparison(const std::string& path, const SceneQuery& query)
        : query_(query), file_(path, query) {}

    /// How the pairs of a query differ.
    struct Difference {
        std::size_t expected = 0;  ///< pairs in the file
        struct Missing {
            IndexPair triangles;
            double depth = 0;
        };
        /// Triangles that are apart, or a pair that the query leaves out: it was asked for other
        /// contacts.
        struct False {
            IndexPair triangles;
            TriangleContact contact = TriangleContact::apart;
            double distance = 0;
        };
        std::vector<Missing> missing;  ///< the file lacks them; the deepest first
        std::vector<False> not_found;  ///< only the file has them; the farthest first
    };
    /// The pairs that the query of the bodies SceneQuery::pairs[i] has found.
    Difference add(std::size_t i, int frame, std::span<const IndexPair> found);

    std::string note() const { return file_.note(); }
    bool agrees() const { return missing_ + false_ == 0; }
    /// Sentences about all frames so far, `frames` of them, and the first pairs that differ.
    std::string text(std::size_t frames) const;

  private:
    /// How many pairs a frame has, and how many differ.
    struct FrameCounts {
        std::size_t found = 0, missing = 0, not_found = 0;
    };

    /// Lists a pair, unless enough are listed.
    void list(int frame, IndexPair triangles, const std::string& words);
    /// "frames 12 to 40, 55": the frames whose counts fulfil the condition; empty: none.
    std::string frames_where(const std::function<bool(const FrameCounts&)>& condition) const;

    static constexpr std::size_t most_listed = 20;
    /// Missing pairs, and false pairs, of one of several frames.
    static constexpr std::size_t most_listed_of_frame = 3;

    const SceneQuery& query_;
    PairFile file_;
    std::size_t found_ = 0, missing_ = 0, false_ = 0;
    std::size_t exchanged_ = 0;  ///< missing pairs that the file has in the other order
    std::map<int, FrameCounts> frames_;
    double most_depth_ = 0, most_distance_ = 0;
    std::size_t listed_ = 0;
    std::string list_;
};

nlohmann::ordered_json json_of(const PairComparison::Difference& difference);

}  // namespace scb::app

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scb/stage.h"

namespace scb {

/// Colors of stages. The renderer has their values; a reader with deuteranopia can tell them apart.
enum class Hue : std::uint8_t {
    grey,
    blue,
    sky,
    green,
    yellow,
    violet,
    olive,
    navy,
    brown,
    mint,
    purple,
    vermillion,
    tan,
    left_over
};

/// A way in which a test can end.
struct StageRow {
    std::string_view name;
    std::string_view group;  ///< the legend's name; pictures show the stages of a group alike
};

/// The color of a stage. Of an engine's stages, the first nine have colors of their own.
Hue hue_of(Stage stage);

constexpr bool is_rejection(Stage stage) {
    const auto row = static_cast<std::size_t>(stage);
    return stage != Stage::overlapping && (row < stage_count || row >= named_stage_count);
}
constexpr bool is_divided(Stage stage) {
    return stage >= Stage::divided_a && stage <= Stage::divided_both;
}
/// Whether a path of the traversal ends there.
constexpr bool is_ending(Stage stage) { return stage != Stage::overlapping && !is_divided(stage); }

/// The ways in which the tests of a query can end, by Stage: the rows of this project, then the
/// rows of an engine.
class StageTable {
  public:
    /// An engine has at most 127 stages.
    static constexpr std::size_t most_rows = named_stage_count + 127;

    /// The stage that an engine calls by this name: a stage of this project that rejects, or a row
    /// that was added.
    std::optional<Stage> find(std::string_view name) const;

    /// The same; adds a row if none has the name. All rows behind the ninth are in one group.
    /// Throws std::length_error for more than `most_rows`.
    Stage add(std::string name);

    /// The row of a stage; valid until the next `add`. Throws std::out_of_range.
    StageRow row(Stage stage) const;

  private:
    std::vector<std::string> added_;
};

}  // namespace scb

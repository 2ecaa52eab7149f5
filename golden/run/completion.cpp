#include "golden/run/completion.h"

#include <nlohmann/json.hpp>

#include "golden/run/check_cases.h"
#include "golden/suite/baseline.h"
#include "golden/suite/files_equal.h"
#include "render/files/image_file.h"
#include "render/files/output_file.h"
#include "scenes/text/file_bytes.h"
#include "scenes/text/json_reader.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;

/// Copies a picture of the run for the report, if it is not there yet.
void show(std::string& candidate, const fs::path& made, const fs::path& report,
          const std::string& name) {
    if (!candidate.empty() || report.empty() || !render::is_there(made)) return;
    render::write_file_whole(report / name, scenes::file_bytes(made.string()));
    candidate = name;
}

void add_pictures(CaseResult& result, const CaseFiles& made, const fs::path& report, bool ids,
                  bool colors) {
    if (colors) show(result.picture.candidate, made.image, report, result.name + ".new.png");
    if (ids) show(result.id_picture.candidate, made.ids, report, result.name + ".new.ids.png");
}

void add_counts(CaseResult& result, const fs::path& made) {
    const std::string file = made.string();
    const std::vector<CountChange> counts = counts_difference(
        nlohmann::json::object(), scenes::parse_json(scenes::read_text_file(file), file));
    result.counts.insert(result.counts.begin(), counts.begin(), counts.end());
}

void add_tolerated_colors(CaseResult& result, const GoldenCase& golden,
                          const ComparisonFolders& folders, const CaseFiles& made) {
    if (!golden.colors || golden.tolerance == ColorTolerance{} || result.variant == 0) return;
    const fs::path accepted = accepted_images(
        folders.baselines, result.name)[static_cast<std::size_t>(result.variant) - 1];
    if (files_equal(accepted, made.image)) return;
    const ImageDifference difference =
        image_difference(render::read_png(accepted), render::read_png(made.image));
    if (difference.pixels > 0) result.colors = difference;
}

}  // namespace

void complete_result(CaseResult& result, const GoldenCase& golden,
                     const ComparisonFolders& folders) {
    if (!has_run(golden, folders)) return;
    const CaseFiles before = case_files(folders.baselines, result.name),
                    made = case_files(folders.candidates, result.name);
    if (result.verdict == Verdict::same) return add_tolerated_colors(result, golden, folders, made);
    if (result.verdict == Verdict::could_not_run) {
        result.message +=
            " Restore it from version control, or take over what the run made with the command "
            "below.";
        return add_pictures(result, made, folders.report, golden.ids, golden.colors);
    }
    if (golden.counts && !render::is_there(before.counts)) add_counts(result, made.counts);
    add_pictures(result, made, folders.report, golden.ids && !render::is_there(before.ids),
                 golden.colors && !render::is_there(before.image));
}

}  // namespace scb::golden

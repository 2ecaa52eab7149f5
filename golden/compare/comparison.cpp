#include "golden/compare/comparison.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/text_format.h"
#include "core/platform/file_bytes.h"
#include "core/platform/json_reader.h"
#include "core/platform/output_file.h"
#include "golden/compare/number_words.h"
#include "golden/suite/baseline.h"
#include "golden/suite/file_replacement.h"
#include "render/files/image_file.h"
#include "render/overlay/figure_layout.h"
#include "scb/error.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;

/// "19 pixels in the box from (1, 2) to (3, 4)", "1 pixel at (1, 2)"
std::string pixels_words(std::size_t pixels, const PixelBox& box) {
    const std::string where = words::box_words(box);
    return counted(pixels, "pixel", "pixels") + (where.starts_with("from") ? " in the box " : " ") +
           where;
}

std::string size_words(const render::Image& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
}

bool same_size(const render::Image& a, const render::Image& b) {
    return a.width == b.width && a.height == b.height;
}

/// The part of the picture with the scene: without the title and the panel of numbers, since its
/// digits change with every change. The whole picture for plots.
PixelBox scene_part(const GoldenCase& golden, const render::Image& image) {
    const bool has_panel = golden.panel && has_ids(golden.run);
    const render::PixelRect view = render::figure_layout(image.width, image.height, has_panel).view;
    return {view.x, view.y, view.x + view.width, view.y + view.height};
}

/// Runs one comparison after the other; if one fails, the others still run.
class Comparison {
  public:
    Comparison(const GoldenCase& golden, const ComparisonFolders& folders)
        : golden_(golden),
          folders_(folders),
          baseline_(case_files(folders.baselines, golden.name)),
          candidate_(case_files(folders.candidates, golden.name)) {
        result_.name = golden.name;
        result_.tolerance = golden.tolerance;
    }

    CaseResult make() {
        if (is_missing()) {
            result_.verdict = Verdict::missing_baseline;
            result_.message =
                "There is no baseline; look at what the run made and, if it is right, "
                "take it over with the command below.";
            result_.picture.candidate = copied(candidate_.image, "new");
            result_.id_picture.candidate = copied(candidate_.ids, "new");
            return std::move(result_);
        }
        if (golden_.counts) compare(&Comparison::compare_counts);
        if (golden_.ids) compare(&Comparison::compare_ids);
        if (golden_.colors && !size_differs_) compare(&Comparison::compare_colors);
        if (!unreadable_.empty())
            result_.verdict = Verdict::could_not_run;
        else if (size_differs_)
            result_.verdict = Verdict::size_differs;
        result_.message = message();
        return std::move(result_);
    }

  private:
    bool is_missing() const {
        return !(golden_.counts && is_there(baseline_.counts)) &&
               !(golden_.ids && is_there(baseline_.ids)) &&
               !(golden_.colors && is_there(baseline_.image));
    }

    /// False if the baseline lacks the file, which the run made.
    bool has(const fs::path& baseline, const char* what) {
        if (is_there(baseline)) return true;
        raise(Verdict::new_output);
        std::error_code ignored;
        said_.push_back(fs::exists(baseline, ignored)
                            ? baseline.filename().string() +
                                  " of the baseline is not a regular file, and the run made one"
                            : "the baseline has no " + std::string(what) +
                                  ", and the run made some");
        return false;
    }

    void raise(Verdict verdict) {
        if (result_.verdict == Verdict::same || result_.verdict == Verdict::new_output)
            result_.verdict = verdict;
    }

    void compare(void (Comparison::*comparison)()) {
        try {
            (this->*comparison)();
        } catch (const InputError& error) {
            unreadable_.emplace_back(error.what());
        }
    }

    /// Nothing if it cannot be read.
    std::optional<render::Image> accepted_picture(const fs::path& path) {
        try {
            return render::read_png(path);
        } catch (const InputError& error) {
            unreadable_.emplace_back(error.what());
            return std::nullopt;
        }
    }

    std::string message() const {
        std::string text = size_words_;
        const auto add = [&text](const std::string& sentence) {
            text += (text.empty() ? "" : " ") + sentence;
        };
        std::string differing;
        for (const std::string& said : said_)
            differing += (differing.empty() ? "These differ: " : "; ") + said;
        if (!differing.empty()) add(differing + ".");
        for (const std::string& sentence : unreadable_) add(sentence);
        return text;
    }

    void compare_counts() {
        if (!has(baseline_.counts, "counts")) return;
        if (files_equal(baseline_.counts, candidate_.counts)) return;
        const auto read = [](const fs::path& path) {
            return parse_json(read_text_file(path.string()), path.string());
        };
        result_.counts = counts_difference(read(baseline_.counts), read(candidate_.counts));
        if (result_.counts.empty()) return;
        raise(Verdict::different);
        said_.push_back(counted(result_.counts.size(), "count", "counts"));
    }

    void compare_ids() {
        if (!has(baseline_.ids, "ids")) return;
        if (files_equal(baseline_.ids, candidate_.ids)) return;
        const render::Image before = render::read_png(baseline_.ids),
                            after = render::read_png(candidate_.ids);
        if (!same_size(before, after)) {
            size_differs(before, after);
            return;
        }
        IdDifference difference =
            id_difference(render::unpack_ids(before), render::unpack_ids(after));
        if (difference.pixels == 0) return;
        raise(Verdict::different);
        said_.push_back("the owners of " + pixels_words(difference.pixels, difference.box));
        result_.id_picture = {copied(baseline_.ids, "baseline"), copied(candidate_.ids, "new"), ""};
        result_.ids = std::move(difference);
    }

    void compare_colors() {
        if (!has(baseline_.image, "picture")) return;
        const std::vector<fs::path> accepted = accepted_images(folders_.baselines, golden_.name);
        for (std::size_t i = 0; i < accepted.size(); ++i)
            if (files_equal(accepted[i], candidate_.image)) {
                result_.variant = static_cast<int>(i) + 1;
                return;
            }
        const render::Image after = render::read_png(candidate_.image);
        std::optional<ImageDifference> closest;
        render::Image closest_image;
        for (std::size_t i = 0; i < accepted.size(); ++i) {
            std::optional<render::Image> before = accepted_picture(accepted[i]);
            if (!before) continue;
            if (!same_size(*before, after)) {
                if (!closest) closest_image = std::move(*before);
                continue;
            }
            const ImageDifference difference = image_difference(*before, after);
            const bool passes = within(difference, golden_.tolerance);
            if (passes || !closest || difference.pixels < closest->pixels) {
                result_.variant = static_cast<int>(i) + 1;
                closest = difference;
                closest_image = std::move(*before);
            }
            if (passes) return;
        }
        if (!closest && closest_image.width > 0) size_differs(closest_image, after);
        if (!closest) return;
        raise(Verdict::different);
        said_.push_back("the colors of " + pixels_words(closest->pixels, closest->box) +
                        ", by up to " + std::to_string(closest->largest) + " of 255");
        result_.colors = closest;
        result_.focus = changed_box(closest_image, after, scene_part(golden_, after));
        if (result_.focus.empty()) result_.focus = closest->box;
        copy_pictures(&closest_image, after);
    }

    void size_differs(const render::Image& before, const render::Image& after) {
        size_differs_ = true;
        size_words_ = "The baseline's picture has " + size_words(before) +
                      " pixels, and the run made " + size_words(after) + ".";
        result_.picture.baseline = copied(baseline_.image, "baseline");
        result_.picture.candidate = copied(candidate_.image, "new");
    }

    void copy_pictures(const render::Image* before, const render::Image& after) {
        const std::vector<fs::path> accepted = accepted_images(folders_.baselines, golden_.name);
        result_.picture.baseline =
            copied(accepted[static_cast<std::size_t>(result_.variant) - 1], "baseline");
        result_.picture.candidate = copied(candidate_.image, "new");
        if (folders_.report.empty()) return;
        const std::string name = golden_.name + ".difference.png";
        write_file_whole(folders_.report / name,
                         render::encode_png(difference_picture(*before, after)));
        result_.picture.difference = name;
    }

    /// Copies a file for the report. Returns its name there; empty: none.
    std::string copied(const fs::path& from, const std::string& kind) const {
        if (folders_.report.empty() || !is_there(from)) return "";
        const std::string file = from.filename().string(),
                          ids = file.ends_with(".ids.png") ? ".ids" : "",
                          name = golden_.name + "." + kind + ids + ".png";
        write_file_whole(folders_.report / name, file_bytes(from.string()));
        return name;
    }

    const GoldenCase& golden_;
    const ComparisonFolders& folders_;
    CaseFiles baseline_, candidate_;
    CaseResult result_;
    std::vector<std::string> said_, unreadable_;
    bool size_differs_ = false;
    std::string size_words_;
};

}  // namespace

CaseResult compare_case(const GoldenCase& golden, const ComparisonFolders& folders) {
    return Comparison(golden, folders).make();
}

}  // namespace scb::golden

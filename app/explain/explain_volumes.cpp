#include "app/explain/explain_volumes.h"

#include <nlohmann/json.hpp>

#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/explain/explain_pictures.h"
#include "app/explain/explain_report.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "core/platform/utf8.h"
#include "render/figures/figure_words.h"
#include "scb/error.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

/// Limits the pictures, which would fill the disk unseen.
constexpr std::size_t most_pictures = 1000;

/// The numbers of answers over many pairs.
struct Summary {
    std::size_t pairs = 0, rejected = 0, false_positives = 0;
    std::vector<std::size_t> false_negatives;

    void add(const ExplainedPair& pair) {
        rejected += pair.found.steps.stage() != Stage::overlapping;
        false_positives += pair.found.answer == Answer::false_positive;
        if (pair.found.answer == Answer::false_negative) false_negatives.push_back(pairs);
        ++pairs;
    }
    int exit_status() const { return false_negatives.empty() ? exit_done : exit_different; }
    std::string text() const {
        std::string text = std::to_string(pairs) + (pairs == 1 ? " pair: " : " pairs: ") +
                           std::to_string(rejected) + " rejected, " +
                           std::to_string(pairs - rejected) + " passed; " +
                           std::to_string(false_positives) + " false positives, " +
                           std::to_string(false_negatives.size()) + " false negatives";
        constexpr std::size_t most = 10;
        for (std::size_t i = 0; i < false_negatives.size() && i < most; ++i)
            text += (i == 0 ? (false_negatives.size() == 1 ? ": pair " : ": pairs ") : ", ") +
                    std::to_string(false_negatives[i]);
        return text + (false_negatives.size() > most ? ", ...\n" : "\n");
    }
};

/// Prints text in blocks, since the whole may not fit into memory.
struct BlockPrinter {
    std::string text;

    void add(const std::string& more) {
        text += more;
        if (text.size() < std::size_t{1} << 16) return;
        print_result(text);
        text.clear();
    }
    void finish() { print_result(text); }
};

/// The explanations of raw volumes, one after the other, as text or JSON, with or without pictures.
class VolumesReport {
  public:
    VolumesReport(const ExplainOptions& options, const Console& console, std::size_t pairs)
        : options_(options), console_(console), pairs_(pairs) {
        if (options.draws()) pictures_.emplace(options.picture, stem());
        if (json()) out("[");
    }

    void add(const ExplainedPair& pair) {
        const std::size_t i = summary_.pairs;
        summary_.add(pair);
        Json entry;
        if (json() || pictures_) {
            entry = {{"pair", i}};
            entry.update(explanation_json(pair));
        }
        if (pictures_) entry["file"] = draw(pair, i, entry) + ".png";
        if (json())
            // A single pair is formatted for people, many pairs for programs.
            out((i == 0 ? "\n" : ",\n") + json_text(entry, pairs_ == 1 ? 2 : -1));
        else
            out("pair " + std::to_string(i) + " of " + printable(options_.pairs_file) + "\n" +
                explanation_text(pair, console_.colors_results()) + "\n");
    }

    const Summary& finish() {
        if (json())
            out(summary_.pairs == 0 ? "]\n" : "\n]\n");
        else if (pairs_ != 1)
            out(summary_.text());
        if (!pictures_) {
            out_.finish();
            return summary_;
        }
        if (json())
            pictures_->print_instead(std::move(text_));
        else
            pictures_->say(std::move(text_));
        Json head = explain_index_head(options_);
        head["pairs"] = as_utf8(options_.pairs_file);
        pictures_->finish(std::move(head), console_);
        return summary_;
    }

  private:
    bool json() const { return options_.picture.json; }
    /// With pictures, the text is printed at the end, when they are written.
    void out(const std::string& text) {
        if (pictures_)
            text_ += text;
        else
            out_.add(text);
    }
    std::string stem() const {
        return scenes::file_name_of(std::filesystem::path(options_.pairs_file).stem().string());
    }
    std::string draw(const ExplainedPair& pair, std::size_t i, const Json& entry) {
        NamedOptions named;
        const OverlapOptions usual;
        named.add_if(pair.options.test != usual.test && pair.kind == VolumeKind::scb, "test",
                     std::string(overlap_test_name(pair.options.test)));
        named.add_if(pair.options.threshold != usual.threshold && pair.kind == VolumeKind::scb &&
                         has_threshold(pair.options.test),
                     "threshold", exact_number(pair.options.threshold));
        name_view(named, options_.picture, options_.camera);
        name_picture(named, options_.picture);
        ExplainPicture picture;
        picture.name = options_.picture.picture_stem(
            picture_name(stem(), "explain", named, format("pair-%03zu", i)));
        picture.title = stem() + " · " + std::string(render::volume_title(pair.kind)) +
                        " · explain" + (pairs_ == 1 ? "" : format(" · pair %zu", i));
        picture.subtitle = asked_words(pair);
        picture.camera = asked_camera(options_.camera, nullptr);
        picture.orthographic = options_.camera.orthographic;
        draw_explanation(*pictures_, options_.picture, pair, picture, entry);
        return picture.name;
    }

    const ExplainOptions& options_;
    const Console& console_;
    const std::size_t pairs_;
    std::optional<PictureRun> pictures_;
    Summary summary_;
    BlockPrinter out_;
    std::string text_;
};

}  // namespace

int explain_volumes(const ExplainOptions& options, const Console& console) {
    const std::vector<scenes::AnyRawPair> pairs = scenes::read_raw_pairs(options.pairs_file);
    if (options.draws() && pairs.size() > most_pictures)
        throw InputError("-o " + options.picture.output + ": " + options.pairs_file + " has " +
                         std::to_string(pairs.size()) + " pairs, and at most " +
                         std::to_string(most_pictures) +
                         " are drawn; leave out -o, or give those that matter.");
    options.picture.check_count(pairs.size(), "give one pair");
    const OverlapOptions overlap = options.query.overlap();
    std::vector<VolumeKind> kinds;
    for (const scenes::AnyRawPair& pair : pairs)
        kinds.push_back(pair.index() == 0 ? VolumeKind::scb : VolumeKind::ball);
    if (!pairs.empty()) note_doubts(options.query, kinds, console.notes());
    const InterruptWatch watch;

    Progress progress(console, pairs.size());
    VolumesReport report(options, console, pairs.size());
    std::size_t done = 0;
    for (; done < pairs.size() && watch.signal() == 0; ++done) {
        report.add(explained_volumes(pairs[done], overlap));
        progress.step("pairs");
    }
    const Summary& summary = report.finish();
    if (const std::size_t count = summary.false_negatives.size(); count > 0)
        console.alarm("scb: the test rejected volumes that overlap, in " + std::to_string(count) +
                      (count == 1 ? " pair." : " pairs."));
    if (done == pairs.size()) return summary.exit_status();
    console.note("scb: interrupted; " + std::to_string(done) + " of " +
                 std::to_string(pairs.size()) + " pairs are explained.");
    return exit_interrupted(watch.signal());
}

}  // namespace scb::app

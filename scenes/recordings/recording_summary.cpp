#include "scenes/recordings/recording_summary.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/platform/utf8.h"
#include "scb/error.h"
#include "scenes/recordings/recording_file.h"
#include "scenes/recordings/recording_input.h"

namespace scb::scenes {
namespace {

void tell_apart(std::map<std::uint32_t, std::string>& names) {
    std::set<std::string> taken;
    for (auto& [number, name] : names) {
        if (name.empty()) name = "body " + std::to_string(number);
        while (!taken.insert(name).second) name += " (" + std::to_string(number) + ")";
    }
}

/// The selection matches no query: names what there is.
[[noreturn]] void refuse_selection(std::string_view name, const QuerySelection& selection,
                                   const std::set<std::string>& known, const char* what) {
    constexpr std::size_t most = 5;
    std::string list;
    std::size_t count = 0;
    for (const std::string& each : known)
        if (count++ < most) list += (list.empty() ? "" : ", ") + shown(each);
    if (count > most) list += ", and " + std::to_string(count - most) + " more";
    throw InputError(selection.words() + ": " + std::string(name) + " has no such query; its " +
                     (list.empty() ? std::string("queries have no ") + what
                                   : std::string(what) + " are " + list) +
                     ".");
}

}  // namespace

bool QuerySelection::has(const RecordedQuery& query) const {
    return (name.empty() || query.name == name) &&
           (tag.empty() ||
            std::find(query.tags.begin(), query.tags.end(), tag) != query.tags.end());
}

std::string QuerySelection::title() const {
    return (name.empty() ? "" : '"' + name + '"') + (name.empty() || tag.empty() ? "" : ", ") +
           (tag.empty() ? "" : "tag " + tag);
}

std::string QuerySelection::words() const {
    const std::string of_name = name.empty() ? "" : "--query " + name;
    return of_name + (tag.empty() ? "" : (of_name.empty() ? "--tag " : " --tag ") + tag);
}

std::string shown(std::string text) {
    constexpr std::size_t most = 500;
    const bool cut = text.size() > most;
    if (cut) text.resize(most);
    return printable(std::move(text)) + (cut ? "..." : "");
}

RecordingSummary summary_of(const RecordingBytes& bytes, std::string_view name,
                            const QuerySelection& selection) {
    RecordingSummary summary;
    std::set<std::string> names, tags;  // of all queries
    bool is_selected = true;
    int current = 0;  // frame
    std::array<bool, 128> is_stage{};
    RecordingReader reader(bytes, name);
    while (const Record* record = reader.next()) {
        if (const auto* event = std::get_if<RecordedEvent>(record)) {
            if (!is_selected) continue;
            const auto tag = static_cast<RecordTag>(event->tag);
            summary.volume_tests += tag < RecordTag::items_apart;
            summary.item_tests += tag == RecordTag::items_apart || tag == RecordTag::items_meet;
            summary.pairs += tag == RecordTag::pair;
            if (tag > RecordTag::volumes_overlap && tag < RecordTag::items_apart) {
                if (!is_stage[event->tag]) summary.stages.insert(event->tag);
                is_stage[event->tag] = true;
            }
        } else if (const auto* frame = std::get_if<RecordedFrame>(record)) {
            current = static_cast<int>(frame->frame);
            if (selection.empty()) summary.frames.push_back(current);
        } else if (const auto* body = std::get_if<RecordedBody>(record)) {
            summary.body_names[body->body] = shown(body->name);
        }
        summary.measures += is_selected && std::holds_alternative<RecordedMeasure>(*record);
        summary.answers += is_selected && std::holds_alternative<RecordedAnswer>(*record);
        if (const auto* setting = std::get_if<RecordedSetting>(record))
            summary.has_pairs |= setting->key == "results" && setting->value == "pairs";
        if (const auto* query = std::get_if<RecordedQuery>(record)) {
            is_selected = selection.has(*query);
            summary.queries += is_selected;
            const bool is_new = summary.frames.empty() || summary.frames.back() != current;
            if (is_selected && !selection.empty() && is_new) summary.frames.push_back(current);
            if (!query->name.empty()) names.insert(query->name);
            tags.insert(query->tags.begin(), query->tags.end());
        }
    }
    if (!selection.empty() && summary.queries == 0) {
        const bool by_name = !selection.name.empty() && !names.contains(selection.name);
        refuse_selection(name, selection, by_name ? names : tags, by_name ? "names" : "tags");
    }
    if (summary.frames.empty()) summary.frames.push_back(0);
    tell_apart(summary.body_names);
    // Frames that do not ascend are sorted, too; RecordedQueries refuses them.
    std::sort(summary.frames.begin(), summary.frames.end());
    return summary;
}

RecordingFile::RecordingFile(const std::string& name, QuerySelection selected)
    : RecordingFile(recording_bytes(name), name, std::move(selected)) {}

std::string RecordingFile::title() const {
    return selection.empty() ? path : path + " with " + selection.words();
}

RecordingFile::RecordingFile(RecordingBytes of_file, std::string name, QuerySelection selected)
    : path(std::move(name)),
      bytes(std::move(of_file)),
      selection(std::move(selected)),
      summary(summary_of(bytes, path, selection)) {}

}  // namespace scb::scenes

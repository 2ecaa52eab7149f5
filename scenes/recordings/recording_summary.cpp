#include "scenes/recordings/recording_summary.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/platform/utf8.h"
#include "scenes/recordings/recording_file.h"
#include "scenes/recordings/recording_input.h"

namespace scb::scenes {
namespace {

void tell_apart(std::map<std::uint32_t, std::string>& names) {
    std::set<std::string> taken;
    for (auto& [number, name] : names) {
        if (name.empty()) name = "body " + std::to_string(number);
        std::replace(name.begin(), name.end(), ',', ';');
        while (!taken.insert(name).second) name += " (" + std::to_string(number) + ")";
    }
}

}  // namespace

std::string shown(std::string text) {
    constexpr std::size_t most = 500;
    const bool cut = text.size() > most;
    if (cut) text.resize(most);
    return printable(std::move(text)) + (cut ? "..." : "");
}

RecordingSummary summary_of(std::string_view bytes, std::string_view name) {
    RecordingSummary summary;
    std::array<bool, 128> is_stage{};
    RecordingReader reader(bytes, name);
    while (const Record* record = reader.next()) {
        if (const auto* event = std::get_if<RecordedEvent>(record)) {
            const auto tag = static_cast<RecordTag>(event->tag);
            summary.volume_tests += tag < RecordTag::items_apart;
            summary.item_tests += tag == RecordTag::items_apart || tag == RecordTag::items_meet;
            summary.pairs += tag == RecordTag::pair;
            if (tag > RecordTag::volumes_overlap && tag < RecordTag::items_apart) {
                if (!is_stage[event->tag]) summary.stages.insert(event->tag);
                is_stage[event->tag] = true;
            }
        } else if (const auto* frame = std::get_if<RecordedFrame>(record)) {
            summary.frames.push_back(static_cast<int>(frame->frame));
        } else if (const auto* body = std::get_if<RecordedBody>(record)) {
            summary.body_names[body->body] = shown(body->name);
        }
        if (const auto* setting = std::get_if<RecordedSetting>(record))
            summary.tells_pairs |= setting->key == "results" && setting->value == "pairs";
        summary.queries += std::holds_alternative<RecordedQuery>(*record);
    }
    if (summary.frames.empty()) summary.frames.push_back(0);
    tell_apart(summary.body_names);
    // Frames that do not ascend are sorted, too; RecordedQueries refuses them.
    std::sort(summary.frames.begin(), summary.frames.end());
    return summary;
}

RecordingFile::RecordingFile(const std::string& name)
    : RecordingFile(recording_bytes(name), name) {}

RecordingFile::RecordingFile(std::string of_file, std::string name)
    : path(std::move(name)), bytes(std::move(of_file)), summary(summary_of(bytes, path)) {}

}  // namespace scb::scenes

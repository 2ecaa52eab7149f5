#include "scenes/recordings/recording_json.h"

#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/text_format.h"
#include "core/platform/utf8.h"
#include "scenes/recordings/recording_file.h"

namespace scb::scenes {
namespace {

using Json = nlohmann::ordered_json;

std::string hex_of(std::string_view bytes) {
    std::string text;
    for (const char c : bytes)
        text += format("%02x", static_cast<unsigned>(static_cast<unsigned char>(c)));
    return text;
}

std::string hex_of(const std::vector<std::uint8_t>& bytes) {
    return hex_of({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Json text_json(const std::string& text) {
    if (as_utf8(text) == text) return text;
    return {{"hex", hex_of(text)}};
}

Json real_json(double value) {
    if (std::isfinite(value)) return value;
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    const auto bits = std::bit_cast<std::uint64_t>(value);
    if (bits == std::bit_cast<std::uint64_t>(std::numeric_limits<double>::quiet_NaN()))
        return "nan";
    return format("nan:%016llx", static_cast<unsigned long long>(bits));
}

template <class Reals>
Json reals_json(const Reals& reals) {
    Json list = Json::array();
    for (const double value : reals) list.push_back(real_json(value));
    return list;
}

/// The number, or null for record_none.
Json number_json(std::uint32_t number) { return number == record_none ? Json() : Json(number); }

Json volume_json(const RecordedVolume& volume) {
    Json list = reals_json(volume.values);
    list.insert(list.begin(), recorded_kind_names[volume.kind]);
    return list;
}

Json event_json(const RecordedEvent& event) {
    switch (static_cast<RecordTag>(event.tag)) {
        case RecordTag::items_apart:
            return {"apart", event.a, event.b};
        case RecordTag::items_meet:
            return {"meet", event.a, event.b};
        case RecordTag::pair:
            return {"pair", event.a, event.b};
        case RecordTag::parent:
            return {"parent", event.a, event.b};
        case RecordTag::length:
            return {"length", real_json(length_of(event))};
        default:
            return {event.tag, event.a, event.b};
    }
}

struct LineOf {
    Json operator()(const RecordedEvent& r) { return event_json(r); }
    Json operator()(const RecordedSetting& r) {
        return {{"setting", text_json(r.key)}, {"value", text_json(r.value)}};
    }
    Json operator()(const RecordedStage& r) {
        return {{"stage", r.stage}, {"name", text_json(r.name)}};
    }
    Json operator()(const RecordedMesh& r) {
        return {{"mesh", r.mesh},
                {"name", text_json(r.name)},
                {"coordinate_bytes", r.coordinate_bytes},
                {"coordinates", reals_json(r.coordinates)},
                {"indices", r.indices}};
    }
    Json operator()(const RecordedTree& r) {
        return {{"tree", r.tree},
                {"name", text_json(r.name)},
                {"of_mesh", number_json(r.mesh)},
                {"directions", reals_json(r.directions)}};
    }
    Json operator()(const RecordedNode& r) {
        return {{"node", r.node},
                {"in_tree", r.tree},
                {"parent", number_json(r.parent)},
                {"id", r.id},
                {"name", text_json(r.name)},
                {"children", r.children},
                {"items", r.items},
                {"volume", volume_json(r.volume)}};
    }
    Json operator()(const RecordedObject& r) {
        return {{"object", r.object}, {"in_tree", r.tree}, {"volume", volume_json(r.volume)}};
    }
    Json operator()(const RecordedRefit& r) {
        return {{"refit", r.node}, {"in_tree", r.tree}, {"volume", volume_json(r.volume)}};
    }
    Json operator()(const RecordedBody& r) {
        return {{"body", r.body}, {"name", text_json(r.name)}, {"of_tree", r.tree}};
    }
    Json operator()(const RecordedFrame& r) { return {{"frame", r.frame}}; }
    Json operator()(const RecordedPose& r) {
        return {{"pose", r.body}, {"rows", reals_json(r.rows)}};
    }
    Json operator()(const RecordedQuery& r) {
        Json line = {{"query", Json::array({r.body_a, r.body_b})}};
        if (!r.has_label) return line;
        line["name"] = text_json(r.name);
        line["tags"] = Json::array();
        for (const std::string& tag : r.tags) line["tags"].push_back(text_json(tag));
        return line;
    }
    Json operator()(const RecordedQueryEnd& r) {
        const Json complete = r.complete > 1 ? Json(r.complete) : Json(r.complete == 1);
        return {{"complete", complete}, {"nanoseconds", r.nanoseconds}};
    }
    Json operator()(const RecordedEnd&) { return {{"end", true}}; }
    Json operator()(const RecordedLog& r) { return {{"log", text_json(r.text)}}; }
    Json operator()(const RecordedMeasure& r) {
        const bool named = r.aim < recorded_aim_count;
        return {{"measure",
                 named ? Json(recorded_aim_names[static_cast<RecordedAim>(r.aim)]) : Json(r.aim)},
                {"limit", real_json(r.limit)},
                {"relative_error", real_json(r.relative_error)}};
    }
    Json operator()(const RecordedAnswer& r) {
        return {{"distance", real_json(r.distance)},
                {"items", {number_json(r.item_a), number_json(r.item_b)}},
                {"points", reals_json(r.points)}};
    }
    Json operator()(const RecordedUnknown& r) {
        return {{"unknown", r.tag}, {"hex", hex_of(r.bytes)}};
    }
};

}  // namespace

void RecordingJsonWriter::add(const Record& record) {
    constexpr std::size_t most_tests = 100;
    const auto* event = std::get_if<RecordedEvent>(&record);
    if (!event || test_count_ == most_tests) end_tests();
    if (event) {
        tests_ += (test_count_++ == 0 ? "" : ",") + event_json(*event).dump();
        return;
    }
    Json line = std::visit(LineOf{}, record);
    if (!record.appended.empty()) line["appended"] = hex_of(record.appended);
    text_ += line.dump() + '\n';
}

void RecordingJsonWriter::end_tests() {
    if (test_count_ != 0) text_ += "{\"tests\":[" + tests_ + "]}\n";
    tests_.clear();
    test_count_ = 0;
}

std::string RecordingJsonWriter::take() { return std::exchange(text_, {}); }

std::string RecordingJsonWriter::finish() {
    end_tests();
    return take();
}

std::string recording_as_json(std::string_view bytes, std::string_view name) {
    RecordingReader reader(bytes, name);
    RecordingJsonWriter out;
    while (const Record* record = reader.next()) out.add(*record);
    return out.finish();
}

}  // namespace scb::scenes

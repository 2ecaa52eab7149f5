#include "scenes/recordings/join_recordings.h"

#include <algorithm>
#include <compare>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scb/error.h"

namespace scb::scenes {
namespace {

/// The thing that a record describes.
struct Subject {
    RecordTag tag{};
    std::uint32_t number = 0, node = 0;
    std::string key = {};  ///< of a setting

    auto operator<=>(const Subject&) const = default;

    bool is_definition() const {
        return stays_in_frames() || tag == RecordTag::tree || tag == RecordTag::node;
    }
    /// Whether one record describes all of it, and is valid until the next one.
    bool stays_in_frames() const {
        return tag == RecordTag::stage || tag == RecordTag::mesh || tag == RecordTag::body;
    }
    std::string name() const {
        const std::string of = std::to_string(number);
        switch (tag) {
            case RecordTag::stage:
                return "stage " + of;
            case RecordTag::mesh:
                return "mesh " + of;
            case RecordTag::tree:
                return "tree " + of;
            case RecordTag::node:
                return "node " + std::to_string(node) + " of tree " + of;
            default:
                return "body " + of;
        }
    }
};

/// The subject of a record; none for events, which never repeat.
struct SubjectOf {
    using Found = std::optional<Subject>;

    Found operator()(const RecordedSetting& r) { return {{RecordTag::setting, 0, 0, r.key}}; }
    Found operator()(const RecordedStage& r) { return {{RecordTag::stage, r.stage}}; }
    Found operator()(const RecordedMesh& r) { return {{RecordTag::mesh, r.mesh}}; }
    Found operator()(const RecordedTree& r) { return {{RecordTag::tree, r.tree}}; }
    Found operator()(const RecordedNode& r) { return {{RecordTag::node, r.tree, r.node}}; }
    Found operator()(const RecordedRefit& r) { return {{RecordTag::refit, r.tree, r.node}}; }
    Found operator()(const RecordedObject& r) { return {{RecordTag::object, r.tree, r.object}}; }
    Found operator()(const RecordedBody& r) { return {{RecordTag::body, r.body}}; }
    Found operator()(const RecordedPose& r) { return {{RecordTag::pose, r.body}}; }
    template <class R>
    Found operator()(const R&) {
        return {};
    }
};

/// The records written about a subject, and the recording that they come from.
struct Said {
    std::vector<std::vector<std::uint8_t>> payloads;
    std::size_t reader = 0;
    std::optional<std::uint32_t> frame;
};

class Join {
  public:
    Join(std::span<RecordingReader> readers, const std::function<void(const Record&)>& write)
        : readers_(readers), write_(write) {}

    void begin_frame(std::uint32_t frame) {
        frame_ = frame;
        std::erase_if(said_, [](const auto& said) { return !said.first.stays_in_frames(); });
        write_(RecordedFrame{frame});
    }

    /// Writes the records of a recording up to its next frame. Returns the number of that frame.
    std::optional<std::uint32_t> add(std::size_t reader) {
        bool in_query = false;
        std::optional<std::uint32_t> next;
        while (const Record* record = readers_[reader].next()) {
            if (const auto* frame = std::get_if<RecordedFrame>(record)) {
                next = frame->frame;
                break;
            }
            if (std::holds_alternative<RecordedQuery>(*record)) in_query = true;
            if (std::holds_alternative<RecordedQueryEnd>(*record)) in_query = false;
            if (!std::holds_alternative<RecordedEnd>(*record) && is_new(*record, reader))
                write_(*record);
        }
        // Else the query would contain the queries of the other recordings.
        if (in_query) write_(RecordedQueryEnd{false, 0});
        if (next && frame_ && *next <= *frame_)
            throw InputError(readers_[reader].name() + ": frame " + std::to_string(*next) +
                             " follows frame " + std::to_string(*frame_) +
                             "; record frames in ascending order.");
        return next;
    }

  private:
    /// Whether no other recording has written the same record.
    bool is_new(const Record& record, std::size_t reader) {
        const auto subject = std::visit(SubjectOf{}, record);
        if (!subject) return true;
        auto payload = record_payload(record);
        Said& said = said_[*subject];
        if (!said.payloads.empty() && said.reader != reader) {
            // Before the first frame, a recording may describe a subject repeatedly, and all
            // recordings do so. Later, only a record equal to the latest one means the same for the
            // queries that follow.
            const bool any = !frame_ && subject->tag != RecordTag::pose &&
                             subject->tag != RecordTag::refit && subject->tag != RecordTag::object;
            const auto end = said.payloads.end();
            if (std::find(any ? said.payloads.begin() : end - 1, end, payload) != end) return false;
            if (subject->is_definition() && said.frame == frame_)
                throw InputError(readers_[reader].name() + ": " + subject->name() +
                                 " is not that of " + readers_[said.reader].name() +
                                 (frame_ ? " in frame " + std::to_string(*frame_) : "") +
                                 "; give what differs another number in each thread.");
        }
        if (frame_) said.payloads.clear();
        said.payloads.push_back(std::move(payload));
        said.reader = reader;
        said.frame = frame_;
        forget_what_ends(*subject);
        return true;
    }

    /// A tree that is recorded again begins with the volumes of its nodes, and without objects.
    void forget_what_ends(const Subject& subject) {
        if (subject.tag != RecordTag::tree) return;
        for (const RecordTag tag : {RecordTag::refit, RecordTag::object})
            said_.erase(said_.lower_bound({tag, subject.number, 0}),
                        said_.upper_bound({tag, subject.number, UINT32_MAX}));
    }

    std::span<RecordingReader> readers_;
    const std::function<void(const Record&)>& write_;
    std::map<Subject, Said> said_;
    std::optional<std::uint32_t> frame_;  ///< none before the first frame
};

}  // namespace

void join_recordings(std::span<RecordingReader> readers,
                     const std::function<void(const Record&)>& write) {
    if (readers.size() == 1) {
        while (const Record* record = readers[0].next()) write(*record);
        return;
    }
    Join join(readers, write);
    std::vector<std::optional<std::uint32_t>> next;
    for (std::size_t i = 0; i < readers.size(); ++i) next.push_back(join.add(i));
    while (true) {
        std::optional<std::uint32_t> frame;
        for (const auto& n : next)
            if (n && (!frame || *n < *frame)) frame = n;
        if (!frame) break;
        join.begin_frame(*frame);
        for (std::size_t i = 0; i < readers.size(); ++i)
            if (next[i] == frame) next[i] = join.add(i);
    }
    if (std::all_of(readers.begin(), readers.end(),
                    [](const RecordingReader& reader) { return reader.damage().empty(); }))
        write(RecordedEnd{});
}

}  // namespace scb::scenes

#include "tests/recordings/renumbered.h"

#include <map>
#include <variant>

#include "scenes/recordings/recording_file.h"

namespace scb {

using namespace scenes;

std::uint32_t renumbered(std::uint32_t tree, std::uint32_t node) {
    return tree == 0 ? 100'000 - 3 * node : 3'000'000'007 + 2 * (node ^ 1);
}

std::string renumbered(const std::string& bytes) {
    RecordingReader reader(bytes, "test");
    RecordingWriter writer;
    std::map<std::uint32_t, std::uint32_t> tree_of_body;
    std::uint32_t a = 0, b = 0;  // trees of the query
    while (const Record* record = reader.next()) {
        Record copy = *record;
        if (auto* node = std::get_if<RecordedNode>(&copy)) {
            if (node->node % 7 == 0) node->name = "node of " + std::to_string(node->node);
            node->node = renumbered(node->tree, node->node);
            if (node->parent != record_none) node->parent = renumbered(node->tree, node->parent);
            for (std::uint32_t& child : node->children) child = renumbered(node->tree, child);
        } else if (auto* refit = std::get_if<RecordedRefit>(&copy)) {
            refit->node = renumbered(refit->tree, refit->node);
        } else if (const auto* body = std::get_if<RecordedBody>(&copy)) {
            tree_of_body[body->body] = body->tree;
        } else if (const auto* query = std::get_if<RecordedQuery>(&copy)) {
            a = tree_of_body.at(query->body_a);
            b = tree_of_body.at(query->body_b);
        } else if (auto* event = std::get_if<RecordedEvent>(&copy)) {
            if (event->tag < static_cast<std::uint8_t>(RecordTag::items_apart)) {
                event->a = renumbered(a, event->a);
                event->b = renumbered(b, event->b);
            }
        }
        writer.add(copy);
    }
    return writer.finish();
}

}  // namespace scb

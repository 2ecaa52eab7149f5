#include "core/platform/near_word.h"

#include <algorithm>
#include <string_view>

namespace scb {
namespace {

/// The number of letters to add, remove or change to turn one word into the other (Levenshtein).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row[b.size()];
}

}  // namespace

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
    const std::string* nearest = nullptr;
    std::size_t least = std::min(std::max<std::size_t>(2, word.size() / 3) + 1, word.size());
    for (const std::string& other : known) {
        const std::size_t distance = edit_distance(word, other);
        if (distance >= least) continue;
        least = distance;
        nearest = &other;
    }
    return nearest == nullptr ? "" : ", did you mean " + *nearest + "?";
}

}  // namespace scb

#pragma once

#include <string>
#include <vector>

namespace scb {

/// ", did you mean obb?": the known word that differs in the fewest letters; the first of several.
/// Empty if every word differs in more than two letters and more than a third of `word`, or in all
/// of them.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

}  // namespace scb

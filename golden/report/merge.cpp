#include "golden/report/merge.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "core/platform/shard.h"
#include "scb/error.h"

namespace scb::golden {
namespace {

std::optional<Shard> shard_of(const ResultPart& part) {
    if (part.result.shard.empty()) return std::nullopt;
    try {
        return parse_shard(part.result.shard);
    } catch (const InputError& error) {
        throw InputError(part.file + ": shard: " + error.what());
    }
}

std::string text_of(const Shard& shard) {
    return std::to_string(shard.k) + "/" + std::to_string(shard.n);
}

/// The parts in the order of their shards. Throws InputError if they are not of one run.
std::vector<const ResultPart*> in_order(const std::vector<ResultPart>& parts) {
    std::vector<const ResultPart*> order;
    std::set<std::size_t> shards;
    std::set<std::string> names;
    const std::optional<Shard> first = shard_of(parts.front());
    for (const ResultPart& part : parts) {
        if (part.result.suite != parts.front().result.suite)
            throw InputError(part.file + ": these are results of " + part.result.suite +
                             ", and others of " + parts.front().result.suite +
                             "; report them apart.");
        const std::optional<Shard> shard = shard_of(part);
        if (shard.has_value() != first.has_value() || (shard && shard->n != first->n))
            throw InputError(part.file + ": these are results of " +
                             (shard ? "shard " + text_of(*shard) : "no shard") +
                             ", and others of " +
                             (first ? "shard " + text_of(*first) : "no shard") +
                             "; give the results of one run.");
        if (shard && !shards.insert(shard->k).second)
            throw InputError(part.file + ": the shard " + text_of(*shard) +
                             " is in other results too; give the results of one run.");
        for (const CaseResult& c : part.result.cases)
            if (!names.insert(c.name).second)
                throw InputError(part.file + ": the case " + c.name +
                                 " is in other results too; give the results of one run.");
        order.push_back(&part);
    }
    std::stable_sort(order.begin(), order.end(), [](const ResultPart* a, const ResultPart* b) {
        const std::optional<Shard> x = shard_of(*a), y = shard_of(*b);
        return x && y && x->k < y->k;
    });
    return order;
}

/// The shards received cases in turn, see in_shard.
std::vector<CaseResult> cases_in_turn(const std::vector<const ResultPart*>& order) {
    std::vector<CaseResult> cases;
    std::size_t longest = 0;
    for (const ResultPart* part : order) longest = std::max(longest, part->result.cases.size());
    for (std::size_t i = 0; i < longest; ++i)
        for (const ResultPart* part : order)
            if (i < part->result.cases.size()) cases.push_back(part->result.cases[i]);
    return cases;
}

void add(std::string& text, const std::string& sentence) {
    text += (text.empty() || sentence.empty() ? "" : " ") + sentence;
}

std::string missing_shards(const std::vector<const ResultPart*>& order, std::size_t n) {
    std::set<std::size_t> there;
    for (const ResultPart* part : order) there.insert(shard_of(*part)->k);
    std::string missing;
    for (std::size_t k = 1; k <= n; ++k)
        if (!there.contains(k)) missing += (missing.empty() ? "" : ", ") + text_of({k, n});
    return "These shards are missing: " + missing + "; see why, and give their results.json too.";
}

/// Shards have equal numbers of cases, or the first ones have one more.
std::string uneven_shards(const std::vector<const ResultPart*>& order) {
    std::size_t most = 0;
    for (const ResultPart* part : order) most = std::max(most, part->result.cases.size());
    bool fewer = false;
    for (const ResultPart* part : order) {
        const std::size_t size = part->result.cases.size();
        fewer |= size + 1 == most;
        if (size + 1 < most || (fewer && size == most))
            return "The shards were not dealt from the same cases, or were interrupted: " +
                   part->file + " has " + std::to_string(size) + ", and another " +
                   std::to_string(most) + ".";
    }
    return "";
}

using Environment = std::vector<std::pair<std::string, std::string>>;

/// Each version: alone if all parts have the same, else with the parts that have it.
Environment merged_environment(const std::vector<const ResultPart*>& order) {
    std::vector<std::string> names;
    std::map<std::string, std::vector<std::pair<std::string, std::vector<std::string>>>> versions;
    for (const ResultPart* part : order)
        for (const auto& [name, value] : part->result.environment) {
            auto& known = versions[name];
            if (known.empty()) names.push_back(name);
            auto same = std::find_if(known.begin(), known.end(),
                                     [&v = value](const auto& k) { return k.first == v; });
            if (same == known.end()) same = known.insert(same, {value, {}});
            same->second.push_back(part->result.shard.empty() ? part->file
                                                              : "shard " + part->result.shard);
        }
    Environment merged;
    for (const std::string& name : names) {
        std::string text;
        for (const auto& [value, owners] : versions[name]) {
            text += (text.empty() ? "" : "; ") + value;
            if (owners.size() == order.size()) continue;
            for (std::size_t i = 0; i < owners.size(); ++i)
                text += (i == 0 ? " (" : ", ") + owners[i];
            text += ")";
        }
        merged.emplace_back(name, text);
    }
    return merged;
}

}  // namespace

SuiteResult merge_results(const std::vector<ResultPart>& parts) {
    SuiteResult merged;
    if (parts.empty()) return merged;
    const std::vector<const ResultPart*> order = in_order(parts);
    merged.suite = parts.front().result.suite;
    merged.environment = merged_environment(order);
    for (const ResultPart* part : order) add(merged.incomplete, part->result.incomplete);
    if (const std::optional<Shard> first = shard_of(parts.front())) {
        merged.cases = cases_in_turn(order);
        if (order.size() < first->n) {
            for (const ResultPart* part : order)
                merged.shard += (merged.shard.empty() ? "" : ", ") + part->result.shard;
            add(merged.incomplete, missing_shards(order, first->n));
        } else if (merged.incomplete.empty()) {
            add(merged.incomplete, uneven_shards(order));
        }
    } else {
        for (const ResultPart* part : order)
            merged.cases.insert(merged.cases.end(), part->result.cases.begin(),
                                part->result.cases.end());
    }
    if (merged.cases.empty()) add(merged.incomplete, "No case was checked.");
    return merged;
}

}  // namespace scb::golden

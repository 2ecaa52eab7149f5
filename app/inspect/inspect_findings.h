#pragma once

#include <string>
#include <vector>

#include "app/inspect/inspect_report.h"

namespace scb::app {

/// A sentence if the test rejected volumes that meet.
std::vector<std::string> alarm_findings(const InspectReport& report);

/// Whether other settings were tried, in enough tests to advise one.
/// Whether there are enough tests for an advice.
bool has_enough_tests(const InspectReport& report);
bool has_advice(const InspectReport& report);

/// The distances that were found, and how many of them a certificate proves.
struct CertifiedCount {
    std::size_t distances = 0, certified = 0;
};
CertifiedCount certified_count(const InspectReport& report);
/// A sentence on it; none for queries of a recording, and for queries that find no distance.
std::vector<std::string> certified_findings(const InspectReport& report);

/// The setting that would have helped most; with too few tests, a sentence on that. The table
/// of settings has the others.
std::vector<std::string> advice_findings(const InspectReport& report);

/// How much was wasted and why, and which triangles took the most tests.
std::vector<std::string> waste_findings(const InspectReport& report);

/// The main findings, a sentence each: alarm, certificates, advice, cuts and waste.
std::vector<std::string> inspect_findings(const InspectReport& report);

/// "the test rejected 4 pairs of volumes that meet, and so missed 12 pairs of triangles."
std::string wrong_rejections_sentence(const PassCounts& counts, QueryKind kind);

/// "12 pairs of triangles missed"
std::string missed_words(const WrongRejection& rejection);

}  // namespace scb::app

#include "golden/report/junit.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cstddef>
#include <kainjow/mustache.hpp>

#include "core/platform/utf8.h"
#include "golden/report/plain_text.h"
#include "render/gl/embedded.h"

SCB_DECLARE_EMBEDDED(junit_xml)

namespace scb::golden {
namespace {

using kainjow::mustache::data;
using kainjow::mustache::mustache;

/// With a point, in any locale.
std::string junit_seconds(double seconds) {
    std::array<char, 400> buffer{};  // the largest double has 309 digits
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), seconds,
                                   std::chars_format::fixed, 3)
                         .ptr;
    return std::string(buffer.data(), end);
}

const char* element_of(Verdict verdict) {
    if (verdict == Verdict::skipped) return "skipped";
    return verdict == Verdict::could_not_run ? "error" : "failure";
}

std::string lines_of(const CaseResult& result) {
    std::string text;
    for (const std::string& line : result_lines(result)) text += line + "\n";
    if (!result.reproduce.empty()) text += "reproduce: " + result.reproduce + "\n";
    if (!result.diff.empty()) text += "compare the traces: " + result.diff + "\n";
    if (!result.update.empty()) text += "update: " + result.update + "\n";
    return text;
}

data case_of(const CaseResult& result) {
    data values;
    values["name"] = xml_text(result.name);
    values["time"] = junit_seconds(result.seconds);
    if (result.verdict == Verdict::same) {
        values["outcome"] = data(data::type::bool_false);
        return values;
    }
    data outcome;
    outcome["element"] = element_of(result.verdict);
    outcome["message"] = xml_text(first_words(result));
    outcome["verdict"] = std::string(verdict_names[result.verdict]);
    outcome["lines"] = xml_text(lines_of(result));
    values.set("outcome", outcome);
    return values;
}

}  // namespace

std::string junit_xml(const SuiteResult& result) {
    std::size_t failures = 0, errors = 0, skipped = 0;
    double seconds = 0;
    data cases(data::type::list), properties(data::type::list);
    std::vector<CaseResult> all = result.cases;
    if (!result.incomplete.empty()) {
        CaseResult run;
        run.name = "the whole run";
        run.verdict = Verdict::could_not_run;
        run.message = result.incomplete;
        all.push_back(run);
    }
    for (const CaseResult& one : all) {
        errors += one.verdict == Verdict::could_not_run;
        skipped += one.verdict == Verdict::skipped;
        failures += is_failure(one.verdict) && one.verdict != Verdict::could_not_run;
        seconds += one.seconds;
        cases << case_of(one);
    }
    const auto add_property = [&](const std::string& name, const std::string& value) {
        data property;
        property["name"] = xml_text(name);
        property["value"] = xml_text(value);
        properties << property;
    };
    if (!result.shard.empty()) add_property("shard", result.shard);
    for (const auto& [name, version] : result.environment) add_property(name, version);
    data values;
    values["suite"] = xml_text(result.suite);
    values["tests"] = std::to_string(all.size());
    values["failures"] = std::to_string(failures);
    values["errors"] = std::to_string(errors);
    values["skipped"] = std::to_string(skipped);
    values["time"] = junit_seconds(seconds);
    values.set("properties", properties);
    values.set("cases", cases);
    mustache xml{std::string(SCB_EMBEDDED(junit_xml))};
    assert(xml.is_valid() && "the template is part of the program");
    return xml.render(values);
}

namespace {

/// The number of bytes of the text's first character; 0 if XML does not allow it (section 2.2 of
/// the recommendation).
std::size_t character_length(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text[0]);
    if (lead < 0x20) return lead == '\t' || lead == '\n' || lead == '\r' ? 1 : 0;
    const std::string_view character = text.substr(0, utf8_length(text));
    return character == "\uFFFE" || character == "\uFFFF" ? 0 : character.size();
}

}  // namespace

std::string xml_text(std::string_view text) {
    std::string allowed;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = character_length(text.substr(at));
        if (length == 0)
            allowed += "\uFFFD";
        else
            allowed += text.substr(at, length);
        at += std::max<std::size_t>(1, length);
    }
    return allowed;
}

}  // namespace scb::golden

#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program.h"

namespace scb::app {

/// What `inspect --json` prints.
inline nlohmann::json inspect(const std::string& arguments, int status = 0) {
    const ProgramRun run = run_scb("inspect --json " + arguments);
    EXPECT_EQ(run.status, status) << arguments << run.err;
    return nlohmann::json::parse(run.out);
}

/// The number of tests that passed their pair for this reason.
inline std::uint64_t count(const nlohmann::json& entry, const std::string& reason) {
    return entry["inner"][reason].get<std::uint64_t>() +
           entry["leaves"][reason].get<std::uint64_t>();
}

}  // namespace scb::app

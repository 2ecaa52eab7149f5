#pragma once

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

}  // namespace scb::app

#pragma once

#include <string>
#include <vector>

namespace scb::app {

/// A requirement of the program on the machine.
struct DoctorFinding {
    std::string name;
    bool works = false;
    bool is_optional = false;
    std::string text{};    ///< its version or state, or why it does not work
    std::string remedy{};  ///< if it does not work: how to install it
};

/// Tries everything once.
std::vector<DoctorFinding> doctor_findings();

}  // namespace scb::app

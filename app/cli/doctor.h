#pragma once

#include <string>
#include <vector>

namespace scb::app {

/// Something that the program needs of the machine.
struct DoctorFinding {
    std::string name;
    bool works = false;
    bool is_optional = false;
    std::string text{};    ///< what is there, or why not
    std::string remedy{};  ///< where it does not work: what installs it
};

/// Tries everything once.
std::vector<DoctorFinding> doctor_findings();

}  // namespace scb::app

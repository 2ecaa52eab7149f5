#pragma once

#include <set>
#include <string>

#include "tests/temporary_folder.h"

namespace scb::app {

/// A shell on a terminal of its own, as a user has it, in a folder where `scb` is on the path and
/// completes. Throws std::runtime_error where it does not answer in a minute.
class Shell {
  public:
    /// "bash", "zsh" or "fish".
    static bool is_installed(const std::string& name);

    Shell(const std::string& name, const std::string& folder);
    ~Shell();
    Shell(const Shell&) = delete;
    Shell& operator=(const Shell&) = delete;

    /// The words that the shell offers for the last one of the line; folders without '/' at their
    /// end.
    std::set<std::string> offers(const std::string& line);

  private:
    std::set<std::string> asked_offers(const std::string& line) const;
    void type(const std::string& keys) const;
    /// What the shell writes into its answer file; removes that.
    std::string answer();

    std::string name_, folder_;
    TemporaryFolder own_;
    int terminal_ = -1, process_ = 0;
};

}  // namespace scb::app

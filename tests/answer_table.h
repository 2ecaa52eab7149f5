#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "scb/pose.h"
#include "tests/real_models.h"

namespace scb {

/// A table with a header, whose first character is '#', and tabs.
class AnswerTable {
  public:
    explicit AnswerTable(const std::string& file) : in_(models_folder() / ".." / "answers" / file) {
        std::string line;
        if (!std::getline(in_, line)) return;
        const std::vector<std::string> names = cells(line.substr(1));
        for (std::size_t i = 0; i < names.size(); ++i) columns_[names[i]] = i;
    }
    bool next() {
        std::string line;
        if (!std::getline(in_, line)) return false;
        row_ = cells(line);
        return true;
    }
    const std::string& text(const std::string& name) const { return row_[columns_.at(name)]; }
    double number(const std::string& name) const { return std::stod(text(name)); }
    Pose pose() const {
        Pose pose;
        for (int i = 0; i < 3; ++i) {
            const std::string row = std::to_string(i);
            for (int j = 0; j < 3; ++j) pose.rotation(i, j) = number("r" + row + std::to_string(j));
            pose.translation[i] = number("t" + row);
        }
        return pose;
    }

  private:
    static std::vector<std::string> cells(const std::string& line) {
        std::vector<std::string> result;
        std::istringstream in(line);
        for (std::string cell; std::getline(in, cell, '\t');) result.push_back(cell);
        return result;
    }
    std::ifstream in_;
    std::map<std::string, std::size_t> columns_;
    std::vector<std::string> row_;
};

}  // namespace scb

#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

namespace scb::render {

/// A file without a name, which is gone with its last user, whatever happens.
class UnnamedFile {
  public:
    /// Throws OutputError where there is no room for one.
    UnnamedFile();

    int descriptor() const { return fileno(file_.get()); }

    /// All of it. Throws OutputError where it cannot be read.
    std::vector<std::uint8_t> bytes() const;

    /// Empties the file; all its users write at its beginning then. Throws OutputError.
    void clear() const;

  private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

}  // namespace scb::render

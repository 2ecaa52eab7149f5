#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

namespace scb {

/// A file without a name, which the system always deletes after its last use.
class UnnamedFile {
  public:
    /// Throws OutputError if there is no room for one.
    UnnamedFile();

    int descriptor() const { return fileno(file_.get()); }

    /// The whole content. Throws OutputError if it cannot be read.
    std::vector<std::uint8_t> bytes() const;

    /// Empties the file; all its users then write at its beginning. Throws OutputError.
    void clear() const;

  private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

}  // namespace scb

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/reference/command_reference.h"

namespace scb::app {

/// Throws InputError, one sentence that begins with the file of a shard, where the words of its
/// command, which may be a stranger's, have what Option::shareable does not allow. A word is
/// "--option=value", "--flag" or an argument, as given_words makes them.
void check_shard_words(const std::filesystem::path& file, const std::vector<std::string>& words,
                       const ReferenceCommand& program);

}  // namespace scb::app

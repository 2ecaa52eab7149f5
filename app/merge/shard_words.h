#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/reference/command_reference.h"

namespace scb::app {

/// Throws InputError, one sentence that begins with the shard's file, if the words of its command
/// have options that Option::shareable does not allow: the file may be a stranger's. A word is
/// "--option=value", "--flag" or an argument, as from given_words.
void check_shard_words(const std::filesystem::path& file, const std::vector<std::string>& words,
                       const ReferenceCommand& program);

}  // namespace scb::app

#include "scenes/meshes/collada_check.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "core/platform/tokens.h"
#include "scb/error.h"

namespace scb::scenes {

void check_collada(std::string_view bytes, const std::string& name) {
    constexpr std::string_view open = "<p", close = "</";
    std::size_t list = 0;
    for (std::size_t at = bytes.find(open); at != bytes.npos; at = bytes.find(open, at)) {
        at += open.size();
        if (at >= bytes.size() || std::string_view("> \t\r\n").find(bytes[at]) == bytes.npos)
            continue;
        at = std::min(bytes.find('>', at), bytes.size() - 1) + 1;
        if (at >= 2 && bytes[at - 2] == '/') continue;
        const std::string_view indices = bytes.substr(at, bytes.find(close, at) - at);
        ++list;
        if (indices.find_first_of("&<") != indices.npos)
            throw InputError(name + ": list " + std::to_string(list - 1) +
                             " of <p> is not plain numbers, which would be misread; write it "
                             "without entities, comments and CDATA.");
        Words words{indices};
        std::size_t i = 0;
        for (std::string_view word = words.next(); !word.empty(); word = words.next(), ++i) {
            std::uint32_t index = 0;
            const auto parsed = std::from_chars(word.data(), word.data() + word.size(), index);
            if (parsed.ec != std::errc{} || parsed.ptr != word.data() + word.size())
                throw InputError(name + ": index " + std::to_string(i) + " of list " +
                                 std::to_string(list - 1) + " of <p> is " + excerpt(word) +
                                 ", and indices are whole numbers from 0; repair the index.");
        }
    }
}

}  // namespace scb::scenes

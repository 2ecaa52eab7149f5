#include "scenes/meshes/collada_check.h"

#include <algorithm>

#include "scb/error.h"
#include "scenes/text/tokens.h"

namespace scb::scenes {

void check_collada(std::string_view bytes, const std::string& name) {
    constexpr std::string_view open = "<p", close = "</";
    std::size_t list = 0;
    for (std::size_t at = bytes.find(open); at != bytes.npos; at = bytes.find(open, at)) {
        at += open.size();
        if (bytes.substr(at).find_first_of("> \t\r\n") != 0) continue;
        at = std::min(bytes.find('>', at), bytes.size() - 1) + 1;
        if (at >= 2 && bytes[at - 2] == '/') continue;
        const std::string_view indices = bytes.substr(at, bytes.find(close, at) - at);
        ++list;
        if (indices.find_first_of("&<") != indices.npos)
            throw InputError(name + ": list " + std::to_string(list - 1) +
                             " of <p> is not plain numbers, which would be misread; write it "
                             "without entities, comments and CDATA.");
        if (indices.find('-') == indices.npos) continue;
        Words words{indices};
        std::size_t i = 0;
        for (std::string_view word = words.next(); !word.empty(); word = words.next(), ++i)
            if (word[0] == '-' && word != "-0")
                throw InputError(name + ": index " + std::to_string(i) + " of list " +
                                 std::to_string(list - 1) + " of <p> is " + excerpt(word) +
                                 ", and indices start from 0; repair the index.");
    }
}

}  // namespace scb::scenes

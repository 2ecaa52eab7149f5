#include "scenes/meshes/collada_check.h"

#include "scb/error.h"
#include "scenes/text/tokens.h"

namespace scb::scenes {

void check_collada(std::string_view bytes, const std::string& name) {
    constexpr std::string_view open = "<p>", close = "</p>";
    std::size_t list = 0;
    for (std::size_t at = bytes.find(open); at != bytes.npos; at = bytes.find(open, at), ++list) {
        at += open.size();
        const std::string_view indices = bytes.substr(at, bytes.find(close, at) - at);
        if (indices.find('-') == indices.npos) continue;
        Words words{indices};
        std::size_t i = 0;
        for (std::string_view word = words.next(); !word.empty(); word = words.next(), ++i)
            if (word[0] == '-' && word != "-0")
                throw InputError(name + ": index " + std::to_string(i) + " of list " +
                                 std::to_string(list) + " of <p> is " + excerpt(word) +
                                 ", and indices start from 0; repair the index.");
    }
}

}  // namespace scb::scenes

#include "scenes/meshes/three_mf_check.h"

#include <minizip/unzip.h>

#include <array>
#include <memory>

#include "core/platform/tokens.h"
#include "scb/error.h"
#include "scenes/meshes/xml_reader.h"

namespace scb::scenes {
namespace {

/// The opened file of a package; empty if it cannot be unpacked.
std::string unpacked(unzFile package) {
    std::string bytes;
    std::array<char, 1 << 16> part{};
    for (;;) {
        const int count =
            unzReadCurrentFile(package, part.data(), static_cast<unsigned>(part.size()));
        if (count < 0) return {};
        if (count == 0) return bytes;
        bytes.append(part.data(), static_cast<std::size_t>(count));
    }
}

}  // namespace

void check_3mf_model(std::string_view model, const std::string& name) {
    constexpr std::size_t matrix_size = 12;
    XmlReader reader(model, name);
    while (const std::optional<XmlEvent> event = reader.next()) {
        if (event->kind != XmlEvent::start) continue;
        const auto transform = xml_attribute(event->attributes, "transform");
        if (!transform) continue;
        Words words{*transform};
        std::size_t count = 0;
        bool are_numbers = true;
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
            are_numbers = are_numbers && number_in(word);
            ++count;
        }
        if (count != matrix_size || !are_numbers)
            throw InputError(name + ": the transform of a <" + std::string(event->name) + "> has " +
                             std::to_string(count) + (are_numbers ? " numbers" : " words") +
                             " in place of 12 numbers; repair the file.");
    }
}

void check_3mf(const std::string& path) {
    const std::unique_ptr<void, int (*)(unzFile)> package(unzOpen64(path.c_str()), unzClose);
    if (!package) return;
    for (int found = unzGoToFirstFile(package.get()); found == UNZ_OK;
         found = unzGoToNextFile(package.get())) {
        if (unzOpenCurrentFile(package.get()) != UNZ_OK) continue;
        const std::string bytes = unpacked(package.get());
        unzCloseCurrentFile(package.get());
        // Models may have any name in a package.
        if (bytes.find("<model") != bytes.npos || bytes.find(":model") != bytes.npos)
            check_3mf_model(bytes, path);
    }
}

}  // namespace scb::scenes

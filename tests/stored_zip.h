#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace scb {

/// A zip archive of these files, by name, that are not compressed.
inline std::string stored_zip(const std::vector<std::pair<std::string, std::string>>& files) {
    const auto number = [](std::uint64_t value, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 255);
        return text;
    };
    std::string archive, directory;
    for (const auto& [name, bytes] : files) {
        const uLong sum = ::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
        // Version, flags, method, time and date; then sum, sizes, length of the name and no more.
        const std::string about = number(20, 2) + std::string(4, '\0') + number(0x00210000, 4) +
                                  number(sum, 4) + number(bytes.size(), 4) +
                                  number(bytes.size(), 4) + number(name.size(), 2) + number(0, 2);
        directory += "PK\1\2" + number(20, 2) + about + std::string(10, '\0') +
                     number(archive.size(), 4) + name;
        archive += "PK\3\4" + about + name + bytes;
    }
    return archive + directory + "PK\5\6" + number(0, 4) + number(files.size(), 2) +
           number(files.size(), 2) + number(directory.size(), 4) + number(archive.size(), 4) +
           number(0, 2);
}

/// A 3MF package of one model.
inline std::string package_3mf(const std::string& model, bool with_thumbnail = false) {
    const std::string relations = "http://schemas.openxmlformats.org/package/2006/";
    std::string targets =
        R"(<Relationship Target="/3D/3dmodel.model" Id="r0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>)";
    std::vector<std::pair<std::string, std::string>> files = {
        {"[Content_Types].xml",
         R"(<?xml version="1.0" encoding="UTF-8"?><Types xmlns=")" + relations +
             R"(content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/><Default Extension="png" ContentType="image/png"/></Types>)"}};
    if (with_thumbnail) {
        targets += R"(<Relationship Target="/Metadata/thumbnail.png" Id="r1" Type=")" + relations +
                   R"(relationships/metadata/thumbnail"/>)";
        files.emplace_back("Metadata/thumbnail.png", "not looked into");
    }
    files.emplace_back("_rels/.rels",
                       R"(<?xml version="1.0" encoding="UTF-8"?><Relationships xmlns=")" +
                           relations + R"(relationships">)" + targets + "</Relationships>");
    files.emplace_back("3D/3dmodel.model", model);
    return stored_zip(files);
}

/// A tetrahedron.
inline constexpr const char* model_of_3mf =
    R"(<?xml version="1.0" encoding="UTF-8"?><model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1" type="model"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/><triangle v1="1" v2="2" v3="3"/><triangle v1="2" v2="0" v3="3"/></triangles></mesh></object></resources><build><item objectid="1"/></build></model>)";

}  // namespace scb

// make_samples DIR: writes the sample meshes, bracket.ply and pin.obj, into this folder.
// scenes/samples/ has them.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "tests/samples/sample_meshes.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: make_samples DIR\n";
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    const auto write = [&](const char* name, const std::string& text) {
        std::ofstream file(folder / name, std::ios::binary);
        file << text;
        file.close();
        if (!file) std::cerr << (folder / name).string() << ": cannot be written.\n";
        return bool(file);
    };
    const bool written = write("bracket.ply", scb::samples::ply_text(scb::samples::bracket())) &&
                         write("pin.obj", scb::samples::obj_text(scb::samples::pin()));
    return written ? 0 : 3;
}

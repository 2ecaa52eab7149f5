// scb_record_bug NAME FILE.scbrec: records the small engine with the error of that name.
#include <cstdio>

#include "tests/recordings/bugs.h"

int main(int argc, char** argv) {
    const std::vector<std::string> names = scb::all_bug_names();
    for (std::size_t i = 0; argc == 3 && i < names.size(); ++i)
        if (names[i] == argv[1]) {
            scb::record_bug(static_cast<int>(i), argv[2]);
            return 0;
        }
    std::fprintf(stderr, "Usage: scb_record_bug NAME FILE.scbrec, with NAME one of");
    for (const std::string& name : names) std::fprintf(stderr, " %s", name.c_str());
    std::fprintf(stderr, "\n");
    return 2;
}

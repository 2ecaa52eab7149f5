// scb_record_bug NAME FILE.scbrec: records the small engine with the error of that name.
#include <cstdio>
#include <cstring>

#include "tests/recordings/small_engine.h"

int main(int argc, char** argv) {
    for (int i = 0; argc == 3 && i < scb::bug_count; ++i)
        if (std::strcmp(argv[1], scb::bug_names[i]) == 0) {
            scb::record_small_engine(static_cast<scb::Bug>(i), argv[2]);
            return 0;
        }
    std::fprintf(stderr, "Usage: scb_record_bug NAME FILE.scbrec, with NAME one of");
    for (const char* name : scb::bug_names) std::fprintf(stderr, " %s", name);
    std::fprintf(stderr, "\n");
    return 2;
}

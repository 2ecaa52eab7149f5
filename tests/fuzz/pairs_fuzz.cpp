#include "scenes/scene/raw_pairs.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

SCB_FUZZ(input) {
    try {
        scenes::parse_raw_pairs(std::string(input.begin(), input.end()), "input");
    } catch (const InputError& error) {
        fuzz::require_sentence(error, "input");
    }
}

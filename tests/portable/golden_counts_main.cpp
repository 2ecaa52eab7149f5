#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>

#include "tests/portable/golden_counts.h"

// golden_counts: prints the counts. golden_counts FILE: compares them with the file's; status 1
// where they differ.
int main(int argc, char** argv) try {
    const std::string found = scb::golden_counts();
    if (argc < 2) {
        std::cout << found;
        return 0;
    }
    std::ifstream file(argv[1]);
    std::ostringstream expected;
    expected << file.rdbuf();
    const std::string difference = scb::first_difference(expected.str(), found);
    if (difference.empty()) return 0;
    std::cerr << "The counts differ, first in " << difference;
    return 1;
} catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
}

#pragma once

#include <string>
#include <vector>

#include "app/cli/console.h"
#include "app/pictures/picture_options.h"
#include "app/query/distance_options.h"
#include "app/query/layout_options.h"
#include "app/query/query_options.h"
#include "app/study/bench_run.h"

namespace scb::app {

/// Options of `scb bench`.
struct BenchCommandOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy{.volumes = "scb,ball,ritter,obb"};
    QueryOptions query;
    KindOptions kind;
    PictureOptions picture{.output = ""};
    std::string splits{split_method_name(SplitMethod::section_3)};
    std::string layouts = "reference", simd = "best";
    int leaf_triangles = most_leaf_triangles, threads = 1;
    int repeats = 3;
    bool warm = false, coherent = false, measures = false, first = false, json = false;
};

/// The hierarchies and tests to measure. Throws InputError if options exclude each other.
std::vector<BenchSubject> subjects(const BenchCommandOptions& options);
bool any_packed(const std::vector<BenchSubject>& subjects);

/// The vector instructions of packed layouts: as an option, and by the name of the level that the
/// option stands for on this machine.
SimdLevel simd_level(const BenchCommandOptions& options);
std::string simd_text(SimdLevel level);

/// Notes options without effect on the measurement, and other surprising options.
void note_surprises(const BenchCommandOptions& options, const std::vector<BenchSubject>& subjects,
                    const Console& console);

/// Sentences on how the times were measured.
std::string conditions(const BenchCommandOptions& options, const BenchOptions& bench);

void add_bench_options(const Command& command, BenchCommandOptions& options);

}  // namespace scb::app

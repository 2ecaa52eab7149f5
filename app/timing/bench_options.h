#pragma once

#include <string>
#include <vector>

#include "app/pictures/picture_options.h"
#include "app/query/layout_options.h"
#include "app/query/query_options.h"
#include "app/timing/bench_run.h"

namespace scb::app {

/// What `scb bench` understands.
struct BenchCommandOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy{.volumes = "scb,ball,ritter,obb"};
    QueryOptions query;
    PictureOptions picture{.output = ""};
    std::string splits{split_method_name(SplitMethod::section_3)};
    std::string layouts = "reference", simd = "best";
    int leaf_triangles = most_leaf_triangles, threads = 1;
    int repeats = 3;
    bool warm = false, coherent = false, measures = false, json = false;
};

/// The hierarchies and tests asked for. Throws InputError where options do not go together.
std::vector<BenchSubject> subjects(const BenchCommandOptions& options);
bool any_packed(const std::vector<BenchSubject>& subjects);

/// The vector instructions of packed layouts: as an option, and by the name of what it stands for
/// here.
SimdLevel simd_level(const BenchCommandOptions& options);
std::string simd_text(SimdLevel level);

/// Notes which options have no effect on what is measured, and what else may surprise.
void note_surprises(const BenchCommandOptions& options, const std::vector<BenchSubject>& subjects,
                    const Console& console);

/// How the times came about, in sentences.
std::string conditions(const BenchCommandOptions& options, const BenchOptions& bench);

void add_bench_options(const Command& command, BenchCommandOptions& options);

}  // namespace scb::app

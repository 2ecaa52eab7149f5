// sample_report FOLDER: writes the pictures and the report of a made-up run, with a case of every
// verdict, into a folder. The browser test reads it; people may.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/platform/output_file.h"
#include "golden/report/html_report.h"
#include "render/files/image_file.h"

namespace scb {
namespace {

namespace fs = std::filesystem;

/// A row of discs, each with its id.
struct Discs {
    int width = 320, height = 240;
    int missing = 0;  ///< this one is not drawn
    double nudge = 0;
    int tint = 0;  ///< is added to the red of disc 5
};

constexpr int columns = 8, rows = 6;

render::IdImage ids_of(const Discs& discs) {
    render::IdImage image{discs.width, discs.height, {}};
    for (int y = 0; y < discs.height; ++y)
        for (int x = 0; x < discs.width; ++x) {
            const int column = x * columns / discs.width, row = y * rows / discs.height;
            const int id = 1 + row * columns + column;
            const double cx = (column + 0.5) * discs.width / columns,
                         cy = (row + 0.5) * discs.height / rows;
            const double radius = 0.46 * discs.height / rows + (id == 21 ? discs.nudge : 0);
            const bool inside = std::hypot(x + 0.5 - cx, y + 0.5 - cy) < radius;
            image.ids.push_back(inside && id != discs.missing ? static_cast<std::uint32_t>(id) : 0);
        }
    return image;
}

render::Image picture_of(const Discs& discs) {
    const render::IdImage ids = ids_of(discs);
    render::Image image{ids.width, ids.height, std::vector<std::uint8_t>(4 * ids.ids.size())};
    for (int y = 0; y < ids.height; ++y)
        for (int x = 0; x < ids.width; ++x) {
            const std::uint32_t id = render::pixel(ids, x, y);
            render::Rgba8 color{255, 255, 255, 255};
            if (id != 0) {
                const int red = static_cast<int>(id % 8) * 30 + (id == 5 ? discs.tint : 0);
                color = {static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(90 + id * 2),
                         static_cast<std::uint8_t>(id % 2 == 0 ? 178 : 60), 255};
            }
            render::set_pixel(image, x, y, color);
        }
    return image;
}

/// What the comparison would find, kept apart from it so that this page needs nothing else.
golden::ImageDifference colors_between(const render::Image& a, const render::Image& b) {
    golden::ImageDifference difference;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const render::Rgba8 p = render::pixel(a, x, y), q = render::pixel(b, x, y);
            const int most = std::max({std::abs(p.r - q.r), std::abs(p.g - q.g),
                                       std::abs(p.b - q.b), std::abs(p.a - q.a)});
            if (most == 0) continue;
            ++difference.pixels;
            difference.box.add(x, y);
            difference.largest = std::max(difference.largest, most);
            for (int d = 0; d < most; ++d) ++difference.beyond[static_cast<std::size_t>(d)];
        }
    return difference;
}

render::Image marked(const render::Image& a, const render::Image& b) {
    render::Image image = b;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const render::Rgba8 q = render::pixel(b, x, y);
            const auto pale = static_cast<std::uint8_t>(215 + (q.r + q.g + q.b) / 20);
            render::set_pixel(image, x, y,
                              q == render::pixel(a, x, y) ? render::Rgba8{pale, pale, pale, 255}
                                                          : render::Rgba8{213, 0, 70, 255});
        }
    return image;
}

golden::IdDifference owners_between(const render::IdImage& a, const render::IdImage& b) {
    golden::IdDifference difference;
    for (std::uint32_t id = 1; id <= columns * rows; ++id) {
        golden::IdChange change{id, 0, 0, 0, {}};
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x) {
                const bool before = render::pixel(a, x, y) == id,
                           after = render::pixel(b, x, y) == id;
                change.before += before;
                change.after += after;
                if (before == after) continue;
                ++change.moved;
                change.box.add(x, y);
                ++difference.pixels;
                difference.box.add(x, y);
            }
        if (change.moved > 0) difference.changes.push_back(change);
    }
    return difference;
}

class Sample {
  public:
    explicit Sample(fs::path folder) : folder_(std::move(folder)) {
        result.suite = "golden/cases.json";
        result.shard = "1/2";
        result.environment = {{"scb", "0.1.0"},
                              {"renderer", "osmesa, OpenGL 4.5, llvmpipe"},
                              {"Mesa", "22.3.6"},
                              {"LLVM", "15.0.6"},
                              {"<b>quoted</b>", "\"&'"}};
    }

    golden::CaseResult& add(const std::string& name, golden::Verdict verdict,
                            const std::string& message) {
        golden::CaseResult c;
        c.name = name;
        c.verdict = verdict;
        c.message = message;
        c.seconds = 0.41;
        c.variant = 1;
        if (golden::is_failure(verdict)) {
            c.reproduce = "scb golden check " + name + " --trace --report out/golden";
            c.update = "scb golden update " + name;
        }
        result.cases.push_back(c);
        return result.cases.back();
    }

    std::string write(const std::string& name, const render::Image& image) {
        return write(name, render::encode_png(image));
    }
    std::string write(const std::string& name, const render::IdImage& image) {
        return write(name, render::encode_png(image));
    }

    void compare(golden::CaseResult& c, const Discs& before, const Discs& after) {
        const render::Image a = picture_of(before), b = picture_of(after);
        c.picture = {write(c.name + ".baseline.png", a), write(c.name + ".png", b), ""};
        if (a.width != b.width || a.height != b.height) return;
        c.picture.difference = write(c.name + ".difference.png", marked(a, b));
        c.colors = colors_between(a, b);
        c.focus = c.colors->box;
        const render::IdImage i = ids_of(before), j = ids_of(after);
        c.id_picture = {write(c.name + ".ids.baseline.png", i), write(c.name + ".ids.png", j), ""};
        if (golden::IdDifference ids = owners_between(i, j); ids.pixels > 0) c.ids = ids;
    }

    golden::SuiteResult result;

  private:
    std::string write(const std::string& name, const std::vector<std::uint8_t>& bytes) {
        fs::create_directories(folder_ / "pictures");
        write_file_whole(folder_ / "pictures" / name, bytes);
        return "pictures/" + name;
    }

    fs::path folder_;
};

// In another order than the page's.
golden::SuiteResult sample(const fs::path& folder) {
    Sample s(folder);
    for (int i = 0; i < 12; ++i)
        s.add("collide-scene-" + std::to_string(i + 1), golden::Verdict::same, "").variant =
            i == 3 ? 2 : 1;
    {
        golden::CaseResult& c = s.result.cases[5];
        c.colors.emplace();
        c.colors->pixels = 12;
        c.colors->largest = 2;
    }
    s.add("casting-levels", golden::Verdict::skipped,
          "The mesh TR12J_OCC.stl is not here; install the package occt-misc.");
    s.add("broken-scene", golden::Verdict::could_not_run,
          "The baseline golden/baselines/broken-scene.png cannot be read: it ends after 412 bytes.")
        .update = "";
    {
        golden::CaseResult& c =
            s.add("spheres-fresh", golden::Verdict::missing_baseline,
                  "There is no baseline. Look at the picture, and accept it if it is "
                  "right.");
        c.picture.candidate = s.write("fresh.png", picture_of({}));
        c.id_picture.candidate = s.write("fresh.ids.png", ids_of({}));
        c.variant = 0;
    }
    {
        golden::CaseResult& c = s.add("spheres-scb-pairs", golden::Verdict::different,
                                      "These differ: 49 counts; the owners of 1,080 pixels.");
        c.cause = "Body B moved: 0.02 along x, 1.5 degrees.";
        c.lines = {"11 pairs only in the baseline, 0 pairs only in the new run.",
                   "They part first at frame 100, test 3, where the baseline tested the nodes (21, "
                   "97) at depths (3, 4): rejected at cylinder-slab, the new run tested the nodes "
                   "(21, 97) at depths (3, 4): rejected at ball-slab.",
                   "Node 12 of A, level 7 (id 13) is missing: 1,060 pixels."};
        c.trace_difference =
            "1 frame in both, 1 differs (frame 100)\n\nCounts of the frame in both:\n"
            "                     baseline      new run new run - baseline\n"
            "pairs                     581          570                -11\n"
            "N_v                     24680        24697                +17\n"
            "N_p                       912          909                 -3\n\n"
            "11 pairs only in the baseline, 0 pairs only in the new run; 5 of them:\n"
            "  frame 100, the triangles (17, 4): the new run left them out at test 2287, the nodes "
            "(20475, 3792) at depths (12, 11): rejected at ball-slab\n\n"
            "They part first at frame 100, test 3, where\n"
            "  the baseline tested the nodes (21, 97) at depths (3, 4): rejected at "
            "cylinder-slab,\n"
            "  the new run tested the nodes (21, 97) at depths (3, 4): rejected at ball-slab.\n";
        const auto count = [&](const char* place, std::int64_t before, std::int64_t after) {
            c.counts.push_back({place, before, after});
        };
        count("frames/100/n_v", 24680, 24697);
        count("frames/100/n_p", 912, 909);
        count("frames/100/stages/ball-slab", 4012, 4031);
        count("frames/100/stages/cylinder-slab", 1024, 1007);
        c.counts.push_back({"frames/100/stages/slab-ball-corrected", std::nullopt, 3});
        c.counts.push_back({"bodies/A/volumes", 128, std::nullopt});
        c.counts.push_back({"bodies/A/name", std::nullopt, std::nullopt, "\"A\"", "\"<A>\""});
        c.counts.push_back({"bodies/A/depth", std::nullopt, 14, "14.0", ""});
        for (int depth = 0; depth < 40; ++depth)
            count(("frames/100/depths/" + std::to_string(depth)).c_str(), 100 * depth,
                  100 * depth + (depth % 2 == 0 ? 7 : -3));
        count("limits/smallest", std::numeric_limits<std::int64_t>::min(),
              std::numeric_limits<std::int64_t>::max());
        Discs after;
        after.missing = 13;
        after.nudge = -3;
        s.compare(c, {}, after);
        for (const golden::IdChange& change : c.ids->changes)
            c.owners.push_back("node " + std::to_string(change.id - 1) + " of A, level 7");
        for (int depth = 20; depth < 24; ++depth)
            count(("frames/100/n_v at depth/" + std::to_string(depth)).c_str(), 100, 100 + depth);
        c.traces = {"spheres-scb-pairs.baseline.scbrec", "spheres-scb-pairs.new.scbrec"};
        c.diff =
            "scb diff out/golden/spheres-scb-pairs.baseline.scbrec "
            "out/golden/spheres-scb-pairs.new.scbrec";
    }
    {
        golden::CaseResult& c =
            s.add("one-pixel", golden::Verdict::different, "1 pixel differs, by 1.");
        const render::Image before = picture_of({});
        render::Image after = before;
        render::Rgba8 color = render::pixel(after, 143, 77);
        ++color.g;
        render::set_pixel(after, 143, 77, color);
        c.picture = {s.write("one.baseline.png", before), s.write("one.png", after),
                     s.write("one.difference.png", marked(before, after))};
        c.colors = colors_between(before, after);
        c.focus = c.colors->box;
    }
    {
        golden::CaseResult& c =
            s.add("tinted", golden::Verdict::different, "Colors differ by more than allowed.");
        Discs after;
        after.tint = 40;
        s.compare(c, {}, after);
        c.tolerance = {2, 16};
        c.id_picture = {};
        c.variant = 2;
    }
    {
        golden::CaseResult& c = s.add("thin-cylinder-counts", golden::Verdict::different,
                                      "2 counts differ; no pictures.");
        c.counts = {{"frames/0/pairs", 17, 18}, {"frames/0/n_v", 1203, 1100}};
    }
    {
        golden::CaseResult& c = s.add("cone-wide", golden::Verdict::size_differs,
                                      "The new picture is 360 x 240; the baseline is 320 x 240.");
        Discs after;
        after.width = 360;
        s.compare(c, {}, after);
    }
    {
        golden::CaseResult& c =
            s.add("knots-extra", golden::Verdict::new_output,
                  "It makes knots-extra.ids.png, which the baseline does not have.");
        c.id_picture.candidate = s.write("extra.ids.png", ids_of({}));
        c.picture.candidate = "pictures/not-there.png";
    }
    {
        golden::CaseResult& c =
            s.add("<script>alert('x')</script> & \"more\"", golden::Verdict::different,
                  "The name <i>is</i> {{hostile}}, and its command is quoted.");
        c.lines = {"</script><img src=x onerror=alert(1)>"};
        c.counts = {{"<b>place</b>/\"n\"", 1, 2}};
        c.reproduce =
            "scb golden check --suite my/cases.json '<script>alert('\\''x'\\'')</script> & "
            "\"more\"'";
        c.update =
            "scb golden update --suite my/cases.json '<script>alert('\\''x'\\'')</script> & "
            "\"more\"'";
    }
    return s.result;
}

}  // namespace
}  // namespace scb

int main(int count, char** arguments) {
    if (count != 2) {
        std::fprintf(stderr, "usage: sample_report FOLDER\n");
        return 2;
    }
    const std::filesystem::path folder = arguments[1];
    std::filesystem::create_directories(folder);
    const scb::golden::SuiteResult failing = scb::sample(folder);
    scb::write_file_whole(folder / "report.html", scb::golden::report_html(failing, folder));
    scb::golden::SuiteResult passing = failing;
    std::erase_if(passing.cases, [](const scb::golden::CaseResult& c) {
        return scb::golden::is_failure(c.verdict);
    });
    scb::write_file_whole(folder / "passing.html", scb::golden::report_html(passing, folder));
    passing.incomplete = "These shards are missing: 2/2.";
    scb::write_file_whole(folder / "incomplete.html", scb::golden::report_html(passing, folder));
    scb::write_file_whole(folder / "empty.html", scb::golden::report_html({}, folder));
}

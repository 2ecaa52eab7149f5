#include "scb/fit.h"
#include "scb/volume.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

SCB_FUZZ(input) {
    fuzz::Numbers numbers(input);
    FitOptions options;
    options.growth = numbers.below(2) == 0 ? BallGrowth::radius : BallGrowth::ritter;
    options.ball_method = numbers.below(2) == 0 ? BallMethod::minimum : BallMethod::ritter;
    options.margin = numbers.below(3) / 8.0;
    const double scale = std::ldexp(1.0, static_cast<int>(numbers.below(61)) - 30);
    std::vector<Vec3> points;
    while (!numbers.empty() && points.size() < 200) points.push_back(scale * numbers.point());
    if (points.empty()) return;
    const auto check = [&](const auto& volume) {
        fuzz::require(is_well_formed(volume), "volumes are well formed");
        for (const Vec3& point : points)
            fuzz::require(contains(volume, point), "a volume contains its points");
    };
    check(fit_scb(points, options));
    check(fit_ball(points, options));
    check(fit_obb(points, options));
}

#include "app/study/tune_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "app/study/tune_subject.h"
#include "core/base/statistics.h"
#include "core/platform/clock.h"
#include "scb/error.h"

namespace scb::app {
namespace {

/// Trials take this many frames: more if the base's queries then take less than `usual_trial_ms`
/// milliseconds, and fewer if they take more than `most_trial_ms`.
constexpr double usual_trial_frames = 8, usual_trial_ms = 60, most_trial_ms = 500;
/// A trial ends once it took this many times the least of the trials before it. If it then took as
/// many times as `hopeless_at`, other orders are not tried.
constexpr double given_up_at = 2, hopeless_at = 8;
/// Settings that are timed, with layouts and without, took at most this many times the least.
constexpr double timed_up_to = 1.5;
constexpr std::size_t most_timed_of_each = 6;
/// Of all timed queries.
constexpr double most_timed_ms = 10'000;

/// Indices of evenly spread frames, at most `most`.
std::vector<std::size_t> spread(std::size_t frames, double most) {
    const auto step = static_cast<std::size_t>(std::ceil(
        static_cast<double>(frames) / std::clamp(most, 1.0, static_cast<double>(frames))));
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < frames; i += step) places.push_back(i);
    return places;
}

/// The built hierarchies of several settings; settings share them.
class BuiltSettings {
  public:
    explicit BuiltSettings(TuneSubject& subject) : subject_(subject) {}

    void add(const DistanceSetting& setting) {
        const std::size_t k = place_of(setting.hierarchy);
        if (setting.layout) packed_.push_back(subject_.pack(built_[k], *setting.layout));
        places_.push_back({setting.layout.has_value(), setting.layout ? packed_.size() - 1 : k});
    }

    /// Calls `call` with the hierarchies of the s-th setting, packed or not.
    template <class Call>
    auto with(std::size_t s, const Call& call) const {
        return places_[s].is_packed ? call(packed_[places_[s].at]) : call(built_[places_[s].at]);
    }

  private:
    struct Place {
        bool is_packed;
        std::size_t at;
    };

    std::size_t place_of(const TuneSetting& setting) {
        std::size_t k = 0;
        while (k < built_.size() && !same_hierarchies(built_[k].setting, setting)) ++k;
        if (k == built_.size()) built_.push_back(subject_.build(setting));
        return k;
    }

    TuneSubject& subject_;
    std::vector<BuiltSetting> built_;
    std::vector<BuiltLayout> packed_;
    std::vector<Place> places_;
};

class DistanceRun {
  public:
    DistanceRun(TuneSubject& subject, const DistanceTuneOptions& options,
                const TuneProgress& progress)
        : subject_(subject),
          options_(options),
          progress_(progress),
          base_{options.base, options.asked.limits.order} {}

    std::size_t tried = 0;
    std::string no_layouts;

    /// Tries every setting.
    bool try_all() {
        const std::vector<TuneSetting> hierarchies = tried_hierarchies();
        std::vector<PackedLayout> layouts = tried_layouts();
        progress_.begin("volumes and splits tried", hierarchies.size());
        for (const TuneSetting& hierarchy : hierarchies) {
            const BuiltSetting built = subject_.build(hierarchy);
            if (trials_.empty()) choose_frames(built);
            if (!try_orders(built, {hierarchy})) return false;
            if (can_pack(hierarchy.volume) && !try_layouts(built, layouts)) return false;
            if (!progress_.step()) return false;
        }
        return true;
    }

    /// Times the base and the quickest settings; `frames` are set to indices.
    std::optional<std::vector<TimedSetting>> time(std::vector<std::size_t>& frames) {
        const std::vector<Trial> timed = timed_trials();
        double ms = 0;
        for (const Trial& trial : timed) ms += trial.ms;
        // Each timed query follows an untimed one.
        frames = spread(subject_.frames(), most_timed_ms / (2 * options_.repeats * ms));
        BuiltSettings built(subject_);
        std::vector<TimedSetting> rows;
        for (const Trial& trial : timed) {
            built.add(trial.setting);
            TimedSetting& row = rows.emplace_back();
            row.setting = trial.setting;
            built.with(rows.size() - 1, [&](const auto& of) {
                row.bytes_per_triangle = subject_.bytes_per_triangle(of);
                row.build_ms = of.ms;
            });
        }
        QueryTiming timing;
        timing.subjects = rows.size();
        timing.frames = frames.size();
        timing.before = [&](std::size_t s, std::size_t i) {
            built.with(s, [&](const auto& of) {
                subject_.prepare(of, asked_with(rows[s].setting), frames[i]);
            });
        };
        timing.query = [&](std::size_t s, std::size_t i) {
            return built.with(s, [&](const auto& of) {
                return subject_.query(of, asked_with(rows[s].setting), frames[i]);
            });
        };
        timing.keep = [&](std::size_t s, std::size_t, const QueryAnswer& answer) {
            rows[s].n_v += answer.found.n_v;
            rows[s].n_p += answer.found.n_p;
        };
        timing.step = progress_.step;
        progress_.begin("settings timed",
                        rows.size() * frames.size() * static_cast<std::size_t>(options_.repeats));
        std::vector<std::vector<double>> runs(rows.size());
        for (int repeat = 0; repeat < options_.repeats; ++repeat) {
            const auto of_run = time_queries(timing);
            if (!of_run) return std::nullopt;
            timing.keep = nullptr;
            for (std::size_t s = 0; s < runs.size(); ++s) runs[s].push_back(mean((*of_run)[s]));
        }
        for (std::size_t s = 0; s < runs.size(); ++s)
            rows[s].ms = time_interval(std::move(runs[s]));
        std::stable_sort(rows.begin() + 1, rows.end(),
                         [](const auto& x, const auto& y) { return x.ms.median < y.ms.median; });
        return rows;
    }

  private:
    struct Trial {
        DistanceSetting setting;
        double ms = 0;  ///< of a query, the mean over the trial frames
    };

    /// Every volume with every split; the base's first.
    std::vector<TuneSetting> tried_hierarchies() const {
        std::vector<TuneSetting> hierarchies = {options_.base};
        for (const SplitMethod split : {SplitMethod::cost, SplitMethod::section_3})
            for (const VolumeKind volume : all_volume_kinds()) {
                TuneSetting setting = options_.base;
                setting.volume = volume;
                setting.split = split;
                if (!same_hierarchies(setting, options_.base)) hierarchies.push_back(setting);
            }
        return hierarchies;
    }

    bool has_base_hierarchy(const DistanceSetting& setting) const {
        return !setting.layout && setting.hierarchy == base_.hierarchy;
    }
    bool is_base(const DistanceSetting& setting) const {
        return has_base_hierarchy(setting) && setting.order == base_.order;
    }

    DistanceQuery asked_with(const DistanceSetting& setting) const {
        DistanceQuery asked = options_.asked;
        asked.limits.order = setting.order;
        return asked;
    }

    /// Chooses the trial frames by the time of the base's queries.
    void choose_frames(const BuiltSetting& base) {
        trial_frames_ = spread(subject_.frames(), usual_trial_frames);
        double ms = 0;
        std::size_t timed = 0;
        while (timed < trial_frames_.size() && ms < most_trial_ms && !progress_.ends())
            ms += query_ms(base, asked_with(base_), trial_frames_[timed++]);
        const auto count = static_cast<double>(timed);
        trial_frames_ = spread(
            subject_.frames(),
            timed < trial_frames_.size() ? count : std::max(count, count * usual_trial_ms / ms));
    }

    template <class Built>
    double query_ms(const Built& built, const DistanceQuery& asked, std::size_t frame) const {
        const double start = milliseconds(Clock::thread);
        subject_.query(built, asked, frame);
        return milliseconds(Clock::thread) - start;
    }

    bool try_layouts(const BuiltSetting& built, const std::vector<PackedLayout>& layouts) {
        if (!no_layouts.empty()) return true;
        for (const PackedLayout& layout : layouts) {
            try {
                if (!try_orders(subject_.pack(built, layout), {built.setting, base_.order, layout}))
                    return false;
            } catch (const InputError& error) {
                no_layouts = std::string("No packed layout was tried: ") + error.what();
                return true;
            }
        }
        return true;
    }

    /// Tries the setting in each order, or as it is if queries have none.
    template <class Built>
    bool try_orders(const Built& built, DistanceSetting setting) {
        constexpr std::array orders = {DistanceOrder::hybrid, DistanceOrder::nearest,
                                       DistanceOrder::depth_first};
        const std::span<const DistanceOrder> none(&base_.order, 1);
        const double& least = least_[setting.layout.has_value()];
        for (const DistanceOrder order : options_.asked.within ? none : std::span(orders)) {
            setting.order = order;
            const double ms = try_setting(built, setting);
            if (progress_.ends()) return false;
            if (!has_base_hierarchy(setting) && ms > hopeless_at * least) break;
        }
        // Orders of a setting that was given up count, so that the number is the same in each run.
        tried += options_.asked.within ? 1 : orders.size();
        return true;
    }

    /// The time of the trial, in milliseconds; it may have ended early.
    template <class Built>
    double try_setting(const Built& built, const DistanceSetting& setting) {
        double& least = least_[setting.layout.has_value()];
        double ms = 0;
        for (const std::size_t frame : trial_frames_) {
            ms += query_ms(built, asked_with(setting), frame);
            if (progress_.ends() || (!is_base(setting) && ms > given_up_at * least)) return ms;
        }
        least = std::min(least, ms);
        trials_.push_back({setting, ms / static_cast<double>(trial_frames_.size())});
        return ms;
    }

    /// The base, then the quickest with layouts and without.
    std::vector<Trial> timed_trials() const {
        std::vector<Trial> sorted = trials_, timed;
        std::stable_sort(sorted.begin(), sorted.end(),
                         [&](const Trial& x, const Trial& y) { return x.ms < y.ms; });
        const auto base = std::find_if(sorted.begin(), sorted.end(),
                                       [&](const Trial& trial) { return is_base(trial.setting); });
        timed.push_back(*base);
        sorted.erase(base);
        for (const bool is_packed : {true, false}) {
            std::size_t count = 0;
            double least = HUGE_VAL;
            for (const Trial& trial : sorted) {
                if (trial.setting.layout.has_value() != is_packed) continue;
                least = std::min(least, trial.ms);
                if (trial.ms > timed_up_to * least || ++count > most_timed_of_each) break;
                timed.push_back(trial);
            }
        }
        return timed;
    }

    TuneSubject& subject_;
    const DistanceTuneOptions& options_;
    const TuneProgress& progress_;
    DistanceSetting base_;
    std::vector<std::size_t> trial_frames_;
    std::vector<Trial> trials_;
    std::array<double, 2> least_{HUGE_VAL, HUGE_VAL};  // of all trial frames, unpacked and packed
};

}  // namespace

std::size_t DistanceTuning::best() const {
    for (std::size_t r = 1; r < rows.size(); ++r)
        if (rows[r].ms.high < base().ms.low) return r;
    return 0;
}

std::size_t DistanceTuning::best_unpacked() const {
    for (std::size_t r = 1; r < rows.size(); ++r)
        if (!rows[r].setting.layout && rows[r].ms.high < base().ms.low) return r;
    return 0;
}

std::optional<DistanceTuning> tune_distance(const scenes::Scene& scene, std::size_t a,
                                            std::size_t b, const std::vector<int>& frames,
                                            const DistanceTuneOptions& options,
                                            const TuneProgress& progress) {
    TuneSubject subject(scene, a, b, frames, options.build);
    DistanceRun run(subject, options, progress);
    if (!run.try_all()) return std::nullopt;
    std::vector<std::size_t> places;
    auto rows = run.time(places);
    if (!rows) return std::nullopt;
    DistanceTuning result;
    result.scene = scene.name;
    for (const std::size_t body : {a, b}) {
        result.bodies.push_back(scene.bodies[body].name);
        result.triangles.push_back(scene.meshes[scene.bodies[body].mesh].mesh.triangles.size());
    }
    for (const std::size_t i : places) result.frames.push_back(frames[i]);
    result.build = options.build;
    result.build.fit.growth = FitOptions{}.growth;
    result.build.split = BuildOptions{}.split;
    result.asked = options.asked;
    result.tried = run.tried;
    result.no_layouts = run.no_layouts;
    result.rows = std::move(*rows);
    result.runs = options.repeats;
    return result;
}

}  // namespace scb::app

#include "app/timing/tune_progress.h"

#include <memory>
#include <optional>
#include <string>

#include "app/cli/progress.h"

namespace scb::app {

TuneProgress tune_progress(const Console& console, const InterruptWatch& watch) {
    struct Part {
        std::optional<Progress> progress;
        std::string what;
    };
    const auto part = std::make_shared<Part>();
    return {[part, &console](std::string_view what, std::size_t steps) {
                part->what = what;
                part->progress.emplace(console, steps);
            },
            [part, &watch] {
                part->progress->step(part->what);
                return watch.signal() == 0;
            },
            [&watch] { return watch.signal() != 0; }};
}

}  // namespace scb::app

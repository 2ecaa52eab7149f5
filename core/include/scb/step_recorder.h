#pragma once

#include "scb/observer.h"

namespace scb {

/// An observer for `collide` that keeps all steps of one query.
struct StepRecorder {
    /// The steps so far.
    Steps steps;

    /// Keeps a test of two volumes.
    void volume_test(const Step& step) { steps.volumes.push_back(step); }
    /// Keeps a test of two triangles.
    void item_test(const ItemStep& items) { steps.items.push_back(items); }
};

}  // namespace scb

#include "app/python/binding/signals.h"

namespace scb::python {

bool SignalWatch::stopped() {
    if (stopped_) return true;
    if (std::this_thread::get_id() != first_) return false;
    const Clock::time_point now = Clock::now();
    if (now - looked_ < std::chrono::milliseconds(100)) return false;
    looked_ = now;
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) stopped_ = true;
    return stopped_;
}

void SignalWatch::rethrow() {
    if (!stopped_) return;
    const py::gil_scoped_acquire locked;
    throw py::error_already_set();
}

}  // namespace scb::python

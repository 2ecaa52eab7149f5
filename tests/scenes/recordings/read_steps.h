#pragma once

#include "scb/error.h"
#include "scenes/recordings/recorded_queries.h"
#include "tests/scenes/recordings/sample_records.h"

namespace scb::scenes {

/// A recording that is read step by step.
struct ReadSteps {
    RecordingFile file;
    RecordedQueries queries;

    explicit ReadSteps(const std::vector<Record>& records)
        : file(recording_of(records), "x.scbrec"), queries(file) {}
    ReadSteps(const ReadSteps&) = delete;

    /// Up to the end of this query, from 0.
    const EngineQuery& query(int number) {
        for (int count = -1; count < number;) {
            const RecordedQueries::Ended ended = queries.next();
            if (ended == RecordedQueries::Ended::end) throw InputError("there is no such query");
            count += ended == RecordedQueries::Ended::query;
        }
        return queries.query();
    }
    void read_all() {
        while (queries.next() != RecordedQueries::Ended::end) {
        }
    }
};

}  // namespace scb::scenes

#pragma once

#include <functional>
#include <span>

#include "scenes/recordings/recording_file.h"

namespace scb::scenes {

/// Hands the records of several recordings to `write` as those of one. The recordings are of the
/// threads of one program, which share its meshes, trees, bodies and their numbers.
///
/// First comes what stands before the first frames, then frame by frame, ascending, what each
/// recording says of it, in the order of `readers`. What several say alike is written once: meshes,
/// stages and bodies as long as they stay so; within a frame also trees, nodes, refits, poses and
/// settings. A query that a recording leaves open gets its end, as one that did not find all. There
/// is one end, where each of them has one. One recording alone is handed on as it is.
///
/// Throws InputError, one sentence that names the recording and the record, where two describe the
/// same mesh, stage, tree, node or body otherwise before the first frame or in one frame, where
/// frames do not ascend, and where a reader does.
void join_recordings(std::span<RecordingReader> readers,
                     const std::function<void(const Record&)>& write);

}  // namespace scb::scenes

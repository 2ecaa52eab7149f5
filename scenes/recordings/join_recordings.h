#pragma once

#include <functional>
#include <span>

#include "scenes/recordings/recording_file.h"

namespace scb::scenes {

/// Passes the records of several recordings to `write` as one recording. The recordings come from
/// the threads of one program, which share its meshes, trees, bodies and their numbers.
///
/// First come the records before the first frames. Then come the records of each frame, frames
/// ascending, recordings in the order of `readers`. Equal records of several recordings are written
/// once: meshes, stages and bodies until they change; within a frame also trees, nodes, refits,
/// objects, poses and settings. A query that a recording leaves open is ended as incomplete. One
/// end is written if each recording has one. A single recording is passed on unchanged.
///
/// Throws InputError, one sentence that names the recording and the record. The causes: two
/// recordings describe a mesh, stage, tree, node or body differently, before the first frame or in
/// one frame; frames do not ascend; a reader throws.
void join_recordings(std::span<RecordingReader> readers,
                     const std::function<void(const Record&)>& write);

}  // namespace scb::scenes

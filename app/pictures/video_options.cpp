#include "app/pictures/video_options.h"

#include "app/cli/command.h"
#include "app/cli/validators.h"
#include "app/query/output_guard.h"
#include "core/platform/output_file.h"
#include "render/files/video_file.h"
#include "scb/error.h"

namespace scb::app {

void VideoOptions::check(const std::string& folder) const {
    if (frames_per_second) {
        const std::string given = "--fps " + std::to_string(*frames_per_second);
        if (!wanted()) throw InputError(given + ": there is no video; give --video FILE.mp4 too.");
        if (*frames_per_second < 1 || *frames_per_second > 120)
            throw InputError(given + ": give 1 to 120 pictures a second.");
    }
    if (!wanted()) return;
    if (!file.ends_with(".mp4") && !render::is_webp_name(file))
        throw InputError("--video " + file + ": give a file that ends in .mp4 or .webp.");
    if (!render::is_webp_name(file) && !is_on_path(render::video_program))
        throw OutputError("--video " + file + ": there is no program " + render::video_program +
                          " on PATH; install the package " + render::video_program +
                          ", or give a file that ends in .webp.");
    check_output(file, "--video", folder);
}

void add_video_options(const Command& command, VideoOptions& options) {
    command
        .add_option("--video", options.file,
                    "Also write the pictures as a video: .mp4, H.264, which needs the program "
                    "ffmpeg, or .webp, an animation for browsers")
        .file({".mp4", ".webp"})
        .only_typed();
    command
        .add_option("--fps", options.frames_per_second,
                    "Pictures a second of the video, 1 to 120; default 25")
        .check(decimal_number)
        .type_name("N");
}

}  // namespace scb::app

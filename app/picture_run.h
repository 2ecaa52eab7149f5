#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/picture_options.h"
#include "render/encode_queue.h"
#include "render/overlay.h"
#include "render/renderer.h"

namespace scb {

/// The pictures of one run of a command: drawn one after the other, encoded and written beside the
/// drawing, and listed in index.json at the end. Load meshes first: some of their readers are tried
/// in a child process, which must not inherit a context or threads.
class PictureRun {
  public:
    /// Makes the folder and removes an index of other pictures from it. Throws InputError,
    /// OutputError, GlError.
    explicit PictureRun(const PictureOptions& options);

    Renderer& renderer() { return renderer_; }
    const Context& context() const { return context_; }
    Overlay& overlay() { return overlay_; }

    /// Draws the picture with overlay(), and hands it on to be written as NAME.png; with ids, and
    /// as NAME_ids.png, where that was asked for and `with_ids` says that it has some. `entry` is
    /// what the index says of it beside the file names.
    void draw(const std::string& name, const Picture& picture, nlohmann::ordered_json entry,
              bool with_ids = true);

    /// Notes a line that is printed before the file names.
    void say(std::string line) { said_ += std::move(line) + "\n"; }
    /// Has finish() print this and nothing else.
    void print_instead(std::string text) { instead_ = std::move(text); }
    /// The id of the thing that owns a pixel of the picture that was drawn last with ids.
    std::uint32_t id_at(int x, int y) const;

    /// Waits until everything is written; then writes index.json, which is `head` with `files` and
    /// the versions at its end, and prints it, or the names of all files, as was asked for.
    void finish(nlohmann::ordered_json head);

  private:
    const PictureOptions& options_;
    Context context_;
    Renderer renderer_;
    std::filesystem::path folder_;
    EncodeQueue queue_;
    Overlay overlay_;
    std::vector<std::string> written_;
    std::string said_;
    std::optional<std::string> instead_;
    IdImage last_ids_;  ///< kept where a pixel is to be picked
    nlohmann::ordered_json files_ = nlohmann::ordered_json::array();
};

}  // namespace scb

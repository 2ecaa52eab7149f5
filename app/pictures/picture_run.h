#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "app/pictures/folder_index.h"
#include "app/pictures/picture_options.h"
#include "app/pictures/sheet_run.h"
#include "app/shards/parts.h"
#include "render/draw/renderer.h"
#include "render/figures/scene_figure.h"
#include "render/files/animation.h"
#include "render/files/encode_queue.h"
#include "render/overlay/overlay_shape.h"

namespace scb::app {

/// The pictures of one run of a command: drawn one after the other, encoded and written in the
/// background, and listed in index.json at the end.
class PictureRun {
  public:
    /// Makes the folder. Removes the `tables`, which are written at the end: they would describe
    /// other pictures if this run did not finish. Throws InputError if index.json is not from scb,
    /// see FolderIndex. The pictures name `scene`, see picture_texts. All inputs must have been
    /// read before. Throws InputError, now or later, instead of removing or replacing an input.
    /// Also throws OutputError, GlError.
    PictureRun(const PictureOptions& options, const std::string& scene,
               const std::vector<std::string>& tables = {});

    render::Renderer& renderer() { return renderer_; }
    const render::Context& context() const { return context_; }
    render::Overlay& overlay() { return overlay_; }

    /// Sets the number of parts(), which shards of the run share, and the identity of the scene.
    /// Throws as Parts does.
    void plan(std::size_t parts, const Parts::Subject& subject);
    /// Whether this run makes only some parts: their pictures, but no summaries of all.
    bool is_shard() const { return parts_.are_of_shard(); }
    /// The next part. `draw` draws its pictures and returns a value for the end of the run; or
    /// nothing if it was interrupted, and then this returns false. If a shard has made the part,
    /// its pictures are taken over. `take` gets the value of `draw`, from here or from the shard,
    /// but is not called in a shard.
    using Drawn = std::optional<nlohmann::ordered_json>;
    bool part(const std::function<Drawn()>& draw,
              const std::function<void(const nlohmann::ordered_json&)>& take);

    /// Also makes a contact sheet of the sequence's pictures.
    void begin_sheet(SheetRun sheet) { sheet_ = std::move(sheet); }
    /// The meaning of the colors of the next picture, for the sheet, if there is one.
    void explain(const std::string& title, const std::vector<render::PanelItem>& panel);

    /// The same for a view of the scene. The sheet draws the view again in its own size, since text
    /// of a shrunk picture cannot be read.
    void explain(const render::SceneFigure& figure);

    /// Draws the picture with overlay(), and queues it to be written as NAME.png, where NAME is
    /// PictureOptions::picture_stem. A picture `of_sequence`, which is not a summary of the run, is
    /// also written with ids as NAME_ids.png, as a frame of the video and as a cell of the sheet,
    /// if asked for. `entry`: its entry in the index, without the file names.
    void draw(const std::string& usual_name, const render::Picture& picture,
              nlohmann::ordered_json entry, bool of_sequence = true);

    /// Writes a file beside the pictures.
    void write(const std::string& name, const std::string& text);

    /// Notes a line that is printed before the file names.
    void say(std::string line) { said_ += std::move(line) + "\n"; }
    /// finish() prints only this text.
    void print_instead(std::string text) { instead_ = std::move(text); }
    /// The id at a pixel of the latest picture with ids.
    std::uint32_t id_at(int x, int y) const;

    /// For a shard: waits until its pictures are written, keeps the other data that `scb merge`
    /// needs, and prints the names of all files.
    void finish_shard(const Console& console);

    /// Draws the sheet, and waits until everything is written, including the video. Then writes
    /// index.json of a folder, with `head`, `files` and the versions as the latest run. Prints that
    /// run, or the names of all files, and opens the result, as the options say.
    void finish(nlohmann::ordered_json head, const Console& console);

  private:
    void draw_sheet();
    void write_index(const nlohmann::ordered_json& head, const Console& console);
    /// Takes over a picture of a shard, from the folder of its pictures.
    void take_picture(const nlohmann::ordered_json& picture, const std::filesystem::path& from);
    /// A file of that picture.
    void take_file(const std::string& name, const std::filesystem::path& from);
    std::string written_list() const;
    /// `picture` must be the one that the overlay belongs to.
    void write_svg(const std::string& name, const render::Picture& picture);
    /// The pictures for --terminal.
    std::vector<std::filesystem::path> to_show() const;
    /// The page, the video, the sheet, the only picture, or the folder: the first that exists.
    std::filesystem::path to_open(bool with_video) const;
    /// The path of a file of that name; throws if it must not be written.
    std::filesystem::path place(const std::string& name) const;
    /// The same for a picture, and removes it from the index until the end.
    std::filesystem::path place_picture(const std::string& name);

    const PictureOptions& options_;
    render::Context context_;
    render::Renderer renderer_;
    std::filesystem::path folder_;
    std::optional<FolderIndex> index_;  ///< of a folder
    render::EncodeQueue queue_;
    std::unique_ptr<render::Animation> video_;  ///< or null
    std::optional<SheetRun> sheet_;
    render::OverlayShapes shapes_;  ///< of the overlay, if SVG is asked for
    render::Overlay overlay_;
    std::vector<std::string> written_;
    std::string said_;
    std::optional<std::string> instead_;
    std::optional<render::Image> sheet_view_;  ///< of the next picture
    render::IdImage last_ids_;                 ///< kept if a pixel is to be picked
    nlohmann::ordered_json files_ = nlohmann::ordered_json::array();
    Parts parts_;
    std::size_t next_part_ = 0;
    nlohmann::ordered_json pictures_ = nlohmann::ordered_json::array();  ///< of a shard's part
    std::vector<std::string> cells_;  ///< files with a shard's views for the sheet
};

}  // namespace scb::app

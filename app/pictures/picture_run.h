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

/// The pictures of one run of a command: drawn one after the other, encoded and written beside the
/// drawing, and listed in index.json at the end.
class PictureRun {
  public:
    /// Makes the folder and removes from it what would describe other pictures should this run not
    /// finish: the `tables` that are written at the end. Throws InputError where its index.json is
    /// not one of scb's, see FolderIndex. The pictures say that they
    /// are of `scene`, see picture_texts. By then all must have been
    /// read. Nothing that was read is removed or replaced, now or later: that throws InputError.
    /// Also OutputError, GlError.
    PictureRun(const PictureOptions& options, const std::string& scene,
               const std::vector<std::string>& tables = {});

    render::Renderer& renderer() { return renderer_; }
    const render::Context& context() const { return context_; }
    render::Overlay& overlay() { return overlay_; }

    /// Says how many parts() there will be, which shards of the run share, and what tells the scene
    /// from others. Throws as Parts does.
    void plan(std::size_t parts, const Parts::Subject& subject);
    /// Whether this run makes only some parts: their pictures and nothing that is of all of them.
    bool is_shard() const { return parts_.are_of_shard(); }
    /// The next part. `draw` draws its pictures and returns what the run needs of it in the end, or
    /// nothing where it was interrupted: then this returns false. Where a shard has made the part,
    /// its pictures are taken over. `take` gets what `draw` returned, here or there, but not in a
    /// shard.
    using Drawn = std::optional<nlohmann::ordered_json>;
    bool part(const std::function<Drawn()>& draw,
              const std::function<void(const nlohmann::ordered_json&)>& take);

    /// Makes a contact sheet of the sequence's pictures too.
    void begin_sheet(SheetRun sheet) { sheet_ = std::move(sheet); }
    /// What the colors of the picture that comes next mean, for the sheet, if there is one.
    void explain(const std::string& title, const std::vector<render::PanelItem>& panel);

    /// The same of a view of the scene, which the sheet draws anew in its own size: text of a
    /// picture that is shrunk cannot be read.
    void explain(const render::SceneFigure& figure);

    /// Draws the picture with overlay(), and hands it on to be written as NAME.png; and, where it
    /// is `of_sequence` and not a summary of the run, with ids, as NAME_ids.png, as a frame of the
    /// video and as a cell of the sheet, each where that was asked for. `entry` is what the index
    /// says of it beside the file names.
    void draw(const std::string& name, const render::Picture& picture, nlohmann::ordered_json entry,
              bool of_sequence = true);

    /// Writes a file beside the pictures.
    void write(const std::string& name, const std::string& text);

    /// Notes a line that is printed before the file names.
    void say(std::string line) { said_ += std::move(line) + "\n"; }
    /// Has finish() print this and nothing else.
    void print_instead(std::string text) { instead_ = std::move(text); }
    /// The id of the thing that owns a pixel of the picture that was drawn last with ids.
    std::uint32_t id_at(int x, int y) const;

    /// Of a shard: waits until its pictures are written, keeps what else `scb merge` needs of them,
    /// and prints the names of all files.
    void finish_shard(const Console& console);

    /// Draws the sheet, and waits until everything is written, the video too; then writes
    /// index.json, in which `head` with `files` and the versions at its end is the latest run, and
    /// prints that run, or the names of all files, as was asked for, and opens what was made where
    /// that was.
    void finish(nlohmann::ordered_json head, const Console& console);

  private:
    void draw_sheet();
    /// Takes over a picture that a shard has drawn, from the folder of its pictures.
    void take_picture(const nlohmann::ordered_json& picture, const std::filesystem::path& from);
    /// A file of that picture.
    void take_file(const std::string& name, const std::filesystem::path& from);
    std::string written_list() const;
    /// Of the picture that the overlay belongs to.
    void write_svg(const std::string& name, const render::Picture& picture);
    /// What --terminal shows.
    std::vector<std::filesystem::path> to_show() const;
    /// What a user wants to see first: the page, the video, the sheet, the only picture, or the
    /// folder.
    std::filesystem::path to_open(bool with_video) const;
    /// Where a file of that name goes; throws where it must not.
    std::filesystem::path place(const std::string& name) const;
    /// The same for a picture, of which the index says nothing until the end.
    std::filesystem::path place_picture(const std::string& name);

    const PictureOptions& options_;
    render::Context context_;
    render::Renderer renderer_;
    std::filesystem::path folder_;
    FolderIndex index_;
    render::EncodeQueue queue_;
    std::unique_ptr<render::Animation> video_;  ///< or null
    std::optional<SheetRun> sheet_;
    render::OverlayShapes shapes_;  ///< of the overlay, where pictures are wanted as SVG too
    render::Overlay overlay_;
    std::vector<std::string> written_;
    std::string said_;
    std::optional<std::string> instead_;
    std::optional<render::Image> sheet_view_;  ///< of the picture that comes next
    render::IdImage last_ids_;                 ///< kept where a pixel is to be picked
    nlohmann::ordered_json files_ = nlohmann::ordered_json::array();
    Parts parts_;
    std::size_t next_part_ = 0;
    nlohmann::ordered_json pictures_ = nlohmann::ordered_json::array();  ///< of a shard's part
    std::vector<std::string> cells_;  ///< files with a shard's views for the sheet
};

}  // namespace scb::app

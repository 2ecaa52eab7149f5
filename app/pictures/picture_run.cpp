#include "app/pictures/picture_run.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "app/cli/open_file.h"
#include "app/cli/version.h"
#include "app/pictures/plot_file.h"
#include "core/base/text_format.h"
#include "core/platform/file_bytes.h"
#include "core/platform/input_files.h"
#include "core/platform/output_file.h"
#include "render/files/image_file.h"
#include "render/overlay/overlay_shape.h"
#include "scb/error.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

/// The picture of a shard. Throws InputError if it has another size.
render::Image picture_of(const std::filesystem::path& file, int width, int height) {
    render::Image image = render::read_png(file);
    if (image.width != width || image.height != height)
        throw InputError(file.string() +
                         ": the picture is of another size than the shard's; make "
                         "this shard again.");
    return image;
}

/// Changes the green of volumes and meshes by 1 of 255 (up, or down from 255).
void shift_colors(render::Pane& pane) {
    const auto shift = [](render::Rgba8& color) {
        color.g = static_cast<std::uint8_t>(color.g < 255 ? color.g + 1 : color.g - 1);
    };
    for (render::VolumeInstance& volume : pane.volumes) shift(volume.color);
    for (render::MeshDraw& mesh : pane.meshes) {
        shift(mesh.color);
        for (render::Rgba8& color : mesh.triangle_colors) shift(color);
    }
}

/// The picture with a deliberate, invisible error for `scb golden selftest`.
render::Picture shifted_colors(render::Picture picture) {
    for (render::Pane& pane : picture.panes)
        pane.add_contents = [add = std::move(pane.add_contents)](render::Pane& drawn) {
            if (add) add(drawn);
            shift_colors(drawn);
        };
    return picture;
}

}  // namespace

PictureRun::PictureRun(const PictureOptions& options, const std::string& scene,
                       const std::vector<std::string>& tables)
    : options_(options),
      context_(options.backend()),
      renderer_(context_),
      folder_(options.output_folder()),
      queue_(8, options.jobs()) {
    if (!options.names_file()) index_.emplace(place("index.json"));
    queue_.set_texts(picture_texts(options, scene));
    if (options.svg) overlay_.note_in(&shapes_);
    for (const std::string& name : tables) place(name);
    for (const std::string& name : tables) {
        std::error_code ignored;
        const std::filesystem::path path = folder_ / name;
        if (!std::filesystem::is_directory(path, ignored)) std::filesystem::remove(path, ignored);
    }
    if (options.video.wanted() && !options.shards.is_shard())
        video_ = render::animation_file(options.video.file, options.width(), options.height(),
                                        options.video.rate(), options.theme()->background);
}

void PictureRun::plan(std::size_t parts, const Parts::Subject& subject) {
    const render::GlInfo info = context_.info();
    Json versions = versions_json(&info);
    // It also names the processor's vector instructions, which do not affect pictures.
    versions.erase("gl");
    parts_ = Parts(options_.shards, parts, std::move(versions), subject, folder_);
    if (is_shard()) make_shards_folder(folder_);
}

bool PictureRun::part(const std::function<Drawn()>& draw,
                      const std::function<void(const Json&)>& take) {
    const std::size_t k = next_part_++;
    if (parts_.are_merged()) {
        parts_.read(k, [&](const Json& made, const std::filesystem::path& folder) {
            for (const Json& picture : made.at("pictures")) take_picture(picture, folder);
            said_ += made.at("said").get<std::string>();
            take(made.at("drawn"));
        });
        return true;
    }
    if (!parts_.is_made_here(k)) return true;
    Drawn drawn = draw();
    if (!drawn) return false;
    if (!is_shard()) {
        take(*drawn);
        return true;
    }
    parts_.keep(k, {{"pictures", std::exchange(pictures_, Json::array())},
                    {"said", std::exchange(said_, "")},
                    {"drawn", std::move(*drawn)}});
    return true;
}

void PictureRun::take_picture(const Json& picture, const std::filesystem::path& from) {
    const Json& entry = picture.at("entry");
    for (const char* kind : {"file", "svg", "ids"}) {
        if (!entry.contains(kind)) continue;
        const std::string name = entry[kind].get<std::string>();
        const char* const ending = kind == std::string_view("svg") ? ".svg" : ".png";
        if (std::filesystem::path(name).filename() != name || !name.ends_with(ending))
            throw InputError((from / name).string() + ": a picture has the name of a file alone, " +
                             ending + " at its end; make this shard again.");
        take_file(name, from / name);
    }
    const std::string name = entry.at("file").get<std::string>();
    if (video_) video_->push(picture_of(from / name, options_.width(), options_.height()));
    if (sheet_) {
        const render::FrameSheetLayout& layout = sheet_->sheet.layout;
        sheet_->explain(picture.at("explanation"));
        sheet_->add(picture_of(shards_folder(from) / name, layout.view_width, layout.view_height),
                    entry);
    }
    files_.push_back(entry);
}

void PictureRun::take_file(const std::string& name, const std::filesystem::path& from) {
    const std::filesystem::path to = place_picture(name);
    std::error_code ignored;
    if (!std::filesystem::equivalent(from, to, ignored))
        write_file_whole(to, std::string_view(file_bytes(from.string())));
    written_.push_back(name);
}

void PictureRun::explain(const std::string& title, const std::vector<render::PanelItem>& panel) {
    if (!sheet_) return;
    sheet_->explain(title, panel);
}

void PictureRun::explain(const render::SceneFigure& figure) {
    if (!sheet_) return;
    explain(figure.title, figure.panel);
    const render::FrameSheetLayout& layout = sheet_->sheet.layout;
    const render::Picture view =
        render::compose_view(figure, layout.view_width, layout.view_height,
                             render::small_size(layout.unit), options_.samples, overlay_);
    sheet_view_ =
        renderer_.draw(options_.shift_color ? shifted_colors(view) : view, &overlay_).image;
}

void PictureRun::draw(const std::string& usual_name, const render::Picture& picture, Json entry,
                      bool of_sequence) {
    const std::string name = options_.picture_stem(usual_name);
    const bool with_ids = (options_.ids || options_.pick) && of_sequence;
    render::Rendering rendering = options_.shift_color
                                      ? renderer_.draw(shifted_colors(picture), &overlay_, with_ids)
                                      : renderer_.draw(picture, &overlay_, with_ids);
    Json files = {{"file", name + ".png"}};
    Json picture_of_shard;
    if (video_ && of_sequence) video_->push(rendering.image);
    if (sheet_ && of_sequence) {
        render::Image view =
            sheet_view_ ? std::move(*sheet_view_) : sheet_->shrunk(rendering.image);
        sheet_view_.reset();
        if (is_shard()) {
            picture_of_shard["explanation"] = sheet_->explanation();
            // Each picture has its own explanation; `scb merge` joins them.
            sheet_->sheet.keys.clear();
            sheet_->sheet.scale.reset();
            const std::filesystem::path cell = shards_folder("") / (name + ".png");
            queue_.push(folder_ / cell, std::move(view));
            cells_.push_back(cell.string());
        } else {
            sheet_->add(std::move(view), entry);
        }
    }
    queue_.push(place_picture(name + ".png"), std::move(rendering.image));
    written_.push_back(name + ".png");
    if (options_.svg) {
        write_svg(name + ".svg", picture);
        files["svg"] = name + ".svg";
    }
    if (rendering.ids && options_.pick) last_ids_ = *rendering.ids;
    if (rendering.ids && options_.ids) {
        files["ids"] = name + "_ids.png";
        queue_.push(place(name + "_ids.png"), std::move(*rendering.ids));
        written_.push_back(name + "_ids.png");
    }
    files.update(entry);
    if (is_shard()) {
        picture_of_shard["entry"] = std::move(files);
        pictures_.push_back(std::move(picture_of_shard));
    } else {
        files_.push_back(std::move(files));
    }
}

void PictureRun::write_svg(const std::string& name, const render::Picture& picture) {
    const std::optional<render::Image> views =
        picture.panes.empty() ? std::nullopt : std::optional(renderer_.draw(picture).image);
    write(name, render::svg_text(shapes_, picture, views ? &*views : nullptr));
}

std::uint32_t PictureRun::id_at(int x, int y) const { return render::pixel(last_ids_, x, y); }

std::filesystem::path PictureRun::place(const std::string& name) const {
    const std::filesystem::path path = folder_ / name;
    refuse_input(path, "-o " + options_.output);
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path, ignored);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
        !std::filesystem::is_directory(status))
        throw OutputError(
            path.string() +
            ": there is something of that name that is not a file; remove it, or name "
            "another folder with -o.");
    return path;
}

std::filesystem::path PictureRun::place_picture(const std::string& name) {
    std::filesystem::path path = place(name);
    if (index_) index_->about_to_write(name);
    return path;
}

void PictureRun::write(const std::string& name, const std::string& text) {
    write_file_whole(place(name), text);
    written_.push_back(name);
}

void PictureRun::draw_sheet() {
    const std::string file = sheet_->name + ".png";
    queue_.push(place_picture(file), render::draw(sheet_->sheet, renderer_, overlay_));
    written_.push_back(file);
    files_.push_back({{"file", file}, {"sheet", true}});
}

std::filesystem::path PictureRun::to_open(bool with_video) const {
    for (const std::string& name : written_)
        if (name.ends_with(".html")) return folder_ / name;
    if (with_video) return options_.video.file;
    for (const Json& file : files_)
        if (file.contains("sheet") || files_.size() == 1)
            return folder_ / file["file"].get<std::string>();
    return folder_;
}

std::vector<std::filesystem::path> PictureRun::to_show() const {
    // If there is a sheet, show it in place of its pictures.
    const bool has_sheet = std::any_of(files_.begin(), files_.end(),
                                       [](const Json& file) { return file.contains("sheet"); });
    std::vector<std::filesystem::path> files;
    for (const Json& file : files_)
        if (!has_sheet || file.contains("sheet"))
            files.push_back(folder_ / file["file"].get<std::string>());
    return files;
}

void PictureRun::finish_shard(const Console& console) {
    queue_.finish();
    if (options_.video.wanted())
        console.note("scb: --video: a shard has no video; give the option to `scb merge`.");
    std::vector<std::string> files = written_;
    files.insert(files.end(), cells_.begin(), cells_.end());
    const std::filesystem::path file = parts_.write(files);
    print_result(written_list() + file.string() + "\n");
}

std::string PictureRun::written_list() const {
    std::string list;
    for (const std::string& name : written_) list += (folder_ / name).string() + "\n";
    return list;
}

void PictureRun::write_index(const Json& head, const Console& console) {
    if (const std::size_t replaced = index_->write(head); replaced > 0)
        console.note("scb: " + counted(replaced, "picture", "pictures") + " of another run in " +
                     folder_.string() + (replaced == 1 ? " was" : " were") +
                     " replaced; give each run a folder of its own with -o to keep both.");
    written_.push_back("index.json");
}

void PictureRun::finish(Json head, const Console& console) {
    if (sheet_ && !sheet_->sheet.cells.empty()) draw_sheet();
    queue_.finish();
    const bool with_video = video_ && video_->frames() > 0;
    if (with_video) {
        video_->finish();
        head["video"] = {{"fps", options_.video.rate()}, {"frames", video_->frames()}};
    }
    const render::GlInfo info = context_.info();
    head["versions"] = versions_json(&info);
    head["files"] = files_;
    if (index_) write_index(head, console);
    std::string list = written_list();
    if (with_video) list += options_.video.file + "\n";
    print_result(instead_ ? *instead_ : options_.json ? index_text(head) : said_ + list);
    if (options_.show) show_pictures(to_show(), console);
    if (options_.open) open_file(to_open(with_video), console);
}

}  // namespace scb::app

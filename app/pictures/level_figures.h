#pragma once

#include <vector>

#include "app/pictures/level_options.h"
#include "app/study/level_trees.h"
#include "render/draw/renderer.h"
#include "render/figures/level_figure.h"

namespace scb::app {

/// "level 7", "leaves".
std::string level_title(int level);

/// The pictures of a run of `scb render levels`, with one camera and one scale for all.
class LevelFigures {
  public:
    /// Uploads the meshes to the GPU, if they are drawn. The subject must outlive this object.
    LevelFigures(const LevelOptions& options, const LevelSubject& subject,
                 render::Renderer& renderer);
    LevelFigures(const LevelFigures&) = delete;  // figures refer to this

    /// The figure of the subject's trees with index `kind`, at a level.
    render::LevelFigure figure(std::size_t kind, int level) const;

    /// A figure without titles, bodies and level.
    const render::LevelFigure& common() const { return common_; }
    const scenes::CameraView& wish() const { return wish_; }
    /// The bodies with the trees of index `kind`.
    const std::vector<render::LevelBody>& bodies(std::size_t kind) const { return bodies_[kind]; }
    /// The support of all drawn parts at these levels, over all trees.
    render::Support support_of(const std::vector<int>& levels) const;
    /// The same for all levels of the subject.
    const render::Support& support() const { return support_; }

  private:
    const LevelSubject& subject_;
    scenes::CameraView wish_;
    std::vector<std::vector<render::LevelBody>> bodies_;  ///< per kind
    render::Support support_;
    render::LevelFigure common_;
};

}  // namespace scb::app

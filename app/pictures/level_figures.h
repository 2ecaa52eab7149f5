#pragma once

#include <vector>

#include "app/pictures/level_options.h"
#include "app/query/level_trees.h"
#include "render/draw/renderer.h"
#include "render/figures/level_figure.h"

namespace scb::app {

/// "level 7", "leaves".
std::string level_title(int level);

/// What the pictures of a run of `scb render levels` have in common, and each of them: one camera
/// and one scale for all.
class LevelFigures {
  public:
    /// Takes the meshes to the GPU, where they are to be drawn. The subject must outlive this.
    LevelFigures(const LevelOptions& options, const LevelSubject& subject,
                 render::Renderer& renderer);

    /// The figure of the subject's trees of that place at a level.
    render::LevelFigure figure(std::size_t kind, int level) const;

    /// All but titles, bodies and level.
    const render::LevelFigure& common() const { return common_; }
    const scenes::CameraView& wish() const { return wish_; }
    /// The bodies with trees of that place.
    const std::vector<render::LevelBody>& bodies(std::size_t kind) const { return bodies_[kind]; }
    /// The support of what these levels show of all trees.
    render::Support support_of(const std::vector<int>& levels) const;
    /// The same of all the subject's levels.
    const render::Support& support() const { return support_; }

  private:
    const LevelSubject& subject_;
    scenes::CameraView wish_;
    std::vector<std::vector<render::LevelBody>> bodies_;  ///< per kind
    render::Support support_;
    render::LevelFigure common_;
};

}  // namespace scb::app

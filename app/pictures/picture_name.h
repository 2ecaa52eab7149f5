#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/pictures/picture_options.h"
#include "app/study/query_sources.h"

namespace scb::app {

/// The options of a picture, for file names: "_test-extents_by-share". Only options that differ
/// from the default are named. So pictures drawn with different options never have the same name,
/// and usual names are short.
class NamedOptions {
  public:
    /// An option; a flag has no value.
    void add(const std::string& option, const std::string& value = "");
    void add_if(bool differs, const std::string& option, const std::string& value = "") {
        if (differs) add(option, value);
    }
    /// These options, then the others.
    NamedOptions operator+(const NamedOptions& others) const;
    /// Empty if all options are the default. A hash replaces the rest of a long text.
    std::string text() const;

  private:
    std::string text_;
};

/// How hierarchies are built.
void name_build(NamedOptions& named, const BuildOptions& options);
/// The pose of the second of two meshes, [R|t] row by row; empty: the identity.
void name_pose(NamedOptions& named, const std::vector<double>& pose);
/// The volumes of such queries in file names: "scb"; for another engine its name.
std::string volume_file_part(const TraceHeader& header);
/// The bodies, if the scene leaves a choice, and the options of a query. For two compared queries,
/// the options that they have in common.
void name_query(NamedOptions& named, const QuerySource& query, const QuerySource& other);
/// Size and background.
void name_picture(NamedOptions& named, const PictureOptions& options);
/// How a scene is looked at.
void name_view(NamedOptions& named, const PictureOptions& options, const CameraOptions& camera);
/// The frames of a picture that shows several; `frames` is ascending.
void name_frames(NamedOptions& named, const std::vector<int>& frames);

/// SCENE_WHAT_OPTIONS_WHICH, without the extension: "spheres-l1_scb_pairs_frame-0250". All names of
/// pictures are made here.
std::string picture_name(const std::string& scene, const std::string& what,
                         const NamedOptions& options, const std::string& which);
/// "frame-0250".
std::string frame_part(int frame);

}  // namespace scb::app

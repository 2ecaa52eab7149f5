#include "tests/peers/peer_plot.h"

#include "render/child_process.h"
#include "render/output_file.h"

namespace scb {

std::string plot_script(std::span<const PeerKind>, std::span<const SceneComparison>) { return {}; }

void run_gnuplot(const std::filesystem::path&, const std::string&) {}

}  // namespace scb

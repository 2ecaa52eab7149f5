#include "tests/peers/peers.h"

#include <algorithm>

#include "scb/error.h"
#include "tests/peers/adapters.h"

namespace scb {
namespace {

/// A library, and its adapter where CMake found it.
struct Library {
    std::string name, package;
    PeerKind (*adapter)() = nullptr;
};

std::vector<Library> libraries() {
    std::vector<Library> all = {{"fcl", "libfcl-dev"},
                                {"bullet", "libbullet-dev"},
                                {"ode", "libode-dev"},
                                {"embree", "libembree-dev"},
                                {"cgal", "libcgal-dev"}};
#ifdef SCB_PEER_FCL
    all[0].adapter = fcl_peer;
#endif
#ifdef SCB_PEER_BULLET
    all[1].adapter = bullet_peer;
#endif
#ifdef SCB_PEER_ODE
    all[2].adapter = ode_peer;
#endif
#ifdef SCB_PEER_EMBREE
    all[3].adapter = embree_peer;
#endif
#ifdef SCB_PEER_CGAL
    all[4].adapter = cgal_peer;
#endif
    return all;
}

/// Behind the name of a layout: its hierarchy is split by cost; its volumes have two slabs.
constexpr std::string_view cost_suffix = "-cost", two_slabs_suffix = "-scb2";

/// Takes the ending from a name that has it.
bool take_suffix(std::string& name, std::string_view suffix) {
    if (!name.ends_with(suffix)) return false;
    name.resize(name.size() - suffix.size());
    return true;
}

std::string known_names() {
    std::string names = reference_name;
    for (const PackedLayout& layout : all_packed_layouts())
        names += ", " + packed_layout_name(layout) + "[-cost][-scb2]";
    for (const Library& library : libraries()) names += ", " + library.name;
    return names;
}

PeerKind peer_of(const std::string& name, int threads) {
    if (name == reference_name) return reference_peer();
    std::string layout_name = name;
    PackedPeerOptions options;
    if (take_suffix(layout_name, two_slabs_suffix)) options.two_slabs = true;
    if (take_suffix(layout_name, cost_suffix)) options.by_cost = true;
    if (const auto layout = packed_layout_of(layout_name)) {
        options.layout = *layout;
        PeerKind kind = packed_peer(options, threads);
        kind.name = name;
        return kind;
    }
    for (const Library& library : libraries()) {
        if (library.name != name) continue;
        if (library.adapter) return library.adapter();
        throw InputError("--peers: this program was built without " + name + "; install " +
                         library.package + " and configure again.");
    }
    throw InputError("--peers: '" + name + "' is no peer; give some of " + known_names() + ".");
}

}  // namespace

std::vector<std::string> default_peers() {
    std::vector<std::string> names = {reference_name, "float8", "quantized8", "quantized8-cost",
                                      "quantized8-cost-scb2"};
    for (const Library& library : libraries())
        if (library.adapter) names.push_back(library.name);
    return names;
}

std::vector<PeerKind> peers_of(std::span<const std::string> names, int threads) {
    std::vector<PeerKind> kinds;
    for (const std::string& name : names) {
        if (std::any_of(kinds.begin(), kinds.end(),
                        [&](const PeerKind& kind) { return kind.name == name; }))
            throw InputError("--peers: " + name + " is given twice; give each peer once.");
        kinds.push_back(peer_of(name, threads));
    }
    return kinds;
}

}  // namespace scb

#include <ode/ode.h>
#include <ode/version.h>

#include <algorithm>
#include <cstdarg>

#include "tests/peers/adapters.h"

namespace scb {
namespace {

/// ODE says on standard error that near contacts may not have become one, in some frames thousands
/// of times, which would count.
void ignore_message(int, const char*, va_list) {}

/// ODE has met an error of its own, after which it would end the program.
struct OdeError {};

[[noreturn]] void stop_query(int, const char*, va_list) { throw OdeError{}; }

/// ODE must be started before anything else is called, once for all.
void start_ode() {
    static const bool started = [] {
        dInitODE2(0);
        dSetMessageHandler(ignore_message);
        dSetDebugHandler(stop_query);
        dAllocateODEDataForThread(static_cast<unsigned int>(dAllocateMaskAll));
        return true;
    }();
    (void)started;
}

/// A mesh as ODE keeps it, and its tree.
class Body {
  public:
    explicit Body(const PeerMesh& mesh) : data_(dGeomTriMeshDataCreate()) {
        for (const auto& t : mesh.triangles) corners_.insert(corners_.end(), t.begin(), t.end());
        dGeomTriMeshDataBuildDouble(data_, mesh.vertices.data(), sizeof mesh.vertices[0],
                                    static_cast<int>(mesh.vertices.size()), corners_.data(),
                                    static_cast<int>(corners_.size()), 3 * sizeof(dTriIndex));
        geometry_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
        dGeomTriMeshSetTriMergeCallback(geometry_, first_of);
    }
    Body(const Body&) = delete;
    Body& operator=(const Body&) = delete;
    ~Body() {
        dGeomDestroy(geometry_);
        dGeomTriMeshDataDestroy(data_);
    }

    dGeomID geometry() const { return geometry_; }

    dGeomID placed(const PeerPose& pose) const {
        dMatrix3 rotation = {};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) rotation[4 * i + j] = pose.rotation[i][j];
        dGeomSetRotation(geometry_, rotation);
        dGeomSetPosition(geometry_, pose.translation[0], pose.translation[1], pose.translation[2]);
        return geometry_;
    }

  private:
    /// Of two contacts that become one, the first's triangle stands for both.
    static int first_of(dGeomID, int first, int) { return first; }

    std::vector<dTriIndex> corners_;
    dTriMeshDataID data_;
    dGeomID geometry_ = nullptr;
};

class OdePeer : public Peer {
  public:
    OdePeer(const PeerMesh& a, const PeerMesh& b, PeerQuery query)
        : a_(a),
          b_(b),
          flags_(query == PeerQuery::first_contact ? static_cast<int>(CONTACTS_UNIMPORTANT) | 1
                                                   : most_contacts) {
        contacts_.resize(most_contacts);
    }

    void query(const PeerPose& a, const PeerPose& b) override {
        try {
            count_ = dCollide(a_.placed(a), b_.placed(b), flags_, contacts_.data(),
                              sizeof(dContactGeom));
        } catch (const OdeError&) {
            count_ = 0;
        }
    }

    std::vector<IndexPair> pairs() const override {
        std::vector<IndexPair> pairs;
        for (int i = 0; i < count_; ++i) {
            const dContactGeom& contact = contacts_[static_cast<std::size_t>(i)];
            const auto first = static_cast<std::uint32_t>(contact.side1),
                       second = static_cast<std::uint32_t>(contact.side2);
            pairs.push_back(contact.g1 == a_.geometry() ? IndexPair{first, second}
                                                        : IndexPair{second, first});
        }
        std::sort(pairs.begin(), pairs.end());
        pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
        return pairs;
    }

  private:
    static constexpr int most_contacts = 0xffff;  // as many as dCollide can be asked for

    Body a_, b_;
    int flags_;  ///< the number of contacts, and flags
    std::vector<dContactGeom> contacts_;
    int count_ = 0;
};

}  // namespace

PeerKind ode_peer() {
    PeerKind kind;
    kind.name = "ode";
    kind.title = "ODE " dODE_VERSION ", OPCODE";
    kind.method =
        "`dCollide` of two triangle meshes, in part in floats. It makes at most 65,535 contact "
        "points, and joins points that are close: pairs are missing. A query that ends in an "
        "internal error of ODE finds none.";
    kind.prepare = [](const PeerMesh& a, const PeerMesh& b, PeerQuery query) {
        start_ode();
        return std::make_unique<OdePeer>(a, b, query);
    };
    return kind;
}

}  // namespace scb

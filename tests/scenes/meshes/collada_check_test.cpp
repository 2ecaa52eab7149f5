#include "scenes/meshes/collada_check.h"

#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

TEST(ColladaCheck, NamesTheListAndTheIndexThatAreWrong) {
    expect_in("a.dae: index 1 of list 2 of <p> is -7", refusal([] {
                  check_collada("<p>0 1 2</p><param/><p> 0 1 </p><p>3 -7</p>", "a.dae");
              }));
}

TEST(ColladaCheck, TakesAListWithoutIndices) {
    check_collada("<p/><p /><p></p><p>0 1 2</p>", "a.dae");
    expect_in("of <p> is x", refusal([] { check_collada("<p/><p>x</p>", "a.dae"); }));
}

}  // namespace
}  // namespace scb::scenes

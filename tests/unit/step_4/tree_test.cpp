// The tree of the hierarchy: all its parts side by side in memory, each where its number says.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "4_partitioning/beyond/hierarchy.h"
#include "hard_scenes.h"

namespace rays::tests {
namespace {

using wide::Child;

/// Three meshes that run through one another with lone triangles, spheres, cones and boxes among them: blocks of one
/// mesh, blocks of many, and whatever a leaf can be.
Scene mixed_scene() {
    return staged(R"(
        #declare R = seed(3);
        #macro Somewhere() <rand(R), rand(R), rand(R)> * 4 #end
        #macro Face() #local P = Somewhere(); triangle { P, P + Somewhere() / 8, P + Somewhere() / 8 } #end
        #declare M = 0;
        #while (M < 3) mesh { #declare I = 0; #while (I < 40 + 300 * M) Face() #declare I = I + 1; #end } #declare M = M + 1; #end
        #declare I = 0;
        #while (I < 60)
            Face() sphere { Somewhere(), 0.1 } cone { Somewhere(), 0.1, Somewhere(), 0.05 }
            box { -0.1, 0.1 rotate Somewhere() * 90 translate Somewhere() }
            #declare I = I + 1;
        #end
    )");
}

void each_leaf(const wide::Tree& tree, Child from, const std::function<void(Child)>& visit) {
    if (from.kind() != Child::Kind::node) return visit(from);
    const wide::Node& node = tree.node(from);
    for (int i = 0; i < wide::kWidth; ++i)
        if (node.lo(0)[i] <= node.hi(0)[i]) each_leaf(tree, node.child[i], visit);
}

TEST(Tree, HoldsEveryPrimitiveOnce) {
    const Scene scene = mixed_scene();
    const wide::Hierarchy hierarchy(scene, wide::kWidth);
    const wide::Tree& tree = hierarchy.tree;
    std::vector<std::uint32_t> found;
    std::vector<int> kinds(5);
    const auto add = [&](const auto& numbers, std::uint32_t count) {
        found.insert(found.end(), numbers, numbers + count);
    };
    each_leaf(tree, tree.root(), [&](Child leaf) {
        ++kinds[static_cast<std::size_t>(leaf.kind())];
        switch (leaf.kind()) {
            case Child::Kind::triangles: return add(tree.triangles(leaf).primitive, tree.triangles(leaf).count);
            case Child::Kind::spheres: return add(tree.spheres(leaf).primitive, tree.spheres(leaf).count);
            case Child::Kind::cones: return add(tree.cones(leaf).around.primitive, tree.cones(leaf).around.count);
            case Child::Kind::list: return add(tree.list(leaf).primitive, tree.list(leaf).count);
            case Child::Kind::node: break;
        }
    });
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found.size(), hierarchy.tester.size());
    for (std::uint32_t i = 0; i < found.size(); ++i) ASSERT_EQ(found[i], i);
    for (const auto kind : {Child::Kind::list, Child::Kind::triangles, Child::Kind::spheres, Child::Kind::cones})
        EXPECT_GT(kinds[static_cast<std::size_t>(kind)], 0) << static_cast<int>(kind);
}

TEST(Tree, KnowsOfFacesWhatTheTesterKnows) {
    const Scene scene = mixed_scene();
    const wide::Hierarchy hierarchy(scene, wide::kWidth);
    const wide::Tree& tree = hierarchy.tree;
    int of_one_mesh = 0, of_many = 0;
    each_leaf(tree, tree.root(), [&](Child leaf) {
        if (leaf.kind() != Child::Kind::triangles) return;
        const wide::TriangleBlock& block = tree.triangles(leaf);
        ++(block.is_of_one_mesh ? of_one_mesh : of_many);
        for (std::uint32_t lane = 0; lane < block.count; ++lane) {
            const auto known = tree.dispatch(block, static_cast<int>(lane));
            const auto& looked_up = hierarchy.tester.dispatch(block.primitive[lane]);
            ASSERT_EQ(known.primitive.object, looked_up.primitive.object);
            ASSERT_EQ(known.primitive.part, looked_up.primitive.part);
            ASSERT_EQ(known.shape, looked_up.shape);
            ASSERT_EQ(known.way, looked_up.way);
            ASSERT_EQ(known.iterated, looked_up.iterated);
            ASSERT_EQ(known.casts, looked_up.casts);
            if (!block.is_of_one_mesh) continue;
            const Mesh::Face& face = scene.meshes[known.shape].faces[known.primitive.part];
            for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(block.position[c][lane], face.position[c]);
        }
    });
    EXPECT_GT(of_one_mesh, 10);
    EXPECT_GT(of_many, 10);
}

}  // namespace
}  // namespace rays::tests

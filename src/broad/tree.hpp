// A binary tree of boxes that follows moving things: the answer to "which boxes overlap this one?".
//
// Leaves carry a caller's key. Insertion descends to the sibling that adds the least perimeter (the surface area
// heuristic in two dimensions, [MacDonald, Booth 1990]); a leaf that moves a little is refitted in place, and every
// refitted node swaps a child with a grandchild where that shortens a perimeter [Kopta et al. 2012], which keeps the
// tree good without rebuilding. The shape depends on the order of calls alone, never on addresses or time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tumble/math.hpp"

namespace tumble {

class AabbTree {
public:
    using Node = std::int32_t;
    static constexpr Node kNone = -1;

    // Adds a leaf and returns its node, which stays the leaf's name until it is removed.
    Node insert(const Aabb& box, std::uint32_t key);
    void remove(Node leaf);

    // Gives a leaf another box: refitted in place if old and new overlap, otherwise inserted anew under the same name.
    void move(Node leaf, const Aabb& box);

    const Aabb& box(Node leaf) const { return at(leaf).box; }
    std::size_t leaf_count() const { return leaf_count_; }

    // Calls visit(key) for each leaf whose box overlaps, in an order that depends on the tree. O(log n + results).
    template <class Visitor>
    void query(const Aabb& box, Visitor&& visit) const {
        search([&](const Aabb& node_box) { return overlaps(node_box, box); }, visit);
    }

    // Calls visit(key) for each leaf for whose box, and the boxes around it, may_hold(box) is true. A box
    // that it refuses holds none that it would take; it may become stricter as leaves are visited.
    template <class MayHold, class Visitor>
    void search(MayHold&& may_hold, Visitor&& visit) const;

    // Sum of the perimeters of the inner nodes: proportional to the expected cost of a query.
    double cost() const;

    // Walks every link and box; throws std::logic_error that names the first one broken.
    void validate() const;

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.nodes_, self.free_, self.root_, self.leaf_count_);
    }

private:
    struct NodeData {
        Aabb box;
        Node parent = kNone;
        Node child[2] = {kNone, kNone};  // both kNone: a leaf
        std::uint32_t key = 0;           // of a leaf

        bool is_leaf() const { return child[0] == kNone; }

        template <class Self, class Visitor>
        static void visit_members(Self& self, Visitor&& visit) {
            visit(self.box, self.parent, self.child, self.key);
        }
    };

    NodeData& at(Node node) { return nodes_[static_cast<std::size_t>(node)]; }
    const NodeData& at(Node node) const { return nodes_[static_cast<std::size_t>(node)]; }

    Node allocate();
    void free(Node node);
    Node best_sibling(const Aabb& box) const;
    void attach(Node leaf);
    void detach(Node leaf);
    void replace_child(Node parent, Node old_child, Node new_child);
    void refit_upwards(Node node);
    void rotate(Node node);
    Node after_subtree(Node node) const;
    std::size_t validate_subtree(Node root) const;

    std::vector<NodeData> nodes_;
    std::vector<Node> free_;
    Node root_ = kNone;
    std::size_t leaf_count_ = 0;
};

// The node that follows a whole subtree in depth-first order: needs no stack, so that a query neither allocates nor
// limits the depth.
inline AabbTree::Node AabbTree::after_subtree(Node node) const {
    while (node != root_) {
        const NodeData& parent = at(at(node).parent);
        if (parent.child[0] == node) return parent.child[1];
        node = at(node).parent;
    }
    return kNone;
}

template <class MayHold, class Visitor>
void AabbTree::search(MayHold&& may_hold, Visitor&& visit) const {
    Node node = root_;
    while (node != kNone) {
        const NodeData& data = at(node);
        const bool hit = may_hold(data.box);
        if (hit && data.is_leaf()) visit(data.key);
        node = hit && !data.is_leaf() ? data.child[0] : after_subtree(node);
    }
}

}  // namespace tumble

// A dynamic bounding volume tree of axis-aligned boxes: it finds the boxes that overlap a given one while boxes move.
//
// Each leaf has a box and the caller's key. Insertion descends to the sibling that adds the least perimeter (the
// surface area heuristic in two dimensions, [MacDonald, Booth 1990]); a leaf that moves a little is refitted in place,
// and every refitted node swaps a child with a grandchild where that shortens a perimeter [Kopta et al. 2012], which
// keeps queries fast without rebuilding. The tree depends on the order of calls alone, never on addresses or time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "debug/check.hpp"
#include "tumble/math.hpp"

namespace tumble {

class AabbTree {
public:
    using Node = std::int32_t;
    static constexpr Node kNone = -1;
    // Two subtrees whose boxes overlap, at least one of them with a marked leaf: the pairs of a leaf of one and a leaf
    // of the other. A subtree with itself: the pairs of its leaves.
    struct NodePair {
        Node first, second;
    };

    // Adds a leaf and returns its node, by which the caller moves and removes it. The key is below 2^31. O(log n).
    Node insert(const Aabb& box, std::uint32_t key);
    void remove(Node leaf);
    void clear();  // keeps the memory

    // Gives a leaf another box: refits it in place if the old and new boxes overlap, otherwise inserts it anew. The
    // node stays the same.
    void move(Node leaf, const Aabb& box);

    // Many leaves move by these four calls, in this order; no other call may come between the first and the last
    // refit(). Several threads may place leaves at the same time, and refit subtrees.
    //
    // Gives a leaf another box. Returns false if that is apart from the old one.
    bool place(Node leaf, const Aabb& box);
    // Lists the nodes above placed leaves, level by level, until at least `parts` subtrees remain, or until the
    // capacity of `nodes` is used up: it allocates nothing. Returns the index of the first that remains: these are to
    // be refitted first, in any order, then those before them from the last to the first.
    std::size_t list_changed(std::size_t parts, std::vector<Node>& nodes) const;
    // Refits each node of a subtree above placed leaves once.
    void refit(Node subtree);
    // For a leaf for which place() was false: inserts it anew if it has also left its sibling. Leaves that fall side by
    // side stay where they are.
    void reinsert_if_apart(Node leaf);

    void prefetch(Node leaf) const { __builtin_prefetch(&at(leaf)); }  // starts to load what place() will read
    const Aabb& box(Node leaf) const { return at(leaf).box; }
    std::size_t leaf_count() const { return leaf_count_; }

    // Calls visit(key) for each leaf whose box overlaps `box`, in an order that depends on the tree. O(log n +
    // results).
    template <class Visitor>
    void query(const Aabb& box, Visitor&& visit) const {
        search([box](const Aabb& node_box) { return overlaps(node_box, box); }, visit);
    }

    // Calls visit(key) for each leaf for which may_contain(box) is true of its own box and of those of its ancestors.
    // may_contain must be monotonic: if it is false for a box, it is false for every box inside. It may become stricter
    // as leaves are visited, as in a search for the nearest.
    template <class MayContain, class Visitor>
    void search(MayContain&& may_contain, Visitor&& visit) const;

    // Marks a leaf for the walks below, or removes its mark. All marks must be removed before a leaf is marked,
    // inserted, moved or removed again. Several threads may mark leaves at the same time, or remove marks.
    void mark(Node leaf);
    void unmark(Node leaf);

    // Calls visit(key, other key) once for each two leaves whose boxes overlap, and of which at least one is marked.
    template <class Visitor>
    void for_each_pair(Visitor&& visit) const {
        if (has_marks()) visit_pairs({root_, root_}, visit);
    }

    // The same walk in two steps, the second of which several threads can share: visit_upper_pairs() stops when
    // `waiting` has at least `parts` pairs of subtrees, or none; visit_pairs() walks one of them.
    template <class Visitor>
    void visit_upper_pairs(std::size_t parts, std::vector<NodePair>& waiting, Visitor&& visit) const;
    template <class Visitor>
    void visit_pairs(NodePair pair, Visitor&& visit) const;

    // Sum of the perimeters of all nodes: proportional to the expected cost of a query.
    double cost() const;

    // Checks every link and box; throws std::logic_error that names the first broken invariant. O(n).
    void audit() const;

    template <class Self, class Visitor>
    static void visit_members(Self& self, Visitor&& visit) {
        visit(self.nodes_, self.free_, self.root_, self.leaf_count_);
    }

private:
    struct NodeData {
        Aabb box;
        Node parent = kNone;
        Node child[2] = {kNone, kNone};  // both kNone: a leaf
        std::uint32_t tag = 0;           // the key of a leaf; kMark is added while the subtree has a marked leaf

        bool is_leaf() const { return child[0] == kNone; }
        bool is_marked() const { return has_mark(tag); }
        std::uint32_t key() const { return tag & ~kMark; }

        template <class Self, class Visitor>
        static void visit_members(Self& self, Visitor&& visit) {
            visit(self.box, self.parent, self.child, self.tag);
        }
    };

    static constexpr int kStackSize = 64;
    static constexpr std::uint32_t kMark = 1u << 31;
    static bool has_mark(std::uint32_t tag) { return (tag & kMark) != 0; }

    NodeData& at(Node node) {
        TUMBLE_CHECK(static_cast<std::size_t>(node) < nodes_.size());
        return nodes_[static_cast<std::size_t>(node)];
    }
    const NodeData& at(Node node) const {
        TUMBLE_CHECK(static_cast<std::size_t>(node) < nodes_.size());
        return nodes_[static_cast<std::size_t>(node)];
    }

    Node allocate();
    void free(Node node);
    void set_mark(Node leaf, bool value);
    Node best_sibling(const Aabb& box) const;
    void attach(Node leaf);
    void detach(Node leaf);
    void replace_child(Node parent, Node old_child, Node new_child);
    void refit_upwards(Node node);
    void refit_node(Node node);
    void rotate(Node node);
    template <class MayContain, class Visitor>
    void search_subtree(Node root, MayContain& may_contain, Visitor& visit) const;
    template <class Add, class Visitor>
    void split(NodePair pair, Add&& add, Visitor& visit) const;
    std::size_t audit_subtree(Node root) const;
    bool has_marks() const { return root_ != kNone && at(root_).is_marked(); }

    std::vector<NodeData> nodes_;
    std::vector<Node> free_;
    Node root_ = kNone;
    std::size_t leaf_count_ = 0;
};

template <class MayContain, class Visitor>
void AabbTree::search(MayContain&& may_contain, Visitor&& visit) const {
    if (root_ != kNone) search_subtree(root_, may_contain, visit);
}

// Depth first, left before right, with a stack of fixed size. If the stack is full, a recursive call with a stack of
// its own searches the subtree: the depth is not limited, and nothing is allocated.
template <class MayContain, class Visitor>
void AabbTree::search_subtree(Node root, MayContain& may_contain, Visitor& visit) const {
    Node waiting[kStackSize];  // not initialized: setting all of it takes longer than a search of a few nodes
    waiting[0] = root;
    for (int count = 1; count > 0;) {
        TUMBLE_CHECK(count <= kStackSize);
        const NodeData& node = at(waiting[--count]);
        if (!may_contain(node.box)) continue;
        if (node.is_leaf()) {
            visit(node.key());
        } else if (count + 2 <= kStackSize) {
            waiting[count++] = node.child[1];
            waiting[count++] = node.child[0];
        } else {
            for (const Node child : node.child) search_subtree(child, may_contain, visit);
        }
    }
}

// Level by level, so that the parts are of similar size.
template <class Visitor>
void AabbTree::visit_upper_pairs(std::size_t parts, std::vector<NodePair>& waiting, Visitor&& visit) const {
    TUMBLE_CHECK(parts >= 1u);
    waiting.clear();
    if (has_marks()) waiting.push_back({root_, root_});
    std::vector<NodePair> level;
    while (!waiting.empty() && waiting.size() < parts) {
        level.swap(waiting);
        waiting.clear();
        const auto add = [&waiting](NodePair pair, int is_needed) {
            if (is_needed) waiting.push_back(pair);
        };
        for (const NodePair& pair : level) split(pair, add, visit);
    }
}

// A stack of fixed size, as in search_subtree().
template <class Visitor>
void AabbTree::visit_pairs(NodePair pair, Visitor&& visit) const {
    constexpr int kMostParts = 3;
    Node first[kStackSize],
        second[kStackSize];  // two arrays: the load of a pair would wait for the stores of its halves
    first[0] = pair.first;
    second[0] = pair.second;
    int count = 1;
    const auto add = [&](NodePair part, int is_needed) {
        TUMBLE_CHECK(count < kStackSize);
        first[count] = part.first;
        second[count] = part.second;
        count += is_needed;
    };
    while (count > 0) {
        --count;
        const NodePair next{first[count], second[count]};
        if (count + kMostParts <= kStackSize) {
            split(next, add, visit);
        } else {
            split(
                next,
                [&](NodePair part, int is_needed) {
                    if (is_needed) visit_pairs(part, visit);
                },
                visit);
        }
    }
}

// Visits the pair if both are leaves. Otherwise calls add(part, is_needed) for each part: `is_needed` is false if the
// boxes of the part are apart, or neither of its subtrees has a marked leaf. Both are asked for without a branch, which
// is mispredicted: it takes 7 % more of the time where all leaves are marked.
template <class Add, class Visitor>
void AabbTree::split(NodePair pair, Add&& add, Visitor& visit) const {
    const NodeData& a = at(pair.first);
    const NodeData& b = at(pair.second);
    if (pair.first == pair.second) {
        if (a.is_leaf()) return;
        const NodeData &left = at(a.child[0]), &right = at(a.child[1]);
        add({a.child[0], a.child[0]}, left.is_marked());
        add({a.child[1], a.child[1]}, right.is_marked());
        add({a.child[0], a.child[1]}, int{has_mark(left.tag | right.tag)} & int{overlaps(left.box, right.box)});
    } else if (a.is_leaf() && b.is_leaf()) {
        visit(a.key(), b.key());
    } else {
        const bool into_first = b.is_leaf() || (!a.is_leaf() && perimeter(a.box) > perimeter(b.box));  // the larger
        const NodeData& divided = into_first ? a : b;
        const Node whole = into_first ? pair.second : pair.first;
        const Aabb box = into_first ? b.box : a.box;
        const std::uint32_t tag = into_first ? b.tag : a.tag;
        for (const Node child : divided.child)
            add({child, whole}, int{has_mark(tag | at(child).tag)} & int{overlaps(at(child).box, box)});
    }
}

}  // namespace tumble

#include "broad/tree.hpp"

#include <atomic>
#include <stdexcept>
#include <string>

namespace tumble {

namespace {

void require(bool holds, const char* invariant, AabbTree::Node node) {
    if (!holds) throw std::logic_error("AABB tree: node " + std::to_string(node) + ": " + invariant);
}

}  // namespace

AabbTree::Node AabbTree::allocate() {
    if (free_.empty()) {
        nodes_.emplace_back();
        free_.reserve(nodes_.capacity());
        return static_cast<Node>(nodes_.size()) - 1;
    }
    const Node node = free_.back();
    free_.pop_back();
    at(node) = NodeData{};
    return node;
}

void AabbTree::free(Node node) { free_.push_back(node); }

AabbTree::Node AabbTree::insert(const Aabb& box, std::uint32_t key) {
    TUMBLE_CHECK(key < kMark);
    TUMBLE_CHECK(!has_marks());
    TUMBLE_CHECK(box.lower.x <= box.upper.x);
    TUMBLE_CHECK(box.lower.y <= box.upper.y);
    const Node leaf = allocate();
    at(leaf).box = box;
    at(leaf).tag = key;
    attach(leaf);
    ++leaf_count_;
    return leaf;
}

void AabbTree::clear() {
    nodes_.clear();
    free_.clear();
    root_ = kNone;
    leaf_count_ = 0;
}

void AabbTree::remove(Node leaf) {
    TUMBLE_CHECK(at(leaf).is_leaf());
    TUMBLE_CHECK(leaf_count_ > 0);
    detach(leaf);
    free(leaf);
    --leaf_count_;
}

void AabbTree::move(Node leaf, const Aabb& box) {
    TUMBLE_CHECK(!has_marks());
    TUMBLE_CHECK(at(leaf).is_leaf());
    TUMBLE_CHECK(box.lower.x <= box.upper.x);
    TUMBLE_CHECK(box.lower.y <= box.upper.y);
    if (overlaps(at(leaf).box, box)) {
        at(leaf).box = box;
        refit_upwards(at(leaf).parent);
        return;
    }
    detach(leaf);
    at(leaf).box = box;
    attach(leaf);
}

// A leaf has left its sibling if the perimeter of their parent's box is longer than the sum of theirs. Without this
// test, insertions would take 40 % of the time for boxes in bench/rain and in bench/spinner.
void AabbTree::reinsert_if_apart(Node leaf) {
    TUMBLE_CHECK(!has_marks());
    const Node parent = at(leaf).parent;
    if (parent == kNone) return;
    const Aabb &first = at(at(parent).child[0]).box, &second = at(at(parent).child[1]).box;
    if (perimeter(at(parent).box) <= perimeter(first) + perimeter(second)) return;
    detach(leaf);
    attach(leaf);
}

bool AabbTree::place(Node leaf, const Aabb& box) {
    TUMBLE_CHECK(at(leaf).is_leaf());
    TUMBLE_CHECK(!at(leaf).is_marked());
    TUMBLE_CHECK(box.lower.x <= box.upper.x);
    TUMBLE_CHECK(box.lower.y <= box.upper.y);
    const bool stays = overlaps(at(leaf).box, box);
    at(leaf).box = box;
    mark(leaf);
    return stays;
}

std::size_t AabbTree::list_changed(std::size_t parts, std::vector<Node>& nodes) const {
    TUMBLE_CHECK(nodes.capacity() >= 1u);
    nodes.clear();
    if (has_marks()) nodes.push_back(root_);
    std::size_t first = 0;
    while (first < nodes.size() && nodes.size() - first < parts && nodes.size() + 2 <= nodes.capacity()) {
        const NodeData& node = at(nodes[first++]);
        if (node.is_leaf()) continue;
        for (const Node child : node.child)
            if (at(child).is_marked()) nodes.push_back(child);
    }
    return first;
}

// Walks the marked nodes, children before parents, and removes their marks.
void AabbTree::refit(Node subtree) {
    TUMBLE_CHECK(at(subtree).is_marked());
    const Node above = at(subtree).parent;
    for (Node node = subtree; node != above;) {
        NodeData& data = at(node);
        const auto is_marked = [&](Node child) { return child != kNone && at(child).is_marked(); };
        if (is_marked(data.child[0])) {
            node = data.child[0];
        } else if (is_marked(data.child[1])) {
            node = data.child[1];
        } else {
            data.tag &= ~kMark;
            if (!data.is_leaf()) refit_node(node);
            node = data.parent;
        }
    }
}

void AabbTree::mark(Node leaf) { set_mark(leaf, true); }
void AabbTree::unmark(Node leaf) { set_mark(leaf, false); }

// Ends at a node that has the value: the thread that has set it goes on to the root. Nothing but marks changes
// meanwhile, so that two threads write the same tag.
void AabbTree::set_mark(Node leaf, bool value) {
    for (Node node = leaf; node != kNone; node = at(node).parent) {
        const std::atomic_ref<std::uint32_t> shared(at(node).tag);
        const std::uint32_t tag = shared.load(std::memory_order_relaxed);
        if (has_mark(tag) == value) return;
        shared.store(tag ^ kMark, std::memory_order_relaxed);
    }
}

// Greedy descent. Making the new leaf the sibling of `node` adds a parent of the merged perimeter. Descending to a
// child adds the growth of the node, and at least the growth of the child (or the merged perimeter, if the child is a
// leaf).
AabbTree::Node AabbTree::best_sibling(const Aabb& box) const {
    Node node = root_;
    while (!at(node).is_leaf()) {
        const float merged = perimeter(merge(at(node).box, box));
        const float growth = merged - perimeter(at(node).box);
        Node next = kNone;
        float least = merged;
        for (const Node child : at(node).child) {
            float cost = growth + perimeter(merge(at(child).box, box));
            if (!at(child).is_leaf()) cost -= perimeter(at(child).box);
            if (cost < least) {
                least = cost;
                next = child;
            }
        }
        if (next == kNone) break;
        node = next;
    }
    return node;
}

void AabbTree::attach(Node leaf) {
    if (root_ == kNone) {
        root_ = leaf;
        at(leaf).parent = kNone;
        return;
    }
    const Node sibling = best_sibling(at(leaf).box);
    const Node parent = allocate();
    const Node grandparent = at(sibling).parent;
    at(parent).parent = grandparent;
    at(parent).child[0] = sibling;
    at(parent).child[1] = leaf;
    at(parent).box = merge(at(sibling).box, at(leaf).box);
    at(sibling).parent = parent;
    at(leaf).parent = parent;
    replace_child(grandparent, sibling, parent);
    refit_upwards(grandparent);
}

void AabbTree::detach(Node leaf) {
    const Node parent = at(leaf).parent;
    if (parent == kNone) {
        TUMBLE_CHECK(root_ == leaf);
        root_ = kNone;
        return;
    }
    TUMBLE_CHECK((at(parent).child[0] == leaf || at(parent).child[1] == leaf));
    const Node sibling = at(parent).child[at(parent).child[0] == leaf ? 1 : 0];
    const Node grandparent = at(parent).parent;
    at(sibling).parent = grandparent;
    replace_child(grandparent, parent, sibling);
    free(parent);
    refit_upwards(grandparent);
}

void AabbTree::replace_child(Node parent, Node old_child, Node new_child) {
    if (parent == kNone) {
        root_ = new_child;
    } else {
        at(parent).child[at(parent).child[0] == old_child ? 0 : 1] = new_child;
    }
}

// Recomputes the boxes of a node and its ancestors, up to the first that does not change.
void AabbTree::refit_upwards(Node node) {
    while (node != kNone) {
        const Aabb before = at(node).box;
        refit_node(node);
        if (at(node).box == before) return;
        node = at(node).parent;
    }
}

void AabbTree::refit_node(Node node) {
    at(node).box = merge(at(at(node).child[0]).box, at(at(node).child[1]).box);
    rotate(node);
}

// Swaps a child with the child of its sibling that shortens the sibling's perimeter the most, if any does. The node's
// own box does not change.
void AabbTree::rotate(Node node) {
    float best_gain = 0.0f;
    int best_side = 0, best_grandchild = 0;
    for (int side = 0; side < 2; ++side) {
        const Node mover = at(node).child[side];
        const Node sibling = at(node).child[1 - side];
        if (at(sibling).is_leaf()) continue;
        for (int grandchild = 0; grandchild < 2; ++grandchild) {
            const Node stays = at(sibling).child[1 - grandchild];
            const float gain = perimeter(at(sibling).box) - perimeter(merge(at(mover).box, at(stays).box));
            if (gain > best_gain) {
                best_gain = gain;
                best_side = side;
                best_grandchild = grandchild;
            }
        }
    }
    if (!(best_gain > 0.0f)) return;
    const Node mover = at(node).child[best_side];
    const Node sibling = at(node).child[1 - best_side];
    const Node rises = at(sibling).child[best_grandchild];
    at(node).child[best_side] = rises;
    at(rises).parent = node;
    at(sibling).child[best_grandchild] = mover;
    at(mover).parent = sibling;
    at(sibling).box = merge(at(at(sibling).child[0]).box, at(at(sibling).child[1]).box);
}

double AabbTree::cost() const {
    double sum = 0.0;
    const auto add = [&sum](const Aabb& box) {
        sum += static_cast<double>(perimeter(box));
        return true;
    };
    search(add, [](std::uint32_t) {});
    return sum;
}

void AabbTree::audit() const {
    const std::size_t live = root_ == kNone ? 0 : audit_subtree(root_);
    if (root_ != kNone) require(at(root_).parent == kNone, "the root has a parent", root_);
    require(leaf_count_ == (live + 1) / 2, "the leaf count differs from the number of leaves", root_);
    require(live + free_.size() == nodes_.size(), "some nodes are neither in the tree nor free", root_);
}

// The number of nodes below and with `root`. Depth first with an explicit stack: a broken link cannot overflow it.
std::size_t AabbTree::audit_subtree(Node root) const {
    std::vector<Node> stack{root};
    std::size_t count = 0;
    while (!stack.empty()) {
        const Node node = stack.back();
        stack.pop_back();
        require(node >= 0 && static_cast<std::size_t>(node) < nodes_.size(), "it is out of range", node);
        require(++count <= nodes_.size(), "it is reached twice", node);
        const NodeData& data = at(node);
        require(!data.is_marked(), "it is marked between searches", node);
        if (data.is_leaf()) {
            require(data.child[1] == kNone, "it has one child", node);
            continue;
        }
        for (const Node child : data.child) {
            require(at(child).parent == node, "it is not the parent of its child", node);
            stack.push_back(child);
        }
        require(data.box == merge(at(data.child[0]).box, at(data.child[1]).box),
                "its box is not the union of its children's boxes", node);
    }
    return count;
}

}  // namespace tumble

#include "dynamics/joint_store/joint_blocks.hpp"

#include <bit>

namespace tumble {

namespace {

// Of blocks that share no body. Blocks beyond have a colour each, and no bit.
constexpr std::size_t kMaxSharedColors = 64;

}  // namespace

std::size_t JointBlocks::bytes() const {
    std::size_t bytes = colors_.capacity() * sizeof(std::vector<std::uint32_t>);
    for (const std::vector<std::uint32_t>& color : colors_) bytes += color.capacity() * sizeof(std::uint32_t);
    return bytes + colors_of_.capacity() * sizeof(std::uint64_t);
}

void JointBlocks::begin(std::size_t count, std::size_t body_count) {
    count_ = count;
    for (std::vector<std::uint32_t>& color : colors_) color.clear();
    colors_of_.assign(block_count() > 1 ? body_count + 1 : 0, 0);
}

std::uint64_t JointBlocks::color_block(std::size_t block, std::uint64_t taken) {
    const auto free = static_cast<std::size_t>(std::countr_one(taken));
    const bool is_shared = free < kMaxSharedColors;
    const std::size_t color = is_shared ? free : std::max(colors_.size(), kMaxSharedColors);
    if (color >= colors_.size()) colors_.resize(color + 1);
    colors_[color].push_back(static_cast<std::uint32_t>(block));
    return is_shared ? std::uint64_t{1} << color : 0;
}

}  // namespace tumble

// Renderers and labellers of the present thread, kept for the sizes that it used last.
#pragma once

#include <cstddef>
#include <list>
#include <utility>

namespace tumble::python {

// The tool for images of a size: a Renderer or a Labeller. A Renderer belongs to its thread, and takes long to make.
template <class Tool>
Tool& tool_of_size(int width, int height) {
    constexpr std::size_t kMostKept = 4;
    static thread_local std::list<std::pair<std::pair<int, int>, Tool>> kept;
    const std::pair size{width, height};
    for (auto entry = kept.begin(); entry != kept.end(); ++entry) {
        if (entry->first != size) continue;
        kept.splice(kept.begin(), kept, entry);
        return entry->second;
    }
    if (kept.size() == kMostKept) kept.pop_back();
    kept.emplace_front(size, Tool(width, height));
    return kept.front().second;
}

}  // namespace tumble::python

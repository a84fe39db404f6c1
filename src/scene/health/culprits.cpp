#include "scene/health/culprits.hpp"

#include <algorithm>

namespace tumble::scene {

void Culprits::append_to(std::vector<HealthFinding>& findings) const {
    std::vector<const Kind*> sorted;
    for (const auto& [sources, kind] : kinds_) sorted.push_back(&kind);
    std::ranges::stable_sort(sorted, std::ranges::greater{}, &Kind::severity);
    sorted.resize(std::min(sorted.size(), kMostHealthFindings));
    for (const Kind* const kind : sorted) {
        findings.push_back(kind->worst);
        findings.back().more_of_a_kind = kind->members.size() - 1;
    }
}

}  // namespace tumble::scene

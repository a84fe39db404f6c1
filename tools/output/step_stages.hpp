// The stages of a step by name, as JSON and pages list them; the last one is the whole step.
#pragma once

#include <array>

#include "tumble/counters.hpp"

namespace tumble::tools {

struct StepStage {
    const char* name;
    double StageTimes::*ms;
};

inline constexpr std::array<StepStage, 9> kStepStages{{{"pairs", &StageTimes::pairs},
                                                       {"collide", &StageTimes::collide},
                                                       {"prepare", &StageTimes::prepare},
                                                       {"solve", &StageTimes::solve},
                                                       {"continuous", &StageTimes::continuous},
                                                       {"proxies", &StageTimes::proxies},
                                                       {"events", &StageTimes::events},
                                                       {"sleep", &StageTimes::sleep},
                                                       {"step", &StageTimes::step}}};

}  // namespace tumble::tools

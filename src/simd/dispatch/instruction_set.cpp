// Chooses the instruction set when the program starts. join.sh makes the tables of functions.
//
// tumble_choose_instruction_set() runs before any static initialisation: it uses no object that has one.
#include "tumble/instruction_set.hpp"

#include <cstdlib>
#include <cstring>

namespace tumble {

namespace {

struct InstructionSet {
    const char* name;
    bool (*is_present)();
};

bool has_baseline() { return true; }

#if defined(TUMBLE_DISPATCH)
bool has_avx2() {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2");
}

bool has_avx512() {
    return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
}

constexpr InstructionSet kSets[] = {{"baseline", has_baseline}, {"avx2", has_avx2}, {"avx512", has_avx512}};
#else
constexpr InstructionSet kSets[] = {{"baseline", has_baseline}};
#endif
constexpr int kSetCount = sizeof kSets / sizeof kSets[0];

int chosen = 0;
char refused[64] = "";  // the value of TUMBLE_SIMD, if it could not be obeyed

int best_set() {
    int best = 0;
    for (int i = 0; i < kSetCount; ++i)
        if (kSets[i].is_present()) best = i;
    return best;
}

// TUMBLE_SIMD, else the best.
int choose_set() {
    const char* const wanted = std::getenv("TUMBLE_SIMD");
    if (wanted == nullptr || *wanted == '\0') return best_set();
    for (int i = 0; i < kSetCount; ++i)
        if (std::strcmp(kSets[i].name, wanted) == 0 && kSets[i].is_present()) return i;
    std::strncpy(refused, wanted, sizeof refused - 1);
    return best_set();
}

}  // namespace

std::string instruction_set() { return kSets[chosen].name; }

std::vector<std::string> instruction_sets() {
    std::vector<std::string> names;
    for (const InstructionSet& set : kSets)
        if (set.is_present()) names.emplace_back(set.name);
    return names;
}

std::string instruction_set_error() {
    if (*refused == '\0') return {};
    for (const InstructionSet& set : kSets)
        if (std::strcmp(set.name, refused) == 0)
            return "TUMBLE_SIMD is '" + std::string(refused) + "', which this processor does not have";
    std::string known;
    for (const InstructionSet& set : kSets) known += (known.empty() ? "" : ", ") + std::string(set.name);
    return "TUMBLE_SIMD is '" + std::string(refused) + "'; this build knows " + known;
}

}  // namespace tumble

#if defined(TUMBLE_DISPATCH)

extern "C" {

extern const void* const tumble_entries_baseline[];
extern const void* const tumble_entries_avx2[];
extern const void* const tumble_entries_avx512[];
extern const unsigned long tumble_entry_count;
extern const void* tumble_entries[];

void tumble_choose_instruction_set() {
    __builtin_cpu_init();
    tumble::chosen = tumble::choose_set();
    const void* const* const tables[] = {tumble_entries_baseline, tumble_entries_avx2, tumble_entries_avx512};
    std::memcpy(tumble_entries, tables[tumble::chosen], tumble_entry_count * sizeof *tumble_entries);
}

}  // extern "C"

#else

namespace {

// In a build for one instruction set nothing depends on the choice, so that it may be made late.
const bool is_chosen = [] { return (tumble::chosen = tumble::choose_set()) >= 0; }();

}  // namespace

#endif
